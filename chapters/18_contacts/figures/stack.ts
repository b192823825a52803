// A stack of boxes with a given number of iterations in each step: what each contact carries, and
// how far the stack sinks when the steps start from 0 and when they start warm.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  boxes: number;
  iterations: number;
  warm: number;
  ratio: number;
  time: number;
}

interface Output {
  boxes: number;
  side: number;
  goal: number;
  lower: readonly number[];
  load: readonly number[];
  weight: readonly number[];
  sunk_from_zero: readonly number[];
  sunk_warm: readonly number[];
  sunk_now: number;
  residual: number;
  needed: number;
}

const LAST = 3;
const MOST = 32;
/** The stack: its middle, the ground, world units for a metre, half a box, and where the bars begin. */
const BOXES = { x: 1.2, ground: 1.75, metre: 0.96, half: 0.45, bar: 2.1, long: 1.7 } as const;
/** How far the top is too low over time: one tick for each power of ten metres. */
const CURVE = { left: 5.35, right: 7.6, bottom: 1.75, top: 5.6, low: -4, high: 1 } as const;
/** The axes with grips: iterations and time. */
const ITERATIONS = { left: 0.5, right: 3.9, y: 0.75 } as const;
const TIME_Y = 0.75;
const FROM_ZERO: Role = "miss";
const WARM: Role = "hit";

const between = (low: number, value: number, high: number): number =>
  Math.max(low, Math.min(high, value));
const small = { role: "muted", size: "small" } as const;
const axis = { role: "muted", width: 1 } as const;
const atTime = (t: number): number => CURVE.left + ((CURVE.right - CURVE.left) * t) / LAST;
const atIterations = (n: number): number =>
  ITERATIONS.left + ((ITERATIONS.right - ITERATIONS.left) * (n - 1)) / (MOST - 1);

function box(left: number, right: number, low: number, high: number): Vec2[] {
  return [
    [left, low],
    [right, low],
    [right, high],
    [left, high],
  ];
}

function stack(scene: Scene, output: Output): void {
  const { x, metre, half, bar, long, ground } = BOXES;
  scene.face(box(x - 0.9, x + 0.9, ground - 0.2, ground), {
    role: "surface",
    fill: 0.25,
    outline: false,
  });
  scene.line([x - 0.9, ground], [x + 0.9, ground], { role: "surface", width: 2.5 });
  const side = metre * output.side;
  const largest = output.weight[0] || 1;
  for (let i = 0; i < output.boxes; i++) {
    const low = ground + metre * (output.lower[i] ?? 0);
    if (low > 1.1)
      scene.face(box(x - half, x + half, low, low + side), { role: i % 2 ? "b" : "a", fill: 0.3 });
    // A bar is where its box would be.
    const y = ground + side * (i + 0.12);
    const right = bar + (long * between(0, output.load[i] ?? 0, 1.1 * largest)) / largest;
    if (right > bar)
      scene.face(box(bar, right, y, y + side * 0.5), { role: "ray", fill: 0.4, outline: false });
    const mark = bar + (long * (output.weight[i] ?? 0)) / largest;
    scene.line([mark, y - 0.06], [mark, y + side * 0.5 + 0.06], { role: "ink", width: 2 });
  }
  const top = ground + side * output.boxes;
  scene.line([x - half - 0.3, top], [x + half + 0.3, top], {
    role: "muted",
    width: 1.2,
    dashed: true,
  });
  scene.label([bar, ground], "load of each contact", { ...small, offset: [0, 16] });
}

function sinking(scene: Scene, { time, warm }: Input, output: Output): void {
  const { left, right, bottom, top, low, high } = CURVE;
  const at = (t: number, metres: number): Vec2 => {
    const power = metres > 0 ? Math.log10(metres) : low;
    return [
      atTime(t),
      bottom + ((top - bottom) * (between(low, power, high) - low)) / (high - low),
    ];
  };
  scene.line([left, bottom], [right, bottom], axis);
  scene.line([left, bottom], [left, top], axis);
  for (const [metres, name] of [
    [1e-3, "1 mm"],
    [1e-2, "1 cm"],
    [0.1, "10 cm"],
    [1, "1 m"],
    [10, "10 m"],
  ] as const) {
    const [x, y] = at(0, metres);
    scene.line([x - 0.08, y], [x, y], axis);
    scene.label([x, y], name, { ...small, anchor: "end", offset: [-7, 4] });
  }
  scene.label([right, top], "top too low by", { ...small, anchor: "end", offset: [0, -24] });
  scene.line(at(0, output.goal), at(LAST, output.goal), { role: "ink", width: 1, dashed: true });
  scene.line([atTime(time), bottom], [atTime(time), top], {
    role: "muted",
    width: 1,
    dashed: true,
  });
  for (const [sunk, role, name, shown] of [
    [output.sunk_from_zero, FROM_ZERO, "from 0", warm < 0.5],
    [output.sunk_warm, WARM, "warm", warm >= 0.5],
  ] as const) {
    const points = sunk.map((y, i) => at((LAST * i) / (sunk.length - 1), y));
    scene.path(points, { role, width: shown ? 3 : 1.5 });
    const end = points.at(-1);
    if (end)
      scene.label(end, name, {
        role,
        size: "small",
        anchor: "end",
        offset: [0, role === FROM_ZERO ? -8 : 16],
      });
  }
}

