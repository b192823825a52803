// The height of a bouncing ball against time. Infinitely many impacts come before the dashed line.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  height: number;
  rebound: number;
  gravity: number;
  time: number;
  rest_height: number;
  beside: number;
}

interface Output {
  k: number;
  speed: number;
  end: number;
  shown_until: number;
  impact: readonly number[];
  peak_time: readonly number[];
  peak: readonly number[];
  moment: readonly number[];
  path: readonly number[];
  now: number;
  height_now: number;
  velocity_now: number;
  bounces: number;
  rest_speed: number;
  rest_from: number;
  rest_bounces: number;
  wrong_k: number;
  wrong_end: number;
  wrong_peak_time: readonly number[];
  wrong_peak: readonly number[];
  wrong_moment: readonly number[];
  wrong_path: readonly number[];
}

/** Metres are drawn twice as high as seconds are wide. */
const HIGH = 2;
const LAST = 5;
const at = (t: number, y: number): Vec2 => [t, HIGH * y];
/** As much of a path as the picture has room for. */
const curve = (moment: readonly number[], path: readonly number[]): Vec2[] =>
  moment.map((t, i) => at(t, path[i] ?? 0)).filter(([t]) => t <= LAST + 0.2);

export default defineFigure<Input, Output>({
  title: "Infinitely many bounces in a finite time",
  view: { kind: "2d", x: [-0.45, 5.3], y: [-0.75, 3.3] },
  aspect: 1.42,
  initial: { height: 1.4, rebound: 0.9, gravity: 9.81, time: 0.7, rest_height: 0, beside: 0 },
  handles: [
    {
      kind: "slide",
      field: "height",
      label: "h, height of the drop, m",
      role: "ball",
      at: (input): Vec2 => at(0, input.height),
      along: (): Vec2 => [0, HIGH],
      step: 0.05,
      limit: [0.5, 1.6],
    },
    {
      kind: "slide",
      field: "rebound",
      label: "h₁, height of the first rebound, m",
      role: "a",
      at: (input, output): Vec2 => at(output.peak_time[0] ?? 0, input.rebound),
      along: (): Vec2 => [0, HIGH],
      step: 0.02,
      limit: [0, 1.4],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "time",
      label: "t",
      min: 0,
      max: LAST,
      step: 0.01,
      unit: "s",
      play: 5,
    },
    {
      kind: "slider",
      field: "rest_height",
      label: "ε",
      min: 0,
      max: 0.2,
      step: 0.005,
      unit: "m",
    },
    {
      kind: "choice",
      field: "gravity",
      label: "on",
      options: [
        { value: 9.81, label: "Earth" },
        { value: 3.71, label: "Mars" },
        { value: 1.62, label: "the Moon" },
      ],
    },
    {
      kind: "choice",
      field: "beside",
      label: "beside it",
      options: [
        { value: 0, label: "nothing" },
        { value: 1, label: "a ball with k = h₁/h" },
      ],
    },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow(at(0, 0), at(0, 1.62), axis);
    scene.line(at(0, 0), at(LAST + 0.2, 0), { role: "surface", width: 2.5 });
    scene.label(at(0, 1.62), "height, m", { role: "muted", offset: [8, 6] });
    scene.label(at(LAST + 0.2, 0), "t, s", { role: "muted", offset: [0, 36], anchor: "end" });
    for (const t of [1, 2, 3, 4, 5]) {
      scene.line([t, -0.05], [t, 0.05], axis);
      scene.label([t, 0], pretty(t), {
        role: "muted",
        offset: [0, 19],
        anchor: "middle",
        size: "small",
      });
    }
    for (const y of [0.5, 1, 1.5]) {
      scene.line([-0.05, HIGH * y], [0.05, HIGH * y], axis);
      scene.label(at(0, y), pretty(y), {
        role: "muted",
        offset: [-8, 4],
        anchor: "end",
        size: "small",
      });
    }
    if (output.problem) return;

    if (input.beside) {
      scene.path(curve(output.wrong_moment, output.wrong_path), {
        role: "miss",
        width: 2,
        dashed: true,
      });
      scene.dot(at(output.wrong_peak_time[0] ?? 0, output.wrong_peak[0] ?? 0), "miss", 4, true);
      if (output.wrong_end < 0.9 * LAST) {
        scene.dot(at(output.wrong_end, 0), "miss", 5, true);
        scene.label(at(output.wrong_end, 0), `k = h₁/h: ${pretty(output.wrong_end, 3)} s`, {
          role: "miss",
          offset: [0, 36],
          anchor: "middle",
        });
      }
    }
    scene.path(curve(output.moment, output.path), { role: "ball", width: 2.2 });
    if (output.end < LAST + 0.2) {
      scene.line(at(output.end, 0), at(LAST + 0.2, 0), { role: "ball", width: 3 });
      scene.line(at(output.end, -0.3), at(output.end, 1.1), {
        role: "hit",
        width: 1.5,
        dashed: true,
      });
      scene.label(at(output.end, 1.1), `end: ${pretty(output.end, 3)} s`, {
        role: "hit",
        offset: [0, -8],
        anchor: output.end > 4.2 ? "end" : "middle",
      });
    }
    for (const t of output.impact) if (t < LAST + 0.2) scene.dot(at(t, 0), "hit", 2.5);
    if (input.rest_height > 0) {
      const to = Math.min(LAST + 0.2, output.rest_from);
      scene.line(at(0, input.rest_height), at(LAST + 0.2, input.rest_height), {
        role: "c",
        width: 1,
        dashed: true,
      });
      scene.label(at(LAST + 0.2, input.rest_height), "ε", {
        role: "c",
        offset: [0, -6],
        anchor: "end",
      });
      if (output.rest_from < LAST) {
        scene.dot(at(to, 0), "c", 5, true);
        scene.label(at(to, 0), "rests", {
          role: "c",
          offset: [0, -14],
          anchor: "middle",
          size: "small",
        });
      }
    }
    scene.dot(at(output.now, output.height_now), "ray", 6);
  },
  values: (_input, output) => [
    { name: "k", meaning: "√(h₁ / h)", value: output.k, role: "a" },
    {
      name: "h₁/h",
      meaning: `with this as k the ball rises to ${pretty(output.wrong_peak[0] ?? 0, 2)} m`,
      value: output.wrong_k,
      role: "miss",
    },
    { name: "w", meaning: "speed at the first impact", value: output.speed, unit: "m/s" },
    { name: "T_end", meaning: "end of all bounces", value: output.end, unit: "s", role: "hit" },
    { name: "n", meaning: "impacts until t", value: output.bounces, role: "ray" },
    { name: "y", meaning: "height at t", value: output.height_now, unit: "m", role: "ray" },
    { name: "√(2gε)", meaning: "rest speed", value: output.rest_speed, unit: "m/s", role: "c" },
    { name: "n_rest", meaning: "impacts if it rests early", value: output.rest_bounces, role: "c" },
  ],
  describe(input, output) {
    if (!Number.isFinite(output.end)) return "Nothing is lost, so the ball bounces for ever.";
    if (input.time >= output.end)
      return `After ${pretty(output.end, 3)} s the ball has touched the floor infinitely often and rests.`;
    const impacts = output.bounces === 1 ? "impact" : "impacts";
    return `${pretty(output.bounces, 3)} ${impacts} until ${pretty(input.time, 3)} s; all of them, infinitely many, are over after ${pretty(output.end, 3)} s.`;
  },
});
