// One step of a ball between a floor, a wall and a leaning wall: each impact is a numbered dot.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  from: Vec2;
  to: Vec2;
  lean: Vec2;
  step: number;
  k: number;
  most: number;
  gravity: number;
}

interface Output {
  x: readonly number[];
  y: readonly number[];
  hit_x: readonly number[];
  hit_y: readonly number[];
  impacts: number;
  end: number;
  time_left: number;
  last: Vec2;
  velocity: Vec2;
  naive: Vec2;
}

const WIDTH = 5;
const TOP = 3.4;
const ENDS = ["the step is used up", "the ball rests on a wall", "the limit on impacts is reached"];

export default defineFigure<Input, Output>({
  title: "A whole step",
  view: { kind: "2d", x: [-1.2, 5.6], y: [-0.6, 3.6] },
  aspect: 1.62,
  initial: {
    from: [4.2, 1.1],
    to: [0.8, 0.9],
    lean: [2.2, 1.8],
    step: 2,
    k: 1,
    most: 12,
    gravity: 0,
  },
  handles: [
    {
      kind: "point",
      field: "from",
      label: "the ball",
      role: "ball",
      step: 0.05,
      limit: [0.15, 4.8],
    },
    {
      kind: "point",
      field: "to",
      label: "position after a second without walls",
      role: "ray",
      step: 0.05,
      limit: [-1, 5.4],
    },
    {
      kind: "point",
      field: "lean",
      label: "direction of the leaning wall",
      role: "normal",
      step: 0.05,
      limit: [0.05, 3.2],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "step",
      label: "Δt",
      min: 0.05,
      max: 4,
      step: 0.05,
      unit: "s",
      play: 4,
    },
    { kind: "slider", field: "k", label: "k", min: 0, max: 1, step: 0.01 },
    { kind: "slider", field: "most", label: "limit", min: 1, max: 16, step: 1 },
    {
      kind: "choice",
      field: "gravity",
      label: "gravity",
      options: [
        { value: 0, label: "none" },
        { value: 2, label: "2 m/s²" },
        { value: 9.81, label: "9.81 m/s²" },
      ],
    },
  ],
  draw(scene, input, output) {
    const [a, b] = input.lean;
    const high = b > 0 ? TOP / b : 1;
    scene.line([0, 0], [WIDTH, 0], { role: "surface", width: 3 });
    scene.line([WIDTH, 0], [WIDTH, TOP], { role: "surface", width: 3 });
    scene.line([0, 0], [Math.min(5.4, a * high), Math.min(TOP, b * high)], {
      role: "surface",
      width: 3,
    });
    if (output.problem) return;
    const centre: Vec2 = [output.x[0] ?? 0, output.y[0] ?? 0];
    scene.arrow(centre, input.to, { role: "ray", width: 1.5, dashed: true });
    scene.path(
      output.x.map((x, i): Vec2 => [x, output.y[i] ?? 0]),
      { role: "ball", width: 2.2 },
    );
    for (let i = 0; i < output.impacts; ++i) {
      const point: Vec2 = [output.hit_x[i] ?? 0, output.hit_y[i] ?? 0];
      scene.dot(point, "hit", 3.5);
      if (i < 6) {
        scene.label(point, pretty(i + 1), { role: "hit", offset: [8, -6], size: "small" });
      }
    }
    if (output.impacts > 1) {
      const naive: Vec2 = [
        Math.max(-1.1, Math.min(5.5, output.naive[0])),
        Math.max(-0.5, Math.min(3.5, output.naive[1])),
      ];
      scene.dot(naive, "miss", 5, true);
      scene.label(naive, "tested once", { role: "miss", offset: [9, 14], size: "small" });
    }
    scene.dot(output.last, "ball", 7);
  },
  values: (_input, output) => [
    { name: "n", meaning: "impacts in the step", value: output.impacts, role: "hit" },
    { name: "left", meaning: "unused time of the step", value: output.time_left, unit: "s" },
    { name: "x", meaning: "position at the end", value: output.last, unit: "m", role: "ball" },
    { name: "v", meaning: "velocity there", value: output.velocity, unit: "m/s", role: "ball" },
    {
      name: "x_once",
      meaning: "position if tested once",
      value: output.naive,
      unit: "m",
      role: "miss",
    },
  ],
  describe(_input, output) {
    const why = ENDS[output.end] ?? "";
    const impacts = output.impacts === 1 ? "impact" : "impacts";
    return `${pretty(output.impacts, 3)} ${impacts} in this step; it ends because ${why}, with ${pretty(output.time_left, 3)} s left.`;
  },
});
