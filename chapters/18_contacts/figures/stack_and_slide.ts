// Three scenes of many contacts: a stack of boxes with a given number of iterations a step, a box
// that slides to rest, and a row of balls.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  mode: number;
  boxes: number;
  iterations: number;
  warm: number;
  ratio: number;
  speed: number;
  friction: number;
  rate: number;
  balls: number;
  moving: number;
  restitution: number;
  time: number;
}

interface Output {
  boxes: number;
  side: number;
  lower: readonly number[];
  load: readonly number[];
  weight: readonly number[];
  sunk: readonly number[];
  sunk_now: number;
  residual: number;
  needed: number;
  friction: number;
  normal_impulse: number;
  friction_impulse: number;
  position: number;
  velocity: number;
  moment: readonly number[];
  path: readonly number[];
  exact: readonly number[];
  distance: number;
  by_mean: number;
  formula: number;
  duration: number;
  balls: number;
  radius: number;
  one_by_one: readonly number[];
  at_once: readonly number[];
  one_position: readonly number[];
  once_position: readonly number[];
  collisions: number;
  one_energy: number;
  once_energy: number;
  differ: number;
}

const STACK = 0;
const SLIDE = 1;
const ROW = 2;
const LAST = 3;
/** The axis of time, below all scenes. */
const TIME = { left: 0.6, right: 7.4, y: 0.6 } as const;
/** The stack: its middle, the ground, world units for a metre. */
const BOXES = { x: 1.2, ground: 1.6, metre: 0.96, half: 0.45, bar: 2.1 } as const;
/** Curves over time: where 0 is, height, and right end. */
const CURVE = { left: 4.95, right: 7.4, bottom: 2.2, top: 5.6 } as const;
/** The path of the box that slides. */
const PATH = { left: 0.8, right: 6.9, ground: 4.6, bottom: 1.5, top: 3.7 } as const;
const ONE: Role = "miss";
const ONCE: Role = "hit";

const between = (low: number, value: number, high: number): number =>
  Math.max(low, Math.min(high, value));
const small = { role: "muted", size: "small" } as const;
const axis = { role: "muted", width: 1 } as const;
const atTime = (t: number): number => TIME.left + ((TIME.right - TIME.left) * t) / LAST;

function box(left: number, right: number, low: number, high: number): Vec2[] {
  return [
    [left, low],
    [right, low],
    [right, high],
    [left, high],
  ];
}

function ground(scene: Scene, from: number, to: number, y: number): void {
  scene.face(box(from, to, y - 0.2, y), { role: "surface", fill: 0.25, outline: false });
  scene.line([from, y], [to, y], { role: "surface", width: 2.5 });
}

function timeAxis(scene: Scene): void {
  scene.line([TIME.left, TIME.y], [TIME.right, TIME.y], { role: "muted", width: 1.5 });
  for (const t of [0, 1, 2, 3])
    scene.label([atTime(t), TIME.y], `${t} s`, { ...small, anchor: "middle", offset: [0, 24] });
}

function stack(scene: Scene, output: Output): void {
  const { x, metre, half, bar } = BOXES;
  const floor = BOXES.ground;
  ground(scene, x - 0.95, x + 0.95, floor);
  const largest = output.weight[0] || 1;
  for (let i = 0; i < output.boxes; i++) {
    const low = floor + metre * (output.lower[i] ?? 0);
    const side = metre * output.side;
    if (low > 0.9)
      scene.face(box(x - half, x + half, low, low + side), { role: i % 2 ? "b" : "a", fill: 0.3 });
    // Loads stand where the boxes would be.
    const y = floor + side * (i + 0.12);
    const long = (1.7 * between(0, output.load[i] ?? 0, 1.1 * largest)) / largest;
    if (long > 0)
      scene.face(box(bar, bar + long, y, y + side * 0.5), {
        role: "ray",
        fill: 0.4,
        outline: false,
      });
    const right = bar + (1.7 * (output.weight[i] ?? 0)) / largest;
    scene.line([right, y - 0.06], [right, y + side * 0.5 + 0.06], { role: "ink", width: 2 });
  }
  const top = floor + metre * output.boxes * output.side;
  scene.line([x - half - 0.3, top], [x + half + 0.3, top], {
    role: "muted",
    width: 1.2,
    dashed: true,
  });
  scene.label([bar, floor], "load of each contact", { ...small, offset: [0, 16] });
}

function sinking(scene: Scene, { time }: Input, { sunk }: Output): void {
  const { left, right, bottom, top } = CURVE;
  const most = Math.max(...sunk);
  // A round number that holds them.
  const scale =
    [1e-4, 1e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20].find((size) => size >= most) ??
    50;
  const at = (t: number, y: number): Vec2 => [
    left + ((right - left) * t) / LAST,
    top - ((top - bottom) * between(-0.1, y / scale, 1)) / 1.05,
  ];
  scene.line(at(0, 0), at(LAST, 0), axis);
  scene.line(at(0, 0), at(0, scale), axis);
  scene.label(at(0, 0), "top too low by, m", { ...small, offset: [-10, -8] });
  scene.label(at(0, 0), "0", { ...small, anchor: "end", offset: [-5, 4] });
  scene.label(at(0, scale), pretty(scale), { ...small, anchor: "end", offset: [-5, 4] });
  scene.line(at(time, 0), at(time, scale), { role: "muted", width: 1, dashed: true });
  scene.path(
    sunk.map((y, i) => at((LAST * i) / (sunk.length - 1), y)),
    { role: "miss", width: 2.2 },
  );
}

