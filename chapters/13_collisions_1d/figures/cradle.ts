// Newton's cradle: the velocities of five balls before the impact, set by the reader, and after.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  v_1: number;
  v_2: number;
  v_3: number;
  v_4: number;
  v_5: number;
  middle: number;
  e: number;
  method: number;
}

interface Output {
  after: readonly number[];
  collisions: number;
  settled: number;
  p: number;
  after_p: number;
  kept: number;
  other: readonly number[];
  order_matters: number;
}

const FIELDS = ["v_1", "v_2", "v_3", "v_4", "v_5"] as const;
/** Velocities before and after are columns upwards from these heights; m/s in one unit. */
const BEFORE = 1.6;
const AFTER = -4.6;
const BALLS = -1.5;
const PER_UNIT = 1.25;
const column = (i: number): number => 2 * (i - 2);
const height = (v: number): number => Math.max(-2.6, Math.min(2.6, v)) / PER_UNIT;

export default defineFigure<Input, Output>({
  title: "A row of balls",
  view: { kind: "2d", x: [-6, 6], y: [-7, 4] },
  aspect: 1.1,
  initial: { v_1: 2, v_2: 0, v_3: 0, v_4: 0, v_5: 0, middle: 1, e: 1, method: 0 },
  handles: FIELDS.map((field, i) => ({
    kind: "slide" as const,
    field,
    label: `velocity of ball ${i + 1} before, m/s`,
    role: "a" as const,
    at: (input: Input): Vec2 => [column(i), BEFORE + height(input[field])],
    along: (): Vec2 => [0, 1 / PER_UNIT],
    step: 0.25,
    limit: [-2.5, 2.5] as const,
  })),
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "method",
      options: [
        { value: 0, label: "pairs, fastest first" },
        { value: 1, label: "pairs, from the left" },
        { value: 2, label: "pairs, from the right" },
        { value: 5, label: "all pairs at once" },
        { value: 3, label: "springs" },
        { value: 4, label: "elastic spheres" },
      ],
    },
    { kind: "slider", field: "middle", label: "m_3", min: 0.25, max: 4, step: 0.25 },
    { kind: "slider", field: "e", label: "e of pairs", min: 0.1, max: 1, step: 0.05 },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    for (const [y, text] of [
      [BEFORE, "before, m/s"],
      [AFTER, "after, m/s"],
    ] as const) {
      scene.line([-5.4, y], [5.4, y], axis);
      scene.arrow([-5.4, y - 2.1], [-5.4, y + 2.2], axis);
      scene.label([-5.4, y + 2.2], text, { role: "muted", offset: [8, 4], size: "small" });
      for (const v of [-2, -1, 1, 2]) {
        scene.line([-5.46, y + height(v)], [-5.34, y + height(v)], axis);
        scene.label([-5.4, y + height(v)], pretty(v), {
          role: "muted",
          offset: [-7, 4],
          anchor: "end",
          size: "small",
        });
      }
    }
    const size = (i: number): number => (i === 2 ? Math.cbrt(input.middle) : 1) * 0.4;
    let x = -2 * 0.8 - size(2) + 0.4;
    for (let i = 0; i < 5; ++i) {
      const r = Math.max(0.05, Math.min(1, size(i)));
      x += i === 0 ? 0 : r;
      scene.ball([x, BALLS], r, {
        role: i === 2 && input.middle !== 1 ? "b" : "surface",
        fill: 0.3,
      });
      scene.label([x, BALLS], `${i + 1}`, {
        role: "ink",
        offset: [0, 4],
        anchor: "middle",
        size: "small",
      });
      x += r;
    }
    for (const [i, field] of FIELDS.entries()) {
      const v = input[field];
      if (v !== 0)
        scene.line([column(i), BEFORE], [column(i), BEFORE + height(v)], { role: "a", width: 6 });
    }
    if (output.problem) return;
    for (const [i, v] of output.after.entries()) {
      const tip: Vec2 = [column(i), AFTER + height(v)];
      scene.line([column(i), AFTER], tip, { role: "hit", width: 6 });
      scene.dot(tip, "hit", 3);
      scene.label(tip, pretty(v, 2), {
        role: "hit",
        offset: [0, v < 0 ? 18 : -9],
        anchor: "middle",
        size: "small",
      });
    }
    if (!output.settled)
      scene.label([5.4, AFTER - 2.1], "not settled", { role: "miss", anchor: "end" });
    else if (output.order_matters && input.method < 3)
      scene.label([5.4, AFTER - 2.1], "another order gives another result", {
        role: "miss",
        anchor: "end",
      });
  },
  values: (_input, output) => [
    { name: "n", meaning: "collisions of pairs", value: output.collisions },
    { name: "p", meaning: "before, per mass of an outer ball", value: output.p, unit: "m/s" },
    { name: "p′", meaning: "after", value: output.after_p, unit: "m/s" },
    { name: "K′/K", meaning: "remaining kinetic energy", value: output.kept },
  ],
  describe(_input, output) {
    const list = output.after.map((v) => pretty(v, 2)).join(", ");
    return `The balls leave at ${list} m/s${output.settled ? "" : ", and some still approach"}; ${pretty(100 * output.kept, 3)} % of the kinetic energy remains.`;
  },
});
