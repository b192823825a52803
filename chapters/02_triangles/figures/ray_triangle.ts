// A ray or a segment against a triangle. Each edge shows its own test: green if the crossing is on
// the inner side, red if it is beyond.

import { along, defineFigure, pretty, type Role, type Vec3 } from "@contact/figure";

interface Input {
  origin: Vec3;
  through: Vec3;
  a: Vec3;
  b: Vec3;
  c: Vec3;
  segment: number;
}

interface Output {
  origin_height: number;
  through_height: number;
  crosses: number;
  crossing: Vec3;
  hit: number;
  t: number;
  point: Vec3;
  weights: Vec3;
  edge_products: Vec3;
  hit_in_double: readonly number[];
  hit_in_float: readonly number[];
  all_agree: number;
  normal: Vec3;
}

const GROUND = -1.6;
const METHODS = ["edge tests", "dropping", "Möller–Trumbore", "watertight"];
const verdict = (hit: number | undefined): string => (hit ? "hit" : "miss");

export default defineFigure<Input, Output>({
  title: "A ray and a triangle",
  view: {
    kind: "3d",
    target: [0, 0, 0.35],
    azimuth: -64,
    elevation: 17,
    span: 5.6,
    ground: { half: 3, z: GROUND, step: 0.5 },
  },
  aspect: 0.98,
  initial: {
    origin: [-1.2, -1.9, 1.3],
    through: [-0.4, -0.6, 0.8],
    a: [-1.5, 0.4, -0.9],
    b: [1.5, -0.3, -0.6],
    c: [0.3, 0.7, 1.8],
    segment: 0,
  },
  handles: [
    { kind: "point", field: "a", label: "a, vertex of the triangle", role: "a", limit: [-4, 4] },
    { kind: "point", field: "b", label: "b, vertex of the triangle", role: "b", limit: [-4, 4] },
    { kind: "point", field: "c", label: "c, vertex of the triangle", role: "c", limit: [-4, 4] },
    { kind: "point", field: "origin", label: "o, start of the ray", role: "ray", limit: [-4, 4] },
    {
      kind: "point",
      field: "through",
      label: "q, a point on the ray",
      role: "ray",
      limit: [-4, 4],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "segment",
      label: "Test",
      options: [
        { value: 0, label: "the ray from o through q" },
        { value: 1, label: "the segment from o to q" },
      ],
    },
    { kind: "numbers", field: "origin", label: "o", role: "ray" },
    { kind: "numbers", field: "through", label: "q", role: "ray" },
    { kind: "numbers", field: "a", label: "a", role: "a" },
    { kind: "numbers", field: "b", label: "b", role: "b" },
    { kind: "numbers", field: "c", label: "c", role: "c" },
  ],
  draw(scene, input, output) {
    const { origin, through, a, b, c, segment } = input;
    const far = along(origin, through, 12);
    scene.label(origin, "o", { role: "ray", offset: [-14, -10], anchor: "end" });
    scene.label(through, "q", { role: "ray", offset: [12, -12] });
    const corners = [
      [a, "a", [-14, 16], "end"],
      [b, "b", [14, 16], "start"],
      [c, "c", [0, -18], "middle"],
    ] as const;
    for (const [at, name, offset, anchor] of corners)
      scene.label(at, name, { role: name, offset, anchor });
    const found = !output.problem && output.hit;
    scene.face([a, b, c], {
      role: found ? "hit" : "surface",
      fill: found ? 0.2 : 0.16,
      outline: false,
      hides: true,
    });
    scene.drop(origin, GROUND);
    for (const corner of [a, b, c]) scene.drop(corner, GROUND, "ghost");
    if (output.problem) return;

    // Each edge by its test, when the line crosses the plane at all.
    const edges = [
      [b, c],
      [c, a],
      [a, b],
    ] as const;
    for (const [i, [from, to]] of edges.entries()) {
      const inner = (output.edge_products[i] ?? 0) >= 0;
      const role: Role = !output.crosses ? "surface" : inner ? "hit" : "miss";
      scene.line(from, to, { role, width: inner ? 2.5 : 3.5, through: true });
    }

    const stop = found ? output.point : segment ? through : far;
    scene.line(origin, stop, { role: "ray", width: 3, arrow: !found && segment === 0 });
    if (found && !segment) scene.line(output.point, far, { role: "ray", width: 1, dashed: true });
    if (found && segment)
      scene.line(output.point, through, { role: "ray", width: 1, dashed: true });
    if (!output.crosses) return;
    const role: Role = found ? "hit" : "miss";
    const at = found ? output.point : output.crossing;
    for (const [corner, name] of corners)
      scene.line(at, corner, { role: name, width: 1, dashed: !found, through: true });
    scene.dot(at, role, 6, !found);
    scene.label(at, found ? `t = ${pretty(output.t, 3)}` : "miss", { role, offset: [12, -8] });
  },
  values(_input, output) {
    const none = output.crosses ? undefined : "–";
    const weight = (i: 0 | 1 | 2): number | string => none ?? output.weights[i];
    return [
      {
        name: "t",
        meaning: "of the hit, exact",
        value: output.hit ? output.t : "miss",
        role: output.hit ? "hit" : "miss",
      },
      { name: "w_a", meaning: "weight of a", value: weight(0), role: "a" },
      { name: "w_b", meaning: "weight of b", value: weight(1), role: "b" },
      { name: "w_c", meaning: "weight of c", value: weight(2), role: "c" },
      { name: "d_o", meaning: "distance of o", value: output.origin_height, role: "ray" },
      ...METHODS.map((name, i) => ({
        name,
        meaning: "double, float",
        value: `${verdict(output.hit_in_double[i])}, ${verdict(output.hit_in_float[i])}`,
        role: (output.hit_in_double[i] === output.hit && output.hit_in_float[i] === output.hit
          ? "ink"
          : "miss") as Role,
      })),
    ];
  },
  describe(input, output) {
    const what = input.segment ? "segment" : "ray";
    const agree = output.all_agree
      ? "All methods agree."
      : "The methods do not agree with the exact test.";
    if (output.hit) return `The ${what} hits the triangle at t = ${pretty(output.t, 3)}. ${agree}`;
    if (!output.crosses)
      return `The ${what} is parallel to the triangle’s plane, so there is no single crossing. ${agree}`;
    const names = ["b c", "c a", "a b"].filter((_, i) => (output.edge_products[i] ?? 0) < 0);
    const why =
      names.length > 0
        ? `its line crosses the plane beyond the edge ${names.join(" and the edge ")}`
        : `its line crosses the triangle, but not within the ${what}`;
    return `The ${what} misses: ${why}. ${agree}`;
  },
});