function slide(scene: Scene, { time }: Input, output: Output): void {
  const { left, right, bottom, top } = PATH;
  const floor = PATH.ground;
  const metre = (right - left) / Math.max(output.formula, output.distance, output.by_mean);
  const across = (metres: number): number => left + metre * metres;
  ground(scene, left - 0.6, right + 0.6, floor);
  const x = across(output.position);
  scene.face(box(x - 0.4, x + 0.4, floor, floor + 0.6), { role: "a", fill: 0.35 });
  scene.line([across(output.formula), floor - 0.2], [across(output.formula), floor + 1], {
    role: "hit",
    width: 2,
  });
  scene.label([across(output.formula), floor + 1], "v²/(2μg)", {
    role: "hit",
    size: "small",
    anchor: "end",
    offset: [0, -4],
  });
  // The force of the ground and its cone, from the middle of the contact.
  const tall = 1.25;
  for (const sign of [-1, 1])
    scene.line([x, floor], [x + sign * between(0, output.friction, 1.2) * tall, floor + tall], {
      role: "c",
      width: 1.2,
      dashed: true,
    });
  const share = output.normal_impulse > 0 ? output.friction_impulse / output.normal_impulse : 0;
  scene.arrow([x, floor], [x + share * tall, floor + tall], { role: "ink", width: 2.2 });
  const at = (t: number, metres: number): Vec2 => [
    atTime(t),
    bottom + ((top - bottom) * metres) / Math.max(output.formula, output.distance, output.by_mean),
  ];
  scene.line(at(0, 0), at(LAST, 0), axis);
  scene.line(at(0, 0), at(0, output.formula), axis);
  scene.line(at(0, output.formula), at(LAST, output.formula), { role: "hit", width: 1 });
  scene.label(at(0, output.formula), `${pretty(output.formula, 3)} m`, {
    ...small,
    offset: [0, -5],
  });
  const curve = (numbers: readonly number[]): Vec2[] =>
    numbers.map((metres, i) => at(output.moment[i] ?? 0, metres));
  scene.path(curve(output.exact), { role: "ink", width: 1.4, dashed: true });
  scene.path(curve(output.path), { role: "ray", width: 2.2 });
  scene.line(at(time, 0), at(time, output.formula), { role: "muted", width: 1, dashed: true });
}

function row(
  scene: Scene,
  name: string,
  role: Role,
  y: number,
  { time }: Input,
  { balls, radius }: Output,
  positions: readonly number[],
  velocities: readonly number[],
): void {
  const metre = 2.15;
  scene.line([0.2, y - metre * radius], [7.8, y - metre * radius], { role: "surface", width: 2 });
  scene.label([0.2, y + 1], name, { role });
  for (let i = 0; i < balls; i++) {
    const x = 4 + metre * (positions[i] ?? 0);
    if (x > 0 && x < 8) scene.ball([x, y], metre * radius, { role, fill: 0.35 });
    const velocity = velocities[i] ?? 0;
    if (time < 1) continue;
    const at = 4 + metre * 2 * radius * (i - (balls - 1) / 2);
    if (Math.abs(velocity) > 1e-9)
      scene.arrow([at, y + 0.55], [at + 0.6 * velocity, y + 0.55], { role: "ink", width: 2 });
    scene.label([at, y - metre * radius], pretty(velocity, 2), {
      role: "ink",
      size: "small",
      anchor: "middle",
      offset: [0, 17],
    });
  }
}

