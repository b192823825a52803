// Position and velocity of a body on a spring, step by step, and the circle of the exact motion.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  start: Vec2;
  step: number;
  integrator: number;
}

interface Output {
  positions: readonly number[];
  speed: readonly number[];
  round_x: readonly number[];
  round_y: readonly number[];
  steps: number;
  kept: number;
  largest: number;
  last: Vec2;
  truth: Vec2;
  off: number;
}

const EDGE = 3.6;
/** Clamps a coordinate to the edge of the picture. */
const cut = (value: number): number => Math.max(-EDGE, Math.min(EDGE, value));
const NAMES = [
  "explicit Euler",
  "symplectic Euler",
  "velocity Verlet",
  "position Verlet",
  "Runge–Kutta",
];

export default defineFigure<Input, Output>({
  title: "Five methods on a spring",
  view: { kind: "2d", x: [-2.9, 2.9], y: [-2.1, 2.1] },
  aspect: 1.38,
  initial: { start: [1.2, 0], step: 0.25, integrator: 0 },
  handles: [
    {
      kind: "point",
      field: "start",
      label: "start: position x and velocity v/ω",
      role: "ball",
      step: 0.05,
      limit: [-1.8, 1.8],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "integrator",
      label: "method",
      options: [
        { value: 0, label: "explicit Euler" },
        { value: 1, label: "symplectic Euler" },
        { value: 2, label: "velocity Verlet" },
        { value: 3, label: "position Verlet" },
        { value: 4, label: "Runge–Kutta" },
      ],
    },
    { kind: "slider", field: "step", label: "ωh", min: 0.05, max: 3, step: 0.05 },
  ],
  draw(scene, _input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow([-2.7, 0], [2.7, 0], axis);
    scene.arrow([0, -1.95], [0, 1.95], axis);
    scene.label([2.7, 0], "x", { role: "muted", offset: [-4, 20] });
    scene.label([0, 1.95], "v/ω", { role: "muted", offset: [10, 8] });
    if (output.problem) return;
    scene.path(
      output.round_x.map((x, i): Vec2 => [x, output.round_y[i] ?? 0]),
      { role: "normal", width: 2, dashed: true },
    );
    const path = output.positions
      .slice(0, output.steps + 1)
      .map((x, i): Vec2 => [cut(x), cut(output.speed[i] ?? 0)]);
    scene.path(path, { role: "ball", width: 1.6 });
    if (output.steps <= 80) for (const point of path) scene.dot(point, "ball", 2.4);
    scene.dot(output.truth, "normal", 5, true);
    scene.label(output.truth, "exact", { role: "normal", offset: [9, -7], size: "small" });
    const last: Vec2 = [cut(output.last[0]), cut(output.last[1])];
    scene.dot(last, "hit", 5);
    scene.label(last, "last step", { role: "hit", offset: [9, 14], size: "small" });
  },
  values: (_input, output) => [
    { name: "n", meaning: "steps in two periods", value: output.steps },
    { name: "E_n/E", meaning: "energy after them, relative", value: output.kept, role: "ball" },
    { name: "E_max/E", meaning: "largest energy, relative", value: output.largest, role: "ball" },
    { name: "last", meaning: "x and v/ω at the end", value: output.last, role: "hit" },
    { name: "exact", meaning: "exact x and v/ω at the end", value: output.truth, role: "normal" },
    { name: "error", meaning: "distance of the two", value: output.off, unit: "m" },
  ],
  describe(input, output) {
    const name = NAMES[Math.floor(input.integrator)] ?? "this method";
    return `With ${name} and ωh = ${pretty(input.step, 3)}, the energy after ${pretty(output.steps, 3)} steps is ${pretty(output.kept, 4)} times that of the start, and the error is ${pretty(output.off, 3)} m.`;
  },
});
