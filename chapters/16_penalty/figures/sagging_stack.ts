// Boxes on contact springs: the sag of each contact, and the stack in time steps after gravity is
// switched on.

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
  stiffness: number;
  step: number;
  scheme: number;
  time: number;
}

interface Output {
  boxes: number;
  side: number;
  sag: readonly number[];
  overlap: readonly number[];
  lower: readonly number[];
  top_sag: number;
  moment: readonly number[];
  top: readonly number[];
  limit: number;
  limit_of_one: number;
  slowest: number;
  fastest: number;
  energy: number;
}

const IMPLICIT = 1;
const LAST = 3;
/** The stack: its middle, the ground, and world units for a metre. */
const STACK = { x: 1.5, ground: 2.6, metre: 1.32, half: 0.66 } as const;
/** How far the highest box has sunk over time: where 0 and the last time are. */
const CURVE = { left: 4.5, right: 10.3, zero: 9, deep: 6.9 } as const;
/** The overlap of each contact, from the lowest to the highest. */
const BARS = { left: 4.5, bottom: 3.25, high: 5.5, wide: 0.5 } as const;
/** The axis of the step, s. */
const STEP = { left: 0.8, right: 9.6, y: 0.95 } as const;

const between = (low: number, value: number, high: number): number =>
  Math.max(low, Math.min(high, value));
/** The longest step of the axis. */
const longest = ({ limit_of_one }: Output): number => 1.25 * limit_of_one;
const ofStep = (step: number, output: Output): Vec2 => [
  STEP.left + (STEP.right - STEP.left) * between(0, step / longest(output), 1),
  STEP.y,
];
const small = { role: "muted", size: "small" } as const;
const axis = { role: "muted", width: 1 } as const;

function box(x: number, low: number, half: number, high: number): Vec2[] {
  return [
    [x - half, low],
    [x + half, low],
    [x + half, high],
    [x - half, high],
  ];
}

function stack(scene: Scene, output: Output): void {
  const { x, ground, metre, half } = STACK;
  scene.face(box(x, ground - 0.3, 1.4, ground), { role: "surface", fill: 0.25, outline: false });
  scene.line([x - 1.4, ground], [x + 1.4, ground], { role: "surface", width: 2.5 });
  for (let i = 0; i < output.boxes; i++) {
    const untouched = ground + metre * i * output.side;
    scene.line([x + half + 0.1, untouched], [x + half + 0.4, untouched], axis);
    const low = untouched - metre * (output.lower[i] ?? 0);
    if (low < 0.2 || low > 9) continue; // out of the picture
    const side = metre * output.side;
    scene.face(box(x, low, half, low + side), { role: i % 2 === 0 ? "a" : "b", fill: 0.35 });
  }
  const top = ground + metre * output.boxes * output.side;
  scene.line([x - half - 0.5, top], [x + half + 0.5, top], {
    role: "muted",
    width: 1.2,
    dashed: true,
  });
  scene.label([x, top], "rigid", { ...small, offset: [0, -6], anchor: "middle" });
}

function sinking(scene: Scene, { time, scheme }: Input, output: Output): void {
  const { left, right, zero, deep } = CURVE;
  const across = (t: number): number => left + ((right - left) * t) / LAST;
  /** Of a share of the sag at rest. */
  const down = (share: number): number => zero - ((zero - deep) * between(-0.35, share, 2.4)) / 2;
  scene.line([left, zero], [right, zero], axis);
  scene.line([left, down(-0.35)], [left, down(2.4)], axis);
  scene.label([left, down(-0.35)], "top has sunk by, m", { ...small, offset: [0, -6] });
  scene.line([left, down(1)], [right, down(1)], { role: "ink", width: 1.2, dashed: true });
  scene.label([left, down(1)], pretty(output.top_sag, 2), {
    ...small,
    offset: [-6, 4],
    anchor: "end",
  });
  scene.label([left, zero], "0", { ...small, offset: [-6, 4], anchor: "end" });
  for (const t of [1, 2, 3])
    scene.label([across(t), down(2.4)], `${t} s`, { ...small, offset: [0, 8], anchor: "middle" });
  const role: Role = scheme === IMPLICIT ? "hit" : "ray";
  scene.path(
    output.moment.map((t, i): Vec2 => [across(t), down((output.top[i] ?? 0) / output.top_sag)]),
    { role, width: 2 },
  );
  scene.line([across(time), down(-0.35)], [across(time), down(2.4)], {
    role: "muted",
    width: 1.2,
    dashed: true,
  });
}

function overlaps(scene: Scene, output: Output): void {
  const { left, bottom, high, wide } = BARS;
  const most = output.sag[0] ?? 1;
  /** Of a share of the lowest contact's overlap at rest. */
  const up = (share: number): number =>
    bottom + ((high - bottom) * between(-0.25, share, 2.1)) / 2.1;
  scene.line([left, bottom], [left + 10.4 * wide, bottom], axis);
  scene.label([left, up(2.1)], "overlap of each contact, m", { ...small, offset: [0, -4] });
  scene.label([left, up(1)], pretty(most, 2), { ...small, offset: [-6, 4], anchor: "end" });
  for (let i = 0; i < output.boxes; i++) {
    const x = left + (i + 0.7) * wide;
    const now = up((output.overlap[i] ?? 0) / most);
    scene.face(box(x, Math.min(bottom, now), wide * 0.3, Math.max(bottom, now)), {
      role: now < bottom ? "miss" : "a",
      fill: 0.4,
      outline: false,
    });
    const rest = up((output.sag[i] ?? 0) / most);
    scene.line([x - wide * 0.4, rest], [x + wide * 0.4, rest], { role: "ink", width: 2 });
  }
  scene.label([left + 0.7 * wide, bottom], "lowest", { ...small, offset: [-10, 16] });
}