export default defineFigure<Input, Output>({
  title: "A stack, a sliding box and a row of balls",
  view: { kind: "2d", x: [0, 8], y: [0, 6.9] },
  aspect: 1.16,
  initial: {
    mode: STACK,
    boxes: 8,
    iterations: 4,
    warm: 0,
    ratio: 1,
    speed: 2,
    friction: 0.3,
    rate: 30,
    balls: 3,
    moving: 1,
    restitution: 1,
    time: 1.2,
  },
  handles: [
    {
      kind: "slide",
      field: "time",
      label: "time, s",
      role: "a",
      at: ({ time }): Vec2 => [atTime(time), TIME.y],
      along: (): Vec2 => [(TIME.right - TIME.left) / LAST, 0],
      step: 0.05,
      limit: [0, LAST],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "mode",
      label: "Scene",
      options: [
        { value: STACK, label: "stack" },
        { value: SLIDE, label: "sliding box" },
        { value: ROW, label: "row of balls" },
      ],
    },
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
    { kind: "slider", field: "boxes", label: "boxes", min: 1, max: 10, step: 1 },
    { kind: "slider", field: "iterations", label: "iterations a step", min: 1, max: 32, step: 1 },
    {
      kind: "choice",
      field: "warm",
      label: "start",
      options: [
        { value: 0, label: "from 0" },
        { value: 1, label: "warm: last impulses" },
      ],
    },
    { kind: "slider", field: "ratio", label: "mass of the top box", min: 0.1, max: 20, step: 0.1 },
    { kind: "slider", field: "speed", label: "v", min: 0.2, max: 4, step: 0.1, unit: "m/s" },
    { kind: "slider", field: "friction", label: "μ", min: 0.1, max: 1, step: 0.05 },
    { kind: "slider", field: "rate", label: "steps a second", min: 10, max: 240, step: 5 },
    { kind: "slider", field: "balls", label: "balls", min: 2, max: 7, step: 1 },
    { kind: "slider", field: "moving", label: "that arrive", min: 1, max: 6, step: 1 },
    { kind: "slider", field: "restitution", label: "restitution", min: 0, max: 1, step: 0.05 },
    {
      kind: "states",
      label: "Show",
      options: [
        { label: "a stack from 0", fields: { mode: STACK, boxes: 8, iterations: 4, warm: 0 } },
        { label: "the same, warm", fields: { mode: STACK, boxes: 8, iterations: 4, warm: 1 } },
        {
          label: "a heavy box on top",
          fields: { mode: STACK, boxes: 8, iterations: 16, warm: 1, ratio: 20 },
        },
        { label: "slide to rest", fields: { mode: SLIDE, time: 0.3 } },
        { label: "one ball hits two", fields: { mode: ROW, balls: 3, moving: 1, time: 1.8 } },
        { label: "a cradle", fields: { mode: ROW, balls: 5, moving: 2, restitution: 1, time: 2 } },
      ],
    },
  ],
  draw(scene, input, output) {
    if (output.problem) return;
    timeAxis(scene);
    if (input.mode === STACK) {
      stack(scene, output);
      sinking(scene, input, output);
    } else if (input.mode === SLIDE) {
      slide(scene, input, output);
    } else if (input.mode === ROW) {
      row(
        scene,
        "one pair after the other",
        ONE,
        5,
        input,
        output,
        output.one_position,
        output.one_by_one,
      );
      row(scene, "all at once", ONCE, 2.7, input, output, output.once_position, output.at_once);
    }
  },
  values({ mode }, output): Value[] {
    if (mode === SLIDE)
      return [
        { name: "x", meaning: "now", value: output.position, unit: "m" },
        { name: "v", meaning: "now", value: output.velocity, unit: "m/s" },
        { name: "d", meaning: "v²/(2μg)", value: output.formula, unit: "m", role: "hit" },
        { name: "d_h", meaning: "in steps", value: output.distance, unit: "m", role: "ray" },
        { name: "d_m", meaning: "in steps, by mean velocities", value: output.by_mean, unit: "m" },
        { name: "t", meaning: "v/(μg)", value: output.duration, unit: "s" },
        {
          name: "normal",
          meaning: "impulse of this step",
          value: output.normal_impulse,
          unit: "N·s",
        },
        { name: "friction", meaning: "of this step", value: output.friction_impulse, unit: "N·s" },
      ];
    if (mode === ROW)
      return [
        {
          name: "after",
          meaning: "one pair after the other, m/s",
          value: output.one_by_one.slice(0, output.balls),
          role: ONE,
        },
        {
          name: "after",
          meaning: "all at once, m/s",
          value: output.at_once.slice(0, output.balls),
          role: ONCE,
        },
        { name: "collisions", meaning: "of pairs", value: output.collisions },
        { name: "E'/E", meaning: "one after the other", value: output.one_energy },
        { name: "E'/E", meaning: "all at once", value: output.once_energy },
      ];
    return [
      { name: "sunk", meaning: "the top, now", value: output.sunk_now, unit: "m", role: "miss" },
      {
        name: "load",
        meaning: "lowest contact in this step",
        value: output.load[0] ?? 0,
        unit: "N·s",
        role: "ray",
      },
      {
        name: "weight",
        meaning: "what it should carry in a step",
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
  describe({ mode, time, iterations, warm, rate }, output) {
    if (mode === SLIDE)
      return `By the formula the box comes to rest after ${pretty(output.formula, 4)} m; in ${pretty(rate)} steps a second after ${pretty(output.distance, 4)} m, because each step moves it with the velocity at its end. The force of the ground is on the edge of the friction cone until then.`;
    if (mode === ROW)
      return output.differ
        ? `One pair after the other ends after ${pretty(output.collisions)} collisions. All contacts at once give other velocities, with the same momentum: a rigid row does not determine them.`
        : "Both give the same velocities.";
    const needed = output.needed < 0 ? "more than 2,000" : pretty(output.needed);
    const start = warm >= 0.5 ? "a warm start" : "a start from 0";
    return `With ${pretty(iterations)} iterations a step and ${start}, the top of ${pretty(output.boxes)} boxes is ${pretty(output.sunk_now, 2)} m too low after ${pretty(time, 3)} s. From 0, a residual of 10⁻⁹ m/s takes ${needed} iterations.`;
  },
});