function axes(scene: Scene): void {
  const { left, right, y } = ITERATIONS;
  scene.line([left, y], [right, y], { role: "muted", width: 1.5 });
  for (const n of [1, MOST])
    scene.label([atIterations(n), y], pretty(n), { ...small, anchor: "middle", offset: [0, 26] });
  scene.label([(left + right) / 2, y], "iterations a step", {
    ...small,
    anchor: "middle",
    offset: [0, 40],
  });
  scene.line([atTime(0), TIME_Y], [atTime(LAST), TIME_Y], { role: "muted", width: 1.5 });
  for (const t of [0, LAST])
    scene.label([atTime(t), TIME_Y], pretty(t), { ...small, anchor: "middle", offset: [0, 26] });
  scene.label([atTime(LAST / 2), TIME_Y], "time, s", {
    ...small,
    anchor: "middle",
    offset: [0, 40],
  });
}

export default defineFigure<Input, Output>({
  title: "A stack of boxes",
  view: { kind: "2d", x: [0, 8], y: [-0.5, 6.9] },
  aspect: 1.09,
  initial: { boxes: 8, iterations: 4, warm: 0, ratio: 1, time: 1.2 },
  handles: [
    {
      kind: "slide",
      field: "time",
      label: "time, s",
      role: "a",
      at: ({ time }): Vec2 => [atTime(time), TIME_Y],
      along: (): Vec2 => [(CURVE.right - CURVE.left) / LAST, 0],
      step: 0.05,
      limit: [0, LAST],
    },
    {
      kind: "slide",
      field: "iterations",
      label: "iterations in each step",
      role: "a",
      at: ({ iterations }): Vec2 => [atIterations(between(1, iterations, MOST)), ITERATIONS.y],
      along: (): Vec2 => [(ITERATIONS.right - ITERATIONS.left) / (MOST - 1), 0],
      step: 1,
      limit: [1, MOST],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "time",
      label: "time",
      min: 0,
      max: LAST,
      step: 0.05,
      unit: "s",
      play: 6,
    },
    { kind: "slider", field: "iterations", label: "iterations a step", min: 1, max: MOST, step: 1 },
    {
      kind: "choice",
      field: "warm",
      label: "start",
      options: [
        { value: 0, label: "from 0" },
        { value: 1, label: "warm: last impulses" },
      ],
    },
    { kind: "slider", field: "boxes", label: "boxes", min: 1, max: 10, step: 1 },
    {
      kind: "slider",
      field: "ratio",
      label: "mass of the top box ÷ mass of another",
      min: 0.1,
      max: 20,
      step: 0.1,
    },
    {
      kind: "states",
      label: "Stack",
      options: [
        { label: "from 0", fields: { boxes: 8, iterations: 4, warm: 0, ratio: 1 } },
        { label: "the same, warm", fields: { boxes: 8, iterations: 4, warm: 1, ratio: 1 } },
        { label: "three boxes", fields: { boxes: 3, iterations: 16, warm: 0, ratio: 1 } },
        { label: "a heavy box on top", fields: { boxes: 8, iterations: 16, warm: 1, ratio: 20 } },
      ],
    },
  ],
  draw(scene, input, output) {
    if (output.problem) return;
    stack(scene, output);
    sinking(scene, input, output);
    axes(scene);
  },
  values({ warm }, output): Value[] {
    return [
      {
        name: "sunk",
        meaning: "the top, now",
        value: output.sunk_now,
        unit: "m",
        role: warm < 0.5 ? FROM_ZERO : WARM,
      },
      {
        name: "load",
        meaning: "impulse of the lowest contact in this step",
        value: output.load[0] ?? 0,
        unit: "N·s",
        role: "ray",
      },
      {
        name: "weight",
        meaning: "load with which the boxes keep their velocity",
        value: output.weight[0] ?? 0,
        unit: "N·s",
      },
      { name: "residual", meaning: "of this step", value: output.residual, unit: "m/s" },
      {
        name: "iterations",
        meaning: "from 0 to a residual of 10⁻⁹ m/s",
        value: output.needed < 0 ? "more than 2,000" : output.needed,
      },
    ];
  },
  describe({ time, iterations }, output) {
    const needed = output.needed < 0 ? "more than 2,000" : pretty(output.needed);
    const last = (sunk: readonly number[]): string => pretty(sunk.at(-1) ?? 0, 2);
    return `With ${pretty(iterations)} iterations in each step, the top of ${pretty(output.boxes)} boxes is ${pretty(output.sunk_now, 2)} m too low after ${pretty(time, 3)} s. After ${LAST} s it is ${last(output.sunk_from_zero)} m if each step starts from 0, and ${last(output.sunk_warm)} m with a warm start. From 0, a residual of 10⁻⁹ m/s takes ${needed} iterations.`;
  },
});
