// The same ball twice: dashed the exact solution, solid the simulation in time steps.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  height: number;
  step: number;
  k: number;
  rule: number;
}

interface Output {
  moment: readonly number[];
  truth: readonly number[];
  stepped_time: readonly number[];
  stepped: readonly number[];
  steps: number;
  true_bounces: number;
  bounces: number;
  true_height: number;
  last_height: number;
  highest: number;
  last_peak: number;
  true_last_peak: number;
}

const HIGH = 1.5;
/** Clips the curve at the edge of the picture. */
const cut = (y: number): number => HIGH * Math.max(-0.45, Math.min(2.7, y));

export default defineFigure<Input, Output>({
  title: "Which velocity to reflect",
  view: { kind: "2d", x: [-0.5, 6.3], y: [-0.85, 4.3] },
  aspect: 1.32,
  initial: { height: 1.2, step: 0.02, k: 1, rule: 3 },
  handles: [
    {
      kind: "slide",
      field: "height",
      label: "h, height of the drop, m",
      role: "ball",
      at: (input): Vec2 => [0, HIGH * input.height],
      along: (): Vec2 => [0, HIGH],
      step: 0.01,
      limit: [0.2, 2],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "rule",
      label: "rule",
      options: [
        { value: 4, label: "at the impact" },
        { value: 3, label: "step's end" },
        { value: 2, label: "the lecture's loop" },
        { value: 1, label: "on the floor" },
        { value: 0, label: "flip below" },
      ],
    },
    { kind: "slider", field: "step", label: "Δt", min: 0.002, max: 0.1, step: 0.001, unit: "s" },
    { kind: "slider", field: "k", label: "k", min: 0, max: 1, step: 0.01 },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow([0, 0], [0, HIGH * 2.75], axis);
    scene.line([0, 0], [6.2, 0], { role: "surface", width: 2.5 });
    scene.label([0, HIGH * 2.75], "height, m", { role: "muted", offset: [8, 6] });
    scene.label([6.2, 0], "t, s", { role: "muted", offset: [0, 36], anchor: "end" });
    for (const t of [1, 2, 3, 4, 5, 6]) {
      scene.line([t, -0.05], [t, 0.05], axis);
      scene.label([t, 0], pretty(t), {
        role: "muted",
        offset: [0, 19],
        anchor: "middle",
        size: "small",
      });
    }
    for (const y of [1, 2]) {
      scene.line([-0.05, HIGH * y], [0.05, HIGH * y], axis);
      scene.label([0, HIGH * y], pretty(y), {
        role: "muted",
        offset: [-8, 4],
        anchor: "end",
        size: "small",
      });
    }
    if (output.problem) return;
    scene.line([0, HIGH * input.height], [6.2, HIGH * input.height], {
      role: "muted",
      width: 1,
      dashed: true,
    });
    scene.path(
      output.moment.map((t, i): Vec2 => [t, cut(output.truth[i] ?? 0)]),
      { role: "normal", width: 2, dashed: true },
    );
    scene.path(
      output.stepped_time.map((t, i): Vec2 => [t, cut(output.stepped[i] ?? 0)]),
      { role: "ball", width: 2.2 },
    );
  },
  values: (_input, output) => [
    { name: "n", meaning: "impacts in 6 s", value: output.bounces, role: "ball" },
    { name: "n_true", meaning: "impacts, exactly", value: output.true_bounces, role: "normal" },
    {
      name: "peak",
      meaning: "in the last 1.5 s",
      value: output.last_peak,
      unit: "m",
      role: "ball",
    },
    {
      name: "peak_true",
      meaning: "the same, exactly",
      value: output.true_last_peak,
      unit: "m",
      role: "normal",
    },
    { name: "steps", meaning: "in 6 s", value: output.steps },
  ],
  describe(input, output) {
    if (output.last_height < -0.01)
      return `In steps of ${pretty(input.step, 3)} s the ball sinks through the floor.`;
    return `In steps of ${pretty(input.step, 3)} s the ball reaches ${pretty(output.last_peak, 3)} m near the end of six seconds; it should reach ${pretty(output.true_last_peak, 3)} m.`;
  },
});
