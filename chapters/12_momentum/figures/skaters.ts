// Two skaters push off each other. Above: the position of each, with time upwards. Below: their
// momenta, and the sum, which the push does not change.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  mass_1: number;
  mass_2: number;
  together: number;
  apart: number;
  time: number;
}

interface Output {
  first: number;
  second: number;
  impulse: number;
  first_share: number;
  p_1: number;
  p_2: number;
  p_before: number;
  p_after: number;
  centre_velocity: number;
  x_1: number;
  x_2: number;
  centre: number;
}

const EARLY = -1;
const LATE = 2;
/** How high a second is; where the skaters glide; rows of momentum arrows; kg·m/s in one unit. */
const HIGH = 1.5;
const ICE = -3.3;
const ROWS = [-4.2, -4.9, -5.6] as const;
const PER_UNIT = 60;

const radius = (mass: number): number => 0.06 * Math.sqrt(Math.max(0, Math.min(400, mass)));

export default defineFigure<Input, Output>({
  title: "Two skaters push off",
  view: { kind: "2d", x: [-6, 6], y: [-6, 3.7] },
  aspect: 1.2,
  initial: { mass_1: 80, mass_2: 40, together: 0.4, apart: 1.8, time: 1.2 },
  handles: [
    {
      kind: "slide",
      field: "together",
      label: "v, velocity of both before, m/s",
      role: "muted",
      at: (input): Vec2 => [EARLY * input.together, EARLY * HIGH],
      along: (): Vec2 => [EARLY, 0],
      step: 0.05,
      limit: [-0.9, 0.9],
    },
    {
      kind: "slide",
      field: "apart",
      label: "u, velocity of the second relative to the first, m/s",
      role: "b",
      at: (_input, output): Vec2 => [LATE * output.second, LATE * HIGH],
      along: (_input, output): Vec2 => [LATE * output.first_share, 0],
      step: 0.05,
      limit: [-2, 2],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "mass_1",
      label: "m_1",
      min: 10,
      max: 150,
      step: 1,
      unit: "kg",
    },
    {
      kind: "slider",
      field: "mass_2",
      label: "m_2",
      min: 10,
      max: 150,
      step: 1,
      unit: "kg",
    },
    {
      kind: "slider",
      field: "time",
      label: "t",
      min: EARLY,
      max: LATE,
      step: 0.02,
      unit: "s",
      play: 3,
    },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow([-5.8, 0], [5.8, 0], axis);
    scene.arrow([-5.6, EARLY * HIGH], [-5.6, LATE * HIGH + 0.5], axis);
    scene.label([-5.6, LATE * HIGH + 0.5], "t, s", { role: "muted", offset: [8, 4] });
    scene.label([5.8, 0], "x, m", { role: "muted", offset: [0, 18], anchor: "end" });
    for (const t of [-1, 1, 2]) {
      scene.line([-5.66, t * HIGH], [-5.54, t * HIGH], axis);
      scene.label([-5.6, t * HIGH], pretty(t), {
        role: "muted",
        offset: [8, 4],
        size: "small",
      });
    }
    scene.line([-5.9, ICE], [5.9, ICE], { role: "surface", width: 2 });
    if (output.problem) return;

    const before: Vec2 = [EARLY * input.together, EARLY * HIGH];
    scene.line(before, [0, 0], { role: "muted", width: 3 });
    scene.label(before, "together", {
      role: "muted",
      offset: [input.together > 0 ? -12 : 12, 14],
      anchor: input.together > 0 ? "end" : "start",
      size: "small",
    });
    scene.line([0, 0], [LATE * output.first, LATE * HIGH], { role: "a", width: 3 });
    scene.line([0, 0], [LATE * output.second, LATE * HIGH], { role: "b", width: 3 });
    scene.line(before, [LATE * output.centre_velocity, LATE * HIGH], {
      role: "normal",
      width: 1.5,
      dashed: true,
    });
    const left = output.first <= output.second;
    for (const [velocity, name, role, outer] of [
      [output.first, "v_1", "a", left ? -1 : 1],
      [output.second, "v_2", "b", left ? 1 : -1],
    ] as const) {
      const tip: Vec2 = [LATE * velocity, LATE * HIGH];
      // Beside the line's end, or above it if there is no room.
      const beside = tip[0] * outer < 2;
      scene.label(tip, `${name} = ${pretty(velocity, 2)}`, {
        role,
        offset: beside ? [20 * outer, 5] : [0, -20],
        anchor: beside ? (outer < 0 ? "end" : "start") : outer < 0 ? "start" : "end",
      });
    }

    const { x_1, x_2, centre } = output;
    const t = input.time * HIGH;
    scene.dot([x_1, t], "a", 5).dot([x_2, t], "b", 5).dot([centre, t], "normal", 4, true);
    const r1 = radius(input.mass_1);
    const r2 = radius(input.mass_2);
    const side = output.second >= output.first ? 1 : -1;
    scene.ball([x_1 - side * r1, ICE + r1], r1, { role: "a", fill: 0.3 });
    scene.ball([x_2 + side * r2, ICE + r2], r2, { role: "b", fill: 0.3 });
    scene.dot([centre, ICE], "normal", 5, true);

    const rows = [
      ["p_1", output.p_1, "a"],
      ["p_2", output.p_2, "b"],
      ["sum", output.p_after, "normal"],
    ] as const;
    scene.line([0, ROWS[0] + 0.4], [0, ROWS[2] - 0.4], axis);
    for (const [i, [name, value, role]] of rows.entries()) {
      const y = ROWS[i] ?? 0;
      const tip = value / PER_UNIT;
      if (Math.abs(tip) > 0.05) scene.arrow([0, y], [tip, y], { role, width: 3 });
      else scene.dot([0, y], role, 3);
      scene.label([-5.9, y], name, { role, offset: [0, 5] });
      scene.label([5.9, y], `${pretty(value, 3)} kg·m/s`, { role, offset: [0, 5], anchor: "end" });
    }
  },
  values: (_input, output) => [
    { name: "v_1", meaning: "v − u m₂ / (m₁ + m₂)", value: output.first, unit: "m/s", role: "a" },
    { name: "v_2", meaning: "v + u m₁ / (m₁ + m₂)", value: output.second, unit: "m/s", role: "b" },
    { name: "J", meaning: "on the second; −J on the first", value: output.impulse, unit: "N·s" },
    { name: "p", meaning: "of both, before", value: output.p_before, unit: "kg·m/s" },
    {
      name: "p′",
      meaning: "of both, after",
      value: output.p_after,
      unit: "kg·m/s",
      role: "normal",
    },
    {
      name: "v_c",
      meaning: "of the centre of mass",
      value: output.centre_velocity,
      unit: "m/s",
      role: "normal",
    },
  ],
  describe(input, output) {
    return `The first skater moves at ${pretty(output.first, 3)} m/s and the second at ${pretty(output.second, 3)} m/s; their centre of mass still moves at ${pretty(output.centre_velocity, 3)} m/s, as both did before (${pretty(input.together, 3)} m/s).`;
  },
});
