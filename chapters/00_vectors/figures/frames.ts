// A wagon with its own two axes, and a point that has coordinates in both frames.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  origin: Vec2;
  forward: Vec2;
  point: Vec2;
}

interface Output {
  x_axis: Vec2;
  y_axis: Vec2;
  as_position: Vec2;
  as_direction: Vec2;
  corner: Vec2;
}

const from = (origin: Vec2, axis: Vec2, by: number): Vec2 => [
  origin[0] + by * axis[0],
  origin[1] + by * axis[1],
];

export default defineFigure<Input, Output>({
  title: "One position, two frames",
  view: { kind: "2d", x: [-0.5, 6.2], y: [-0.5, 4.6], grid: 1 },
  aspect: 1.3,
  initial: { origin: [2, 1], forward: [1.6, 1.2], point: [3, 3.5] },
  handles: [
    {
      kind: "point",
      field: "origin",
      label: "origin of the wagon",
      role: "ray",
      step: 0.1,
      limit: [0, 6],
    },
    {
      kind: "point",
      field: "forward",
      from: "origin",
      label: "the direction in which the wagon faces",
      role: "a",
      step: 0.1,
      limit: [-3, 3],
    },
    {
      kind: "point",
      field: "point",
      label: "p, a point",
      role: "hit",
      step: 0.1,
      limit: [0, 6],
    },
  ],
  controls: [
    { kind: "numbers", field: "origin", label: "wagon", role: "ray", unit: "m" },
    { kind: "numbers", field: "forward", label: "forward", role: "a", unit: "m" },
    { kind: "numbers", field: "point", label: "p", role: "hit", unit: "m" },
  ],
  draw(scene, input, output) {
    scene.arrow([0, 0], [1, 0], { role: "muted", width: 2 });
    scene.arrow([0, 0], [0, 1], { role: "muted", width: 2 });
    scene.label([1, 0], "x", { role: "muted", offset: [6, 16] });
    scene.label([0, 1], "y", { role: "muted", offset: [-8, -6], anchor: "end" });
    scene.label(input.point, "p", { role: "hit", offset: [10, -10] });
    if (output.problem) return;
    const { origin, point } = input;
    const { x_axis, y_axis } = output;
    const side = (ahead: number, left: number): Vec2 =>
      from(from(origin, x_axis, ahead), y_axis, left);
    scene.face([side(-0.7, -0.4), side(0.7, -0.4), side(0.7, 0.4), side(-0.7, 0.4)], {
      role: "ray",
      fill: 0.15,
    });
    scene.line(origin, output.corner, { role: "a", width: 1.5, dashed: true });
    scene.line(output.corner, point, { role: "b", width: 1.5, dashed: true });
    scene.arrow(origin, side(1, 0), { role: "a", width: 3 });
    scene.arrow(origin, side(0, 1), { role: "b", width: 3 });
    scene.label(side(1, 0), "x′", { role: "a", offset: [8, 16] });
    scene.label(side(0, 1), "y′", { role: "b", offset: [-8, -6], anchor: "end" });
    scene.dot(point, "hit", 5);
  },
  values: (input, output) => [
    { name: "p", meaning: "in the world", value: input.point, unit: "m", role: "hit" },
    { name: "p′", meaning: "in the wagon", value: output.as_position, unit: "m", role: "hit" },
    {
      name: "v′",
      meaning: "the same world coordinates, as a velocity",
      value: output.as_direction,
      unit: "m/s",
    },
  ],
  describe(_input, output) {
    const [ahead, left] = output.as_position;
    const x = `${pretty(Math.abs(ahead), 2)} m ${ahead < 0 ? "behind" : "ahead of"} the wagon’s origin`;
    const y = `${pretty(Math.abs(left), 2)} m to its ${left < 0 ? "right" : "left"}`;
    return `The point is ${x} and ${y}.`;
  },
});
