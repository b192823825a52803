// Two arrows: the projection of one on the other (dot), and the parallelogram between them with the
// arrow perpendicular to it (cross).

import { along, defineFigure, pretty, prettyVector, type Role, type Vec3 } from "@contact/figure";

interface Input {
  u: Vec3;
  v: Vec3;
}

interface Output {
  dot: number;
  cross: Vec3;
  area: number;
  cosine: number;
  along: number;
  foot: Vec3;
}

const ORIGIN: Vec3 = [0, 0, 0];
const GROUND = -1.5;
const sum = (p: Vec3, q: Vec3): Vec3 => [p[0] + q[0], p[1] + q[1], p[2] + q[2]];
const sign = (dot: number): string => (dot > 0 ? "positive" : dot < 0 ? "negative" : "zero");
const angle = (dot: number): string => (dot > 0 ? "acute" : dot < 0 ? "obtuse" : "a right angle");

export default defineFigure<Input, Output>({
  title: "Two products of two arrows",
  view: {
    kind: "3d",
    target: [0.3, 0, 0.15],
    azimuth: -58,
    elevation: 22,
    span: 4.6,
    ground: { half: 2.5, z: GROUND, step: 0.5 },
  },
  aspect: 1.05,
  initial: { u: [1.6, -0.4, 0], v: [0.7, 1.2, 0.2] },
  handles: [
    { kind: "point", field: "u", label: "u, first vector", role: "a", limit: [-2.5, 2.5] },
    { kind: "point", field: "v", label: "v, second vector", role: "b", limit: [-2.5, 2.5] },
  ],
  controls: [
    { kind: "numbers", field: "u", label: "u", role: "a", unit: "m" },
    { kind: "numbers", field: "v", label: "v", role: "b", unit: "m" },
  ],
  draw(scene, input, output) {
    const { u, v } = input;
    if (!output.problem) {
      scene.face([ORIGIN, u, sum(u, v), v], { role: "normal", fill: 0.16, hides: true });
    }
    scene.drop(u, GROUND);
    scene.drop(v, GROUND);
    scene.arrow(ORIGIN, u, { role: "a", width: 3, through: true });
    scene.arrow(ORIGIN, v, { role: "b", width: 3, through: true });
    scene.label(u, "u", { role: "a", offset: [12, 14] });
    scene.label(v, "v", { role: "b", offset: [12, -6] });
    if (output.problem) return;
    const role: Role = output.dot < 0 ? "miss" : "hit";
    scene.line(v, output.foot, { role: "muted", width: 1, dashed: true, through: true });
    scene.line(ORIGIN, output.foot, { role, width: 6, dashed: output.dot < 0, through: true });
    scene.dot(output.foot, role, 4, output.dot < 0);
    scene.label(along(ORIGIN, output.foot, 0.6), `${pretty(output.along, 2)} m`, {
      role,
      offset: [0, 20],
      anchor: "middle",
    });
    scene.arrow(ORIGIN, output.cross, { role: "normal", width: 3, through: true });
    scene.label(output.cross, "u × v", { role: "normal", offset: [10, -8] });
  },
  values: (_input, output) => [
    {
      name: "u · v",
      meaning: "dot product",
      value: output.dot,
      unit: "m²",
      role: output.dot < 0 ? "miss" : "hit",
    },
    { name: "cos θ", meaning: "of the angle between", value: output.cosine },
    { name: "v along u", meaning: "with its sign", value: output.along, unit: "m" },
    { name: "u × v", meaning: "cross product", value: output.cross, unit: "m²", role: "normal" },
    {
      name: "|u × v|",
      meaning: "area between them",
      value: output.area,
      unit: "m²",
      role: "normal",
    },
  ],
  describe: (_input, output) =>
    `The dot product is ${sign(output.dot)}, so the angle is ${angle(output.dot)}. ` +
    (output.area > 0
      ? `The cross product is ${prettyVector(output.cross, 2)}, perpendicular to both arrows.`
      : "The cross product is zero: the arrows lie on one line."),
});
