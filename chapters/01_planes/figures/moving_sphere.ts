// A moving sphere against a plane: shrink the sphere to its centre and move the plane by the radius
// towards it; then a segment is tested against a plane.

import { defineFigure, pretty, type Vec3 } from "@contact/figure";

interface Input {
  normal: Vec3;
  point: Vec3;
  centre: Vec3;
  radius: number;
  displacement: Vec3;
}

interface Output {
  unit_normal: Vec3;
  offset: number;
  start_distance: number;
  start_side: number;
  offset_point: Vec3;
  gap: number;
  closing: number;
  overlap_at_start: number;
  hit: number;
  t: number;
  touch_centre: Vec3;
  contact_point: Vec3;
  contact_normal: Vec3;
  end_centre: Vec3;
  end_depth: number;
  centre_hit: number;
  centre_t: number;
}

const GROUND = -1.9;

export default defineFigure<Input, Output>({
  title: "A moving sphere and a plane",
  view: {
    kind: "3d",
    target: [0.3, 0.4, 0.4],
    azimuth: -68,
    elevation: 14,
    span: 7.2,
    ground: { half: 3.5, z: GROUND, step: 0.5 },
  },
  aspect: 0.98,
  initial: {
    normal: [0.25, 0, 1],
    point: [0.8, 1.2, -0.55],
    centre: [-1.5, 0.2, 2.3],
    radius: 0.7,
    displacement: [3, -0.3, -3.1],
  },
  handles: [
    {
      kind: "point",
      field: "centre",
      label: "c, centre at the start",
      role: "ball",
      limit: [-5, 5],
    },
    {
      kind: "point",
      field: "displacement",
      from: "centre",
      label: "D, displacement in one step",
      role: "ray",
      limit: [-8, 8],
    },
    {
      kind: "point",
      field: "normal",
      from: "point",
      label: "N, normal of the plane",
      role: "normal",
      limit: [-3, 3],
    },
  ],
  controls: [
    { kind: "slider", field: "radius", label: "r", min: 0.1, max: 1.5, step: 0.05 },
    { kind: "numbers", field: "centre", label: "c", role: "ball" },
    { kind: "numbers", field: "displacement", label: "D", role: "ray" },
    { kind: "numbers", field: "normal", label: "N", role: "normal" },
    { kind: "numbers", field: "point", label: "a", role: "surface" },
  ],
  draw(scene, input, output) {
    const { centre, point, normal, radius, displacement } = input;
    const end: Vec3 = [
      centre[0] + displacement[0],
      centre[1] + displacement[1],
      centre[2] + displacement[2],
    ];
    scene.arrow(centre, end, { role: "ray", width: 2.5 });
    if (output.problem) return;
    const tip: Vec3 = [point[0] + normal[0], point[1] + normal[1], point[2] + normal[2]];
    scene.patch(point, output.unit_normal, 2.4, { role: "surface", fill: 0.2, hides: true });
    scene.patch(output.offset_point, output.unit_normal, 2.4, {
      role: "ball",
      fill: 0.05,
      dashed: true,
    });
    scene.arrow(point, tip, { role: "normal", width: 2.5 });
    scene.label(tip, "N", { role: "normal", offset: [14, -6] });
    scene.label(centre, "c", { role: "ball", offset: [-14, -12], anchor: "end" });
    scene.label(end, "c + D", { role: "ray", offset: [14, 16] });

    scene.ball(centre, radius, { role: "ball", fill: 0.22 });
    const up: Vec3 = [0, 0, 1];
    const projection: Vec3 = [centre[0], centre[1], GROUND];
    scene.disc(projection, up, radius, { role: "muted", fill: 0.12, outline: false });
    scene.drop(centre, GROUND);
    scene.ball(output.end_centre, radius, {
      role: output.end_depth > 0 ? "miss" : "muted",
      fill: 0.04,
      dashed: true,
    });
    if (!output.hit) return;
    scene.ball(output.touch_centre, radius, { role: "hit", fill: 0.2 });
    scene.dot(output.touch_centre, "hit", 4);
    scene.line(output.touch_centre, output.contact_point, { role: "hit", width: 2, through: true });
    scene.dot(output.contact_point, "hit", 6);
    scene.label(output.touch_centre, `t = ${pretty(output.t, 3)}`, {
      role: "hit",
      offset: [-12, -2],
      anchor: "end",
    });
    scene.label(output.contact_point, "contact", {
      role: "hit",
      offset: [0, 22],
      anchor: "middle",
    });
  },
  values: (_input, output) => [
    { name: "d", meaning: "n·c − k", value: output.start_distance, role: "ball" },
    { name: "s", meaning: "side of the plane", value: output.start_side, role: "ball" },
    { name: "gap", meaning: "s d − r", value: output.gap },
    { name: "closing", meaning: "−s n·D", value: output.closing, role: "ray" },
    {
      name: "t",
      meaning: "gap / closing",
      value: output.hit ? output.t : "no contact",
      role: output.hit ? "hit" : "miss",
    },
    {
      name: "x",
      meaning: "c + t D − s r n",
      value: output.hit ? output.contact_point : "–",
      role: output.hit ? "hit" : "miss",
    },
    {
      name: "t_c",
      meaning: "the centre alone",
      value: output.centre_hit ? output.centre_t : "never",
      role: "muted",
    },
  ],
  describe(_input, output) {
    if (output.overlap_at_start)
      return "The sphere overlaps the plane at the start, so the contact is at t = 0.";
    if (!output.hit)
      return `The sphere stays clear: the closing distance is ${pretty(output.closing, 3)}, the gap ${pretty(output.gap, 3)}.`;
    const centre = output.centre_hit
      ? `Its centre would reach the plane only at ${pretty(output.centre_t, 3)}.`
      : "Its centre never reaches the plane.";
    return `The sphere touches the plane at ${pretty(output.t, 3)} of the step. ${centre}`;
  },
});
