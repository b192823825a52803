// Eight points and the triangles that a method makes of them. A triangle with points in front of it
// is red, and so is an edge that no second triangle has.

import { defineFigure, type Vec3, vectorAt } from "@contact/figure";

interface Input {
  a: Vec3;
  b: Vec3;
  c: Vec3;
  d: Vec3;
  e: Vec3;
  f: Vec3;
  g: Vec3;
  h: Vec3;
  method: number;
  epsilon: number;
  shown: number;
  flat: number;
}

interface Output {
  dimension: number;
  corners: number;
  faces: number;
  triangles: number;
  closed: number;
  right: number;
  vertex: readonly number[];
  in_front: readonly number[];
  open_edges: number;
  open: readonly number[];
  outside: number;
  found: number;
  lost: readonly number[];
  position: readonly number[];
}

const GROUND = -1.4;
const NAMES = ["a", "b", "c", "d", "e", "f", "g", "h"] as const;
const METHODS = [
  "exact",
  "angles as on the slide",
  "signed angles",
  "an epsilon",
  "incremental, float",
  "incremental, double",
  "wrapping, double",
];

export default defineFigure<Input, Output>({
  title: "Wrapping eight points",
  view: {
    kind: "3d",
    target: [0, 0, 0],
    azimuth: -62,
    elevation: 24,
    span: 4.4,
    ground: { half: 2, z: GROUND, step: 0.5 },
  },
  aspect: 1.05,
  initial: {
    a: [-1, -1, -1],
    b: [1, -1, -1],
    c: [1, 1, -1],
    d: [-1, 1, -1],
    e: [-1, -1, 1],
    f: [1, -1, 1],
    g: [1, 1, 1],
    h: [-1, 1, 1],
    method: 2,
    epsilon: 0.3,
    shown: 24,
    flat: 0,
  },
  handles: NAMES.map((field) => ({
    kind: "point" as const,
    field,
    label: `${field}, a point`,
    role: "ray" as const,
    step: 0.25,
    limit: [-2, 2] as const,
  })),
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "Method",
      options: [
        { value: 0, label: "exact" },
        { value: 1, label: "wrapping, angles as on the slide" },
        { value: 2, label: "wrapping, signed angles" },
        { value: 3, label: "incremental, with an epsilon" },
        { value: 4, label: "incremental, rounded in float" },
        { value: 5, label: "incremental, rounded in double" },
        { value: 6, label: "wrapping, rounded in double" },
      ],
    },
    {
      kind: "choice",
      field: "flat",
      label: "Points",
      options: [
        { value: 0, label: "as they are" },
        { value: 9, label: "nearly flat (10⁻⁹)" },
        { value: 13, label: "flatter (10⁻¹³)" },
        { value: 16, label: "down to rounding (10⁻¹⁶)" },
      ],
    },
    { kind: "slider", field: "shown", label: "shown", min: 0, max: 24, step: 1, play: 8 },
    { kind: "slider", field: "epsilon", label: "epsilon", min: 0, max: 1, step: 0.05, unit: "m" },
    ...NAMES.map((field) => ({
      kind: "numbers" as const,
      field,
      label: field,
      role: "ray" as const,
      step: 0.25,
    })),
  ],
  draw(scene, input, output) {
    const points = NAMES.map((name, i) =>
      output.problem ? input[name] : vectorAt(output.position, i),
    );
    for (const [i, p] of points.entries()) {
      scene.drop(p, GROUND, "ghost");
      scene.label(p, NAMES[i] ?? "", { role: "ink", offset: [8, -10], size: "small" });
    }
    if (output.problem) return;
    const at = (i: number | undefined): Vec3 => points[i ?? 0] ?? [0, 0, 0];
    const shown = Math.min(input.shown, output.triangles);
    for (let t = 0; t < shown; t++) {
      const corners = [0, 1, 2].map((k) => at(output.vertex[3 * t + k]));
      const wrong = (output.in_front[t] ?? 0) > 0;
      scene.face(corners, {
        role: wrong ? "miss" : "surface",
        fill: wrong ? 0.3 : 0.16,
        outline: true,
        hides: true,
      });
    }
    if (shown < output.triangles) return;
    for (const [i, p] of points.entries()) {
      if (!output.lost[i]) continue;
      scene.dot(p, "miss", 9, true);
      scene.label(p, "lost", { role: "miss", offset: [10, 20], size: "small" });
    }
    for (let i = 0; i < output.open_edges; i++)
      scene.line(at(output.open[2 * i]), at(output.open[2 * i + 1]), {
        role: "miss",
        width: 4,
        through: true,
      });
  },
  values: (input, output) => [
    {
      name: "verdict",
      meaning: METHODS[input.method] ?? "",
      value: output.right ? "the hull" : "not the hull",
      role: output.right ? "hit" : "miss",
    },
    {
      name: "found",
      meaning: "of the hull's vertices",
      value: `${output.found} of ${output.corners}`,
      role: output.found < output.corners ? "miss" : "ink",
    },
    { name: "triangles", meaning: "of the method", value: output.triangles },
    {
      name: "closed",
      meaning: "as the method reports",
      value: output.closed ? "yes" : "no",
      role: output.closed ? "ink" : "miss",
    },
    {
      name: "open",
      meaning: "edges of one triangle only",
      value: output.open_edges,
      role: output.open_edges ? "miss" : "ink",
    },
    {
      name: "outside",
      meaning: "points in front of a triangle",
      value: output.outside,
      role: output.outside ? "miss" : "ink",
    },
    { name: "faces", meaning: "of the exact hull", value: output.faces, role: "surface" },
  ],
  describe: (input, output) =>
    `The exact hull has ${output.corners} vertices and ${output.faces} faces. The method (${METHODS[input.method]}) finds ${output.found} of them and gives ${output.triangles} triangles with ${output.open_edges} open edges; ${output.outside} points are outside. It is ${output.right ? "the hull" : "not the hull"}.`,
});
