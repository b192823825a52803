// Weights of a point as shares of area: the weight of a vertex is the share of the triangle opposite
// to it. The projection along the largest component of the normal has the same shares.

import { along, defineFigure, pretty, type Role, type Vec3, vectorAt } from "@contact/figure";

interface Input {
  a: Vec3;
  b: Vec3;
  c: Vec3;
  point: Vec3;
  values: Vec3;
}

interface Output {
  foot: Vec3;
  weights: Vec3;
  inside: number;
  value: number;
  part_areas: Vec3;
  area: number;
  dropped: number;
  projection_areas: Vec3;
  projection: readonly number[];
  beta_on_slide: number;
  inside_on_slide: number;
}

const AXES = ["x", "y", "z"];

export default defineFigure<Input, Output>({
  title: "The weights of a point in a triangle",
  view: {
    kind: "3d",
    target: [0, 0.2, 1.1],
    azimuth: -62,
    elevation: 22,
    span: 5.4,
    ground: { half: 2.5, z: 0, step: 0.5 },
  },
  aspect: 0.98,
  initial: {
    a: [-1.7, -0.7, 0.9],
    b: [1.6, -0.6, 1.3],
    c: [-0.1, 1.5, 2.4],
    point: [-0.2, -0.7, 2.4],
    values: [10, 20, 40],
  },
  handles: [
    { kind: "point", field: "a", label: "a, vertex of the triangle", role: "a", limit: [-4, 4] },
    { kind: "point", field: "b", label: "b, vertex of the triangle", role: "b", limit: [-4, 4] },
    { kind: "point", field: "c", label: "c, vertex of the triangle", role: "c", limit: [-4, 4] },
    { kind: "point", field: "point", label: "x, the point", role: "hit", limit: [-4, 4] },
  ],
  controls: [
    { kind: "numbers", field: "point", label: "x", role: "hit" },
    { kind: "numbers", field: "a", label: "a", role: "a" },
    { kind: "numbers", field: "b", label: "b", role: "b" },
    { kind: "numbers", field: "c", label: "c", role: "c" },
    { kind: "numbers", field: "values", label: "°C", axes: ["at a", "at b", "at c"], step: 1 },
  ],
  draw(scene, input, output) {
    const { a, b, c, point, values } = input;
    const corners = [
      [a, "a", values[0], [-14, 16], "end"],
      [b, "b", values[1], [14, 16], "start"],
      [c, "c", values[2], [0, -18], "middle"],
    ] as const;
    for (const [at, name, value, offset, anchor] of corners)
      scene.label(at, `${name}: ${pretty(value, 3)} °C`, { role: name, offset, anchor });
    scene.label(point, "x", { role: "hit", offset: [-12, -12], anchor: "end" });
    if (output.problem) {
      scene.path([a, b, c, a], { role: "surface" });
      return;
    }
    const { foot } = output;
    const projection = [0, 1, 2, 3].map((i) => vectorAt(output.projection, i));
    const [projectionA, projectionB, projectionC, projectionFoot] = projection as [
      Vec3,
      Vec3,
      Vec3,
      Vec3,
    ];
    scene.face([projectionA, projectionB, projectionC], { role: "muted", fill: 0.1 });
    for (const corner of [projectionA, projectionB, projectionC])
      scene.line(projectionFoot, corner, { role: "muted", width: 0.8, through: true });
    for (const [at, end] of [
      [a, projectionA],
      [b, projectionB],
      [c, projectionC],
    ] as const)
      scene.line(at, end, { role: "ghost", width: 1, dashed: true, through: true });
    scene.dot(projectionFoot, "muted", 3);

    const parts = [
      [b, c, "a", 0],
      [c, a, "b", 1],
      [a, b, "c", 2],
    ] as const;
    for (const [from, to, role, i] of parts) {
      if (output.inside) scene.face([foot, from, to], { role, fill: 0.26, outline: false });
      const middle = along(along(from, to, 0.5), foot, 1 / 3);
      const weight = pretty(output.weights[i], 2);
      scene.label(middle, weight, { role, anchor: "middle", size: "small", offset: [0, 4] });
    }
    scene.face([a, b, c], { role: "surface", fill: output.inside ? 0 : 0.14, hides: true });
    for (const [at, name] of corners)
      scene.line(foot, at, { role: name, width: 1.6, dashed: !output.inside, through: true });
    const role: Role = output.inside ? "hit" : "miss";
    scene.line(point, foot, { role: "muted", width: 1, dashed: true, through: true });
    scene.dot(foot, role, 6, !output.inside);
    scene.label(foot, `${pretty(output.value, 3)} °C`, { role, offset: [12, 20] });
  },
  values: (_input, output) => [
    { name: "w_a", meaning: "weight of a", value: output.weights[0], role: "a" },
    { name: "w_b", meaning: "weight of b", value: output.weights[1], role: "b" },
    { name: "w_c", meaning: "weight of c", value: output.weights[2], role: "c" },
    {
      name: "T",
      meaning: "blended",
      value: output.value,
      unit: "°C",
      role: output.inside ? "hit" : "miss",
    },
    { name: "A", meaning: "area", value: output.area, unit: "m²", role: "surface" },
    {
      name: "A_x, A_y, A_z",
      meaning: "of its projections",
      value: output.projection_areas,
      unit: "m²",
      role: "muted",
    },
    {
      name: "dropped",
      meaning: "largest projection",
      value: AXES[output.dropped] ?? "–",
      role: "muted",
    },
    { name: "β", meaning: "as on the slide", value: output.beta_on_slide, role: "muted" },
  ],
  describe(_input, output) {
    const [a, b, c] = output.weights.map((weight) => pretty(weight, 2));
    const shares = `the weights of a, b and c are ${a}, ${b} and ${c}`;
    if (output.inside) {
      const slide = output.inside_on_slide ? "" : " The slide’s β would call it outside.";
      return `The projection of x is in the triangle: ${shares}.${slide}`;
    }
    return `The projection of x is outside the triangle: ${shares}. It is beyond the edge opposite a vertex with a negative weight.`;
  },
});
