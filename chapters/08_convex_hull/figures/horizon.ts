// A point outside a hull sees some of its triangles. Their outline is the horizon, to which the new
// triangles are tied.

import { defineFigure, type Vec3, vectorAt } from "@contact/figure";

interface Input {
  p: Vec3;
  turned: number;
}

interface Output {
  points: readonly number[];
  faces: number;
  vertex: readonly number[];
  seen: readonly number[];
  seen_count: number;
  horizon_count: number;
  horizon: readonly number[];
  vertices_before: number;
  vertices_after: number;
  faces_after: number;
}

const GROUND = -1.4;

export default defineFigure<Input, Output>({
  title: "Adding a point",
  view: {
    kind: "3d",
    target: [0.2, 0, 0.1],
    azimuth: -50,
    elevation: 18,
    span: 4.4,
    ground: { half: 2.5, z: GROUND, step: 0.5 },
  },
  aspect: 1.1,
  initial: { p: [1.4, -0.9, 1], turned: 0 },
  handles: [{ kind: "point", field: "p", label: "p, the new point", role: "ball", limit: [-4, 4] }],
  controls: [
    {
      kind: "choice",
      field: "turned",
      label: "Show",
      options: [
        { value: 0, label: "what p sees" },
        { value: 1, label: "the hull with p" },
      ],
    },
    { kind: "numbers", field: "p", label: "p", role: "ball", step: 0.1 },
  ],
  draw(scene, input, output) {
    scene.drop(input.p, GROUND, "ghost");
    scene.label(input.p, "p", { role: "ball", offset: [12, -10] });
    if (output.problem) return;
    const at = (i: number | undefined): Vec3 => vectorAt(output.points, i ?? 0);
    for (let t = 0; t < output.faces; t++) {
      const seen = output.seen[t] === 1;
      if (seen && input.turned) continue;
      scene.face(
        [0, 1, 2].map((k) => at(output.vertex[3 * t + k])),
        { role: seen ? "miss" : "surface", fill: seen ? 0.25 : 0.16, outline: true, hides: true },
      );
    }
    for (let i = 0; i < output.horizon_count; i++) {
      const from = at(output.horizon[2 * i]);
      const to = at(output.horizon[2 * i + 1]);
      if (input.turned)
        scene.face([from, to, input.p], { role: "hit", fill: 0.25, outline: true, hides: true });
      scene.line(from, to, { role: "normal", width: 4, through: true });
    }
  },
  values: (_input, output) => [
    { name: "seen", meaning: "triangles that p sees", value: output.seen_count, role: "miss" },
    {
      name: "horizon",
      meaning: "edges, and new triangles",
      value: output.horizon_count,
      role: "normal",
    },
    { name: "vertices", meaning: "with p", value: output.vertices_after },
    { name: "faces", meaning: "with p", value: output.faces_after, role: "hit" },
  ],
  describe: (_input, output) =>
    output.seen_count === 0
      ? "p sees no triangle: it is inside the hull, or on it, and changes nothing."
      : `p sees ${output.seen_count} of ${output.faces} triangles, with a horizon of ${output.horizon_count} edges. With p the hull has ${output.vertices_after} vertices and ${output.faces_after} faces.`,
});