function steps(scene: Scene, { scheme }: Input, output: Output): void {
  const start = ofStep(0, output);
  const end = ofStep(longest(output), output);
  const implicit = scheme === IMPLICIT;
  const stable = implicit ? end : ofStep(output.limit, output);
  scene.line(start, stable, { role: "hit", width: 4 });
  if (!implicit) scene.line(stable, end, { role: "miss", width: 4 });
  for (const [limit, name] of [
    [output.limit, "stack"],
    [output.limit_of_one, "one box"],
  ] as const) {
    const [x, y] = ofStep(limit, output);
    const role: Role = implicit ? "muted" : "miss";
    scene.line([x, y - 0.22], [x, y + 0.22], { role, width: 2 });
    if (name === "one box" || output.boxes > 1)
      scene.label([x, y], `${name} ${pretty(limit, 2)} s`, {
        role,
        offset: [0, name === "stack" ? -14 : 26],
        anchor: "middle",
        size: "small",
      });
  }
  scene.label(end, "step", { role: "ink", offset: [6, 5], size: "small" });
}

export default defineFigure<Input, Output>({
  title: "A stack on springs sags",
  view: { kind: "2d", x: [0, 10.6], y: [0.2, 9.9] },
  aspect: 1.09,
  initial: { boxes: 6, stiffness: 5000, step: 0.04, scheme: IMPLICIT, time: 3 },
  handles: [
    {
      kind: "slide",
      field: "step",
      label: "length of the step, s",
      role: "b",
      at: ({ step }, output): Vec2 => ofStep(step, output),
      along: (_input, output): Vec2 => [(STEP.right - STEP.left) / longest(output), 0],
      step: 0.001,
      limit: [0.001, 0.5],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "time",
      label: "time",
      min: 0,
      max: LAST,
      step: 0.01,
      unit: "s",
      play: 6,
    },
    { kind: "slider", field: "boxes", label: "boxes", min: 1, max: 10, step: 1 },
    {
      kind: "slider",
      field: "stiffness",
      label: "k",
      min: 2000,
      max: 100000,
      step: 500,
      unit: "N/m",
    },
    { kind: "slider", field: "step", label: "step", min: 0.001, max: 0.15, step: 0.001, unit: "s" },
    {
      kind: "choice",
      field: "scheme",
      label: "scheme",
      options: [
        { value: 0, label: "semi-implicit Euler" },
        { value: IMPLICIT, label: "implicit Euler" },
      ],
    },
    {
      kind: "states",
      label: "Stack",
      options: [
        {
          label: "too long for the stack only",
          fields: { boxes: 6, stiffness: 5000, step: 0.05, scheme: 0, time: 1 },
        },
        { label: "implicit", fields: { boxes: 6, stiffness: 5000, step: 0.05, scheme: IMPLICIT } },
        { label: "ten times stiffer", fields: { stiffness: 50000, step: 0.01 } },
      ],
    },
  ],
  draw(scene, input, output) {
    if (output.problem) return;
    stack(scene, output);
    sinking(scene, input, output);
    overlaps(scene, output);
    steps(scene, input, output);
  },
  values(_input, output): Value[] {
    return [
      {
        name: "d_1",
        meaning: "overlap of the lowest contact at rest",
        value: output.sag[0] ?? 0,
        unit: "m",
      },
      {
        name: `d_${output.boxes}`,
        meaning: "of the highest",
        value: output.sag[output.boxes - 1] ?? 0,
        unit: "m",
      },
      { name: "sum", meaning: "how far the top sinks", value: output.top_sag, unit: "m" },
      {
        name: "now",
        meaning: "overlap of the lowest contact",
        value: output.overlap[0] ?? 0,
        unit: "m",
        role: "a",
      },
      {
        name: "limit",
        meaning: "of semi-implicit Euler for the stack",
        value: output.limit,
        unit: "s",
        role: "miss",
      },
      { name: "limit_1", meaning: "the same for one box", value: output.limit_of_one, unit: "s" },
      {
        name: "periods",
        meaning: "fastest and slowest, s",
        value: [output.fastest, output.slowest],
      },
      {
        name: "E/E_0",
        meaning: "energy of the vibration now, over that at the start",
        value: output.energy,
      },
    ];
  },
  describe({ scheme, step }, output) {
    const lowest = pretty(output.sag[0] ?? 0, 2);
    const n = output.boxes;
    const rest =
      n === 1
        ? `One box sags by ${lowest} m.`
        : `At rest the lowest of ${n} contacts overlaps by ${lowest} m, ${n} times as far as the highest, and the top sinks by ${pretty(output.top_sag, 2)} m.`;
    if (scheme === IMPLICIT)
      return `${rest} With a step of any length implicit Euler comes to rest, also without a damper.`;
    return step > output.limit
      ? `${rest} A step of ${pretty(step, 3)} s is too long for this stack: semi-implicit Euler grows.`
      : `${rest} Semi-implicit Euler with a step of ${pretty(step, 3)} s stays bounded and never comes to rest, since there is no damper.`;
  },
});
