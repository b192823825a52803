// A force–time curve drawn by hand, and below it the velocity that results. A longer duration
// stretches the curve: the same shape in a longer time has a larger area.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  drawn: readonly number[];
  duration: number;
  mass: number;
  speed: number;
  beside: number;
}

interface Output {
  time: readonly number[];
  force: readonly number[];
  split_time: readonly number[];
  split_force: readonly number[];
  impulse: number;
  average: number;
  largest: number;
  before: number;
  change: number;
  after: number;
  to_stop: number;
  moment: readonly number[];
  velocity_at: readonly number[];
  peak_impulse: number;
  peak_after: number;
  peak_at: readonly number[];
}

/** The axis of the velocity lies below that of the force; ten metres a second are one unit high. */
const LOW = -4.4;
const low = (velocity: number): number => LOW + Math.max(-26, Math.min(26, velocity)) / 10;
const END = 10.3;

/** The numbers that are drawn; at the two ends the force is 0. */
const POINTS = 31;
const share = (index: number): number => (index + 1) / (POINTS + 1);
const hill = (index: number): number =>
  Math.round(280 * Math.sin(Math.PI * share(index)) ** 2) / 100;

export default defineFigure<Input, Output>({
  title: "The area under a force–time curve",
  view: { kind: "2d", x: [-0.9, 10.9], y: [-7.3, 4.7] },
  aspect: 1.02,
  initial: {
    drawn: Array.from({ length: POINTS }, (_, index) => hill(index)),
    duration: 8,
    mass: 0.5,
    speed: 12,
    beside: 0,
  },
  handles: [
    {
      kind: "stroke",
      field: "drawn",
      label: "force against time, kN",
      role: "ray",
      across: (index, input): number => share(index) * input.duration,
      step: 0.05,
      limit: [-1.5, 4.2],
    },
  ],
  controls: [
    { kind: "slider", field: "duration", label: "T", min: 3, max: 10, step: 0.1, unit: "ms" },
    { kind: "slider", field: "mass", label: "m", min: 0.1, max: 2, step: 0.05, unit: "kg" },
    { kind: "slider", field: "speed", label: "speed", min: 0, max: 20, step: 0.5, unit: "m/s" },
    {
      kind: "choice",
      field: "beside",
      label: "compare the area with",
      options: [
        { value: 0, label: "average force × T" },
        { value: 1, label: "largest force × T" },
      ],
    },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow([0, 0], [END, 0], axis).arrow([0, -1.7], [0, 4.5], axis);
    scene.arrow([0, LOW], [END, LOW], axis).arrow([0, LOW - 2.7], [0, LOW + 2.6], axis);
    for (const t of [2, 4, 6, 8, 10]) {
      scene.line([t, -0.08], [t, 0.08], axis).line([t, LOW - 0.08], [t, LOW + 0.08], axis);
      scene.label([t, LOW], pretty(t), {
        role: "muted",
        offset: [0, 18],
        anchor: "middle",
        size: "small",
      });
    }
    for (const f of [1, 2, 3, 4]) {
      scene.line([-0.08, f], [0.08, f], axis);
      scene.label([0, f], pretty(f), {
        role: "muted",
        offset: [-9, 4],
        anchor: "end",
        size: "small",
      });
    }
    for (const v of [-20, -10, 10, 20]) {
      scene.line([-0.08, low(v)], [0.08, low(v)], axis);
      scene.label([0, low(v)], pretty(v), {
        role: "muted",
        offset: [-9, 4],
        anchor: "end",
        size: "small",
      });
    }
    scene.label([0, 4.4], "F, kN", { role: "ray", offset: [10, 4] });
    scene.label([0, LOW + 2.5], "velocity, m/s", { role: "ball", offset: [10, 4] });
    scene.label([END, 0], "t, ms", { role: "muted", offset: [0, -10], anchor: "end" });
    scene.label([END, LOW], "t, ms", { role: "muted", offset: [0, -10], anchor: "end" });
    if (output.problem) return;

    // The curve has a point where it crosses the axis, so clamping heights at 0 clips it there.
    const curve = output.time.flatMap((t, i): Vec2[] => {
      const split = output.split_time[i];
      const here: Vec2 = [t, output.force[i] ?? 0];
      return split === undefined ? [here] : [here, [split, output.split_force[i] ?? 0]];
    });
    for (const [role, fill, cut] of [
      ["b", 0.22, Math.max],
      ["miss", 0.3, Math.min],
    ] as const) {
      const area = curve.map(([t, f]): Vec2 => [t, cut(0, f)]);
      if (area.some(([, f]) => f !== 0)) scene.face(area, { role, fill, outline: false });
    }
    scene.path(
      output.time.map((t, i): Vec2 => [t, output.force[i] ?? 0]),
      { role: "ray", width: 2.5 },
    );
    const T = input.duration;
    const [high, role, name] = input.beside
      ? ([output.largest, "miss", "largest"] as const)
      : ([output.average, "hit", "average"] as const);
    scene.face(
      [
        [0, 0],
        [0, high],
        [T, high],
        [T, 0],
      ],
      { role, fill: 0, dashed: true },
    );
    scene.label([T, high], name, { role, offset: [8, 4], size: "small" });

    scene.line([T, LOW - 2.6], [T, 0], { role: "muted", width: 1, dashed: true });
    scene.path(
      output.moment.map((t, i): Vec2 => [t, low(output.velocity_at[i] ?? 0)]),
      { role: "ball", width: 2.5 },
    );
    if (input.beside) {
      // The line is clipped at the edge of the plot, with an arrow.
      const line = output.moment
        .map((t, i): Vec2 => [t, output.peak_at[i] ?? 0])
        .filter(([, v]) => Math.abs(v) <= 26)
        .map(([t, v]): Vec2 => [t, low(v)]);
      const leaves = Math.abs(output.peak_after) > 26;
      const end = line[line.length - 1];
      if (line.length > 1 && end) {
        scene.path([[0, low(output.before)], end], {
          role: "miss",
          width: 2,
          dashed: true,
          arrow: leaves,
        });
        if (!leaves) scene.dot(end, "miss", 4, true);
        scene.label(end, `by F_p T: ${pretty(output.peak_after, 3)}`, {
          role: "miss",
          offset: [-10, output.peak_after < 0 ? 14 : -4],
          anchor: "end",
        });
      }
    }
    scene.dot([0, low(output.before)], "ball", 4);
    scene.dot([T, low(output.after)], "ball", 5);
    scene.label([T, low(output.after)], pretty(output.after, 3), {
      role: "ball",
      offset: [8, output.after < 0 ? 16 : -8],
    });
  },
  values: (_input, output) => [
    { name: "J", meaning: "area under the curve", value: output.impulse, unit: "N·s", role: "b" },
    { name: "F_a", meaning: "average, J / T", value: output.average, unit: "kN", role: "hit" },
    { name: "F_p", meaning: "largest force", value: output.largest, unit: "kN", role: "ray" },
    {
      name: "v",
      meaning: "before: minus the speed",
      value: output.before,
      unit: "m/s",
      role: "ball",
    },
    { name: "v′", meaning: "v + J / m", value: output.after, unit: "m/s", role: "ball" },
    { name: "−m v", meaning: "would stop it", value: output.to_stop, unit: "N·s", role: "muted" },
    {
      name: "F_p T",
      meaning: `as J: v′ would be ${pretty(output.peak_after, 3)} m/s`,
      value: output.peak_impulse,
      unit: "N·s",
      role: "miss",
    },
  ],
  describe(input, output) {
    const start = `The force gives ${pretty(output.impulse, 3)} N·s in ${pretty(input.duration, 3)} ms`;
    if (output.after * output.before < 0)
      return `${start}: more than the ${pretty(output.to_stop, 3)} N·s that stop the body, so it moves back at ${pretty(output.after, 3)} m/s.`;
    return `${start}, and the body continues at ${pretty(output.after, 3)} m/s.`;
  },
});
