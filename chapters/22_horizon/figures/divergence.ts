// Two paths in a room with posts, and below it their distance, on a logarithmic scale.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  from: Vec2;
  to: Vec2;
  digits: number;
  post: number;
  shown: number;
}

interface Output {
  x: readonly number[];
  y: readonly number[];
  other_x: readonly number[];
  other_y: readonly number[];
  apart: readonly number[];
  lens: readonly number[];
  impacts: number;
  on_posts: number;
  diverged: number;
  way: number;
}

const WIDTH = 4;
const HEIGHT = 3;
const POSTS: readonly Vec2[] = [
  [1.05, 0.8],
  [2.9, 0.95],
  [2, 1.75],
  [0.95, 2.3],
];
/** The plot under the room: powers of ten from LOW to 1, forty impacts to the right. */
const LOW = -16;
const TALL = 0.12;
const BASE = -0.55 + LOW * TALL;
const height = (apart: number): number =>
  BASE + (Math.max(LOW, Math.min(1, Math.log10(apart))) - LOW) * TALL;

export default defineFigure<Input, Output>({
  title: "Two paths that diverge",
  view: { kind: "2d", x: [-0.5, 4.2], y: [-2.85, 3.1] },
  aspect: 0.82,
  initial: { from: [0.5, 1.6], to: [2.4, 2.6], digits: 9, post: 0.3, shown: 24 },
  handles: [
    {
      kind: "point",
      field: "from",
      label: "the ball",
      role: "ball",
      step: 0.05,
      limit: [0.15, 3.85],
    },
    { kind: "point", field: "to", label: "its aim", role: "ray", step: 0.05, limit: [0.1, 3.9] },
  ],
  controls: [
    { kind: "slider", field: "digits", label: "equal digits", min: 1, max: 15, step: 1 },
    { kind: "slider", field: "post", label: "posts", min: 0.05, max: 0.4, step: 0.01, unit: "m" },
    { kind: "slider", field: "shown", label: "impacts", min: 1, max: 40, step: 1, play: 8 },
  ],
  draw(scene, input, output) {
    const corners: readonly Vec2[] = [
      [0, 0],
      [WIDTH, 0],
      [WIDTH, HEIGHT],
      [0, HEIGHT],
      [0, 0],
    ];
    scene.path(corners, { role: "surface", width: 3 });
    for (const post of POSTS) {
      scene.ball(post, input.post, { role: "surface", fill: 0.35, outline: true });
    }
    scene.line([0, BASE], [WIDTH, BASE], { role: "muted", width: 1 });
    for (const power of [-16, -12, -8, -4, 0]) {
      const y = height(10 ** power);
      scene.line([0, y], [WIDTH, y], { role: "ghost", width: 1 });
      scene.label([0, y], power === 0 ? "1 m" : `1e${power}`, {
        role: "muted",
        offset: [-5, 4],
        anchor: "end",
        size: "small",
      });
    }
    scene.label([WIDTH, BASE], "impacts", {
      role: "muted",
      offset: [0, 18],
      anchor: "end",
      size: "small",
    });
    if (output.problem) {
      scene.arrow(input.from, input.to, { role: "ray", width: 1.5, dashed: true });
      return;
    }
    const count = output.impacts;
    const path = (xs: readonly number[], ys: readonly number[]): Vec2[] =>
      xs.slice(0, count + 1).map((x, i): Vec2 => [x, ys[i] ?? 0]);
    const together = output.diverged > 0 ? output.diverged : count;
    scene.path(path(output.x, output.y), { role: "a", width: 1.8 });
    scene.path(path(output.other_x, output.other_y), { role: "b", width: 1.8, dashed: true });
    scene.arrow([output.x[0] ?? 0, output.y[0] ?? 0], input.to, { role: "ray", width: 1 });
    scene.ball([output.x[count] ?? 0, output.y[count] ?? 0], 0.1, { role: "a", fill: 0.6 });
    scene.ball([output.other_x[count] ?? 0, output.other_y[count] ?? 0], 0.1, {
      role: "b",
      fill: 0.6,
    });
    const curve = (values: readonly number[]): Vec2[] =>
      values.slice(0, count + 1).map((apart, k): Vec2 => [(k * WIDTH) / 40, height(apart)]);
    scene.path(curve(output.lens), { role: "muted", width: 1.5, dashed: true });
    scene.path(curve(output.apart), { role: "hit", width: 2.2 });
    const end: Vec2 = [(together * WIDTH) / 40, height(output.apart[together] ?? 1)];
    scene.dot(end, output.diverged > 0 ? "miss" : "hit", 4);
  },
  values: (_input, output) => [
    { name: "n", meaning: "impacts followed", value: output.impacts },
    { name: "on posts", meaning: "impacts on posts", value: output.on_posts },
    { name: "ℓ", meaning: "mean distance from post to post", value: output.way, unit: "m" },
    {
      name: "distance",
      meaning: "of the two after the last impact",
      value: output.apart[output.impacts] ?? 0,
      unit: "m",
      role: "hit" as Role,
    },
    {
      name: "n_diverged",
      meaning: "impacts until a radius apart; 0: not yet",
      value: output.diverged,
    },
  ],
  describe(input, output) {
    const began = `The two begin ${pretty(10 ** -input.digits, 2)} m apart`;
    if (output.diverged > 0) {
      return `${began}; after ${pretty(output.diverged)} impacts they are more than a ball’s radius apart.`;
    }
    return `${began}, and are ${pretty(output.apart[output.impacts] ?? 0, 2)} m apart after ${pretty(output.impacts)} impacts.`;
  },
});
