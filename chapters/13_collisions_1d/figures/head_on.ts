// Two carts collide. Above: the position of each, with time upwards. Below: the kinetic energy
// before and after, and the loss.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  mass_1: number;
  mass_2: number;
  v_1: number;
  v_2: number;
  e: number;
  tested: number;
  time: number;
}

interface Output {
  approach: number;
  after_1: number;
  after_2: number;
  closing: number;
  separation: number;
  impulse: number;
  p: number;
  k_1: number;
  k_2: number;
  after_k_1: number;
  after_k_2: number;
  lost: number;
  fraction: number;
  centre: number;
  x_1: number;
  x_2: number;
  through: number;
}

const EARLY = -1;
const LATE = 1;
/** How high a second is; where the track lies; rows of energy; how wide all energy before is. */
const HIGH = 3;
const TRACK = -4.1;
const ROWS = [-5.2, -6] as const;
const WIDE = 8;
const LEFT = -3.7;

const half = (mass: number): number => 0.04 * Math.sqrt(Math.max(0, Math.min(400, mass)));

export default defineFigure<Input, Output>({
  title: "Two carts collide",
  view: { kind: "2d", x: [-6, 6], y: [-6.6, 3.9] },
  aspect: 1.12,
  initial: { mass_1: 60, mass_2: 20, v_1: 2, v_2: -1, e: 0.5, tested: 1, time: 0.7 },
  handles: [
    {
      kind: "slide",
      field: "v_1",
      label: "v₁, velocity of the first before, m/s",
      role: "a",
      at: (input): Vec2 => [EARLY * input.v_1, EARLY * HIGH],
      along: (): Vec2 => [EARLY, 0],
      step: 0.1,
      limit: [-5, 5],
    },
    {
      kind: "slide",
      field: "v_2",
      label: "v₂, velocity of the second before, m/s",
      role: "b",
      at: (input): Vec2 => [EARLY * input.v_2, EARLY * HIGH],
      along: (): Vec2 => [EARLY, 0],
      step: 0.1,
      limit: [-5, 5],
    },
  ],
  controls: [
    { kind: "slider", field: "mass_1", label: "m_1", min: 5, max: 120, step: 1, unit: "kg" },
    { kind: "slider", field: "mass_2", label: "m_2", min: 5, max: 120, step: 1, unit: "kg" },
    { kind: "slider", field: "e", label: "e", min: 0, max: 1, step: 0.01 },
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
    {
      kind: "choice",
      field: "tested",
      label: "test for approach",
      options: [
        { value: 1, label: "on" },
        { value: 0, label: "off" },
      ],
    },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow([-5.8, 0], [5.8, 0], axis);
    scene.arrow([-5.6, EARLY * HIGH], [-5.6, LATE * HIGH + 0.5], axis);
    scene.label([-5.6, LATE * HIGH + 0.5], "t, s", { role: "muted", offset: [8, 4] });
    scene.label([5.8, 0], "x, m", { role: "muted", offset: [0, 18], anchor: "end" });
    for (const t of [-1, 1]) {
      scene.line([-5.66, t * HIGH], [-5.54, t * HIGH], axis);
      scene.label([-5.6, t * HIGH], pretty(t), { role: "muted", offset: [8, 4], size: "small" });
    }
    scene.line([-5.9, TRACK], [5.9, TRACK], { role: "surface", width: 2 });
    const before_1: Vec2 = [EARLY * input.v_1, EARLY * HIGH];
    const before_2: Vec2 = [EARLY * input.v_2, EARLY * HIGH];
    scene.line(before_1, [0, 0], { role: "a", width: 3 });
    scene.line(before_2, [0, 0], { role: "b", width: 3 });
    if (output.problem) return;

    scene.line([EARLY * output.centre, EARLY * HIGH], [LATE * output.centre, LATE * HIGH], {
      role: "normal",
      width: 1.5,
      dashed: true,
    });
    const room = (x: number): number => Math.max(-5.2, Math.min(5.2, x));
    for (const [velocity, name, role, outer] of [
      [output.after_1, "v_1′", "a", output.through ? 1 : -1],
      [output.after_2, "v_2′", "b", output.through ? -1 : 1],
    ] as const) {
      const tip: Vec2 = [LATE * velocity, LATE * HIGH];
      scene.line([0, 0], tip, { role, width: 3, dashed: Boolean(output.through) });
      const beside = tip[0] * outer < 2.2;
      scene.label([room(tip[0]), tip[1]], `${name} = ${pretty(velocity, 2)}`, {
        role,
        offset: beside ? [12 * outer, -4] : [0, -14],
        anchor: beside ? (outer < 0 ? "end" : "start") : outer < 0 ? "start" : "end",
      });
    }
    if (!output.approach) {
      scene.label([0, 0], output.through ? "through each other!" : "no collision", {
        role: output.through ? "miss" : "muted",
        offset: [12, 18],
      });
    }

    const t = input.time * HIGH;
    scene.dot([output.x_1, t], "a", 5).dot([output.x_2, t], "b", 5);
    for (const [x, side, mass, role] of [
      [output.x_1, -1, input.mass_1, "a"],
      [output.x_2, 1, input.mass_2, "b"],
    ] as const) {
      const h = half(mass);
      const near = x;
      const far = x + 2 * side * h;
      scene.face(
        [
          [near, TRACK],
          [far, TRACK],
          [far, TRACK + 2 * h],
          [near, TRACK + 2 * h],
        ],
        { role, fill: 0.3 },
      );
    }

    const whole = output.k_1 + output.k_2;
    if (!(whole > 0)) return;
    const lost = Math.max(0, whole - output.after_k_1 - output.after_k_2);
    for (const [row, name, parts] of [
      [ROWS[0], "K before", [output.k_1, output.k_2, 0]],
      [ROWS[1], "K after", [output.after_k_1, output.after_k_2, lost]],
    ] as const) {
      scene.label([-5.9, row], name, { role: "muted", offset: [0, 4], size: "small" });
      let from = LEFT;
      for (const [i, part] of parts.entries()) {
        const to = from + (part / whole) * WIDE;
        if (to - from > 0.01) {
          scene.face(
            [
              [from, row - 0.26],
              [to, row - 0.26],
              [to, row + 0.26],
              [from, row + 0.26],
            ],
            {
              role: i === 0 ? "a" : i === 1 ? "b" : "miss",
              fill: i === 2 ? 0.12 : 0.35,
              dashed: i === 2,
            },
          );
        }
        from = to;
      }
      if (row === ROWS[1] && lost / whole > 0.12) {
        scene.label([from - ((lost / whole) * WIDE) / 2, row], "lost", {
          role: "miss",
          offset: [0, 4],
          anchor: "middle",
          size: "small",
        });
      }
    }
  },
  values: (input, output) => [
    { name: "w", meaning: "closing speed, v₁ − v₂", value: output.closing, unit: "m/s" },
    { name: "w′", meaning: "speed of separation", value: output.separation, unit: "m/s" },
    { name: "J", meaning: "on the second", value: output.impulse, unit: "N·s" },
    {
      name: "p",
      meaning: "of both, before and after",
      value: output.p,
      unit: "kg·m/s",
      role: "normal",
    },
    { name: "ΔK", meaning: "½ μ (1 − e²) w²", value: output.lost, unit: "J", role: "miss" },
    {
      name: "ΔK/K",
      meaning: `while 1 − e² is ${pretty(1 - input.e * input.e, 3)}`,
      value: output.fraction,
    },
  ],
  describe(input, output) {
    if (output.through)
      return `The bodies separate at ${pretty(-output.closing, 3)} m/s already. Without the test the formula sends them through each other.`;
    if (!output.approach) return "The bodies do not approach, so nothing happens.";
    return `They approach at ${pretty(output.closing, 3)} m/s and separate at ${pretty(output.separation, 3)} m/s, ${pretty(input.e, 3)} times as fast; ${pretty(100 * output.fraction, 3)} % of the kinetic energy is lost.`;
  },
});
