// A segment against a plane: the distances of its ends are the legs of two similar triangles, and
// their ratio gives the fraction t at which it crosses.

import { defineFigure, pretty, type Role, type Vec3 } from "@contact/figure";

interface Input {
  normal: Vec3;
  point: Vec3;
  start: Vec3;
  end: Vec3;
}

interface Output {
  unit_normal: Vec3;
  offset: number;
  start_distance: number;
  end_distance: number;
  start_side: number;
  end_side: number;
  start_foot: Vec3;
  end_foot: Vec3;
  in_plane: number;
  hit: number;
  t: number;
  meeting: Vec3;
}

const sideRole = (side: number): Role => (side > 0 ? "b" : side < 0 ? "a" : "hit");
const sideWord = (side: number): string => (side > 0 ? "in front of" : side < 0 ? "behind" : "on");

export default defineFigure<Input, Output>({
  title: "A segment and a plane",
  view: {
    kind: "3d",
    target: [0, 0, 0.2],
    azimuth: -62,
    elevation: 16,
    span: 7.4,
    ground: { half: 3.5, z: -2.6, step: 0.5 },
  },
  aspect: 0.98,
  initial: {
    normal: [0.4, -0.1, 1.2],
    point: [0, 0, -0.2],
    start: [-1.4, 0.3, 2.2],
    end: [1.6, -0.2, -1.8],
  },
  handles: [
    {
      kind: "point",
      field: "start",
      label: "p, start of the segment",
      role: "ray",
      limit: [-5, 5],
    },
    { kind: "point", field: "end", label: "q, end of the segment", role: "ray", limit: [-5, 5] },
    {
      kind: "point",
      field: "normal",
      from: "point",
      label: "N, normal of the plane",
      role: "normal",
      limit: [-3, 3],
    },
    {
      kind: "point",
      field: "point",
      label: "a, point of the plane",
      role: "surface",
      limit: [-3, 3],
    },
  ],
  controls: [
    { kind: "numbers", field: "start", label: "p", role: "ray" },
    { kind: "numbers", field: "end", label: "q", role: "ray" },
    { kind: "numbers", field: "normal", label: "N", role: "normal" },
    { kind: "numbers", field: "point", label: "a", role: "surface" },
  ],
  draw(scene, input, output) {
    const { start, end, point, normal } = input;
    scene.line(start, end, { role: "ray", width: 3 });
    scene.label(start, "p", { role: "ray", offset: [-14, -14], anchor: "end" });
    scene.label(end, "q", { role: "ray", offset: [14, 18] });
    if (output.problem) return;
    const tip: Vec3 = [point[0] + normal[0], point[1] + normal[1], point[2] + normal[2]];
    scene.patch(point, output.unit_normal, 2.5, { role: "surface", fill: 0.16, hides: true });
    scene.arrow(point, tip, { role: "normal", width: 2.5 });
    scene.label(tip, "N", { role: "normal", offset: [14, -8] });
    scene.drop(start, -2.6).drop(end, -2.6);

    for (const [at, foot, distance, side] of [
      [start, output.start_foot, output.start_distance, output.start_side],
      [end, output.end_foot, output.end_distance, output.end_side],
    ] as const) {
      const role = sideRole(side);
      scene.line(at, foot, { role, width: 2 });
      scene.dot(foot, role, 3.5);
      const half: Vec3 = [(at[0] + foot[0]) / 2, (at[1] + foot[1]) / 2, (at[2] + foot[2]) / 2];
      scene.label(half, pretty(distance, 3), { role, offset: [-8, 4], anchor: "end" });
    }
    if (output.hit) {
      scene.line(output.start_foot, output.end_foot, { role: "muted", width: 1, through: true });
      scene.dot(output.meeting, "hit", 6);
      scene.label(output.meeting, `t = ${pretty(output.t, 3)}`, { role: "hit", offset: [12, -10] });
    }
  },
  values: (_input, output) => [
    {
      name: "d_0",
      meaning: "E(p) = n·p − k",
      value: output.start_distance,
      role: sideRole(output.start_side),
    },
    {
      name: "d_1",
      meaning: "E(q) = n·q − k",
      value: output.end_distance,
      role: sideRole(output.end_side),
    },
    { name: "n", meaning: "unit normal", value: output.unit_normal, role: "normal" },
    { name: "k", meaning: "offset", value: output.offset, role: "surface" },
    {
      name: "t",
      meaning: "d₀ / (d₀ − d₁)",
      value: output.hit ? output.t : "no crossing",
      role: output.hit ? "hit" : "miss",
    },
    {
      name: "x",
      meaning: "(1 − t) p + t q",
      value: output.hit ? output.meeting : "–",
      role: output.hit ? "hit" : "miss",
    },
  ],
  describe(_input, output) {
    if (output.in_plane) return "Both ends lie on the plane, so no single point is the crossing.";
    const ends = `p is ${sideWord(output.start_side)} the plane and q is ${sideWord(output.end_side)} it`;
    if (output.hit) return `${ends}: the segment crosses at t = ${pretty(output.t, 3)}.`;
    return `${ends}: both distances have the same sign, so the segment does not cross.`;
  },
});
