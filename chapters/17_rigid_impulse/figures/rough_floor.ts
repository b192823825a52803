// Above: the rod and the velocity of its lower end, before and after. Below: the impulse grows from
// 0, tangential to the sides and normal upwards, within the friction cone.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  top: Vec2;
  tip: Vec2;
  angular_velocity: number;
  friction: number;
  e: number;
  law: number;
}

interface Output {
  centre: Vec2;
  velocity: Vec2;
  along: readonly number[];
  up: readonly number[];
  tip_after: Vec2;
  angular_velocity_after: number;
  asked: number;
  got: number;
  energy: readonly number[];
  end_along: readonly number[];
  end_up: readonly number[];
  stop_from: Vec2;
  stop_to: Vec2;
  turn_from: Vec2;
  turn_to: Vec2;
  stops: number;
  turns: number;
}

const LAWS = ["Newton", "Poisson", "Stronge", "joint", "clamped"];
/** Where the first letters of the names stand beside the ends of the paths. */
const BESIDE = [
  [[10, -3], "start"],
  [[10, 14], "start"],
  [[10, 3], "start"],
  [[-10, 0], "end"],
  [[-10, 6], "end"],
] as const;
/** Where the impulse 0 is, and how long 1 N·s is. */
const ZERO: Vec2 = [0, -4.6];
const PER_IMPULSE = 2.4;
const HIGH = 1.2;

const position = (along: number, up: number): Vec2 => [
  ZERO[0] + PER_IMPULSE * along,
  ZERO[1] + PER_IMPULSE * up,
];

/** The part of a line between two points that lies in the box of the impulses. */
function inBox(from: Vec2, to: Vec2): [Vec2, Vec2] | undefined {
  let low = 0;
  let high = 1;
  const box = [
    [-1.2, 1.2],
    [0, HIGH],
  ] as const;
  for (const [k, [least, most]] of box.entries()) {
    const start = from[k as 0 | 1];
    const step = to[k as 0 | 1] - start;
    if (step === 0) {
      if (start < least || start > most) return undefined;
      continue;
    }
    const a = (least - start) / step;
    const b = (most - start) / step;
    low = Math.max(low, Math.min(a, b));
    high = Math.min(high, Math.max(a, b));
  }
  if (low >= high) return undefined;
  const at = (t: number): Vec2 =>
    position(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]));
  return [at(low), at(high)];
}

export default defineFigure<Input, Output>({
  title: "A rod on a rough floor",
  view: { kind: "2d", x: [-2.9, 2.9], y: [-4.9, 1.9] },
  aspect: 0.9,
  initial: {
    top: [-1.41, 1.41],
    tip: [-0.6, -1],
    angular_velocity: -1,
    friction: 0.5,
    e: 1,
    law: 0,
  },
  handles: [
    {
      kind: "point",
      field: "top",
      label: "upper end of the rod, m",
      role: "surface",
      step: 0.02,
      limit: [-1.8, 1.8],
    },
    {
      kind: "point",
      field: "tip",
      label: "u, velocity of the lower end, m/s",
      role: "a",
      limit: [-2, 2],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "law",
      label: "Law",
      options: [
        { value: 0, label: "Newton: velocities" },
        { value: 1, label: "Poisson: impulses" },
        { value: 2, label: "Stronge: work" },
        { value: 3, label: "joint: Newton, one ratio of impulses" },
        { value: 4, label: "clamped: friction after the normal impulse" },
      ],
    },
    { kind: "slider", field: "friction", label: "μ", min: 0, max: 2, step: 0.05 },
    { kind: "slider", field: "e", label: "e", min: 0, max: 1, step: 0.05 },
    {
      kind: "slider",
      field: "angular_velocity",
      label: "ω",
      min: -4,
      max: 4,
      step: 0.1,
      unit: "rad/s",
    },
  ],
  draw(scene, input, output) {
    scene.line([-2.8, 0], [2.8, 0], { role: "muted", width: 2 });
    scene.line(input.top, [0, 0], { role: "surface", width: 5 });
    scene.arrow([0, 0], input.tip, { role: "a", width: 3 });
    scene.label(input.tip, "u", { role: "a", offset: [-12, 8], anchor: "end" });
    if (output.problem) return;
    scene.dot(output.centre, "ink", 4, true);
    scene.arrow([0, 0], output.tip_after, { role: "b", width: 3 });
    scene.label(output.tip_after, "u′", { role: "b", offset: [12, -6] });

    const axis = { role: "muted", width: 1 } as const;
    scene.arrow(position(-1.15, 0), position(1.2, 0), axis);
    scene.arrow(position(0, 0), position(0, HIGH + 0.05), axis);
    scene.label(position(1.2, 0), "p_t", { role: "muted", offset: [2, -8], anchor: "end" });
    scene.label(position(0, HIGH), "p_n", { role: "muted", offset: [8, 6] });
    for (const side of [-1, 1]) {
      const edge = inBox([0, 0], [side * input.friction * 3, 3]);
      if (edge) scene.line(edge[0], edge[1], { role: "c", width: 1.5 });
    }
    const stop = inBox(output.stop_from, output.stop_to);
    if (stop) {
      scene.line(stop[0], stop[1], { role: "hit", width: 1.5, dashed: true });
      scene.label(stop[1], "no slip", { role: "hit", offset: [6, 14], size: "small" });
    }
    const turn = inBox(output.turn_from, output.turn_to);
    if (turn) {
      scene.line(turn[0], turn[1], { role: "normal", width: 1.5, dashed: true });
      const end = turn[0][0] < turn[1][0] ? turn[0] : turn[1];
      scene.label(end, "end of compression", { role: "normal", offset: [-4, -8], size: "small" });
    }
    const points = output.along.map((p, k): Vec2 => position(p, output.up[k] ?? 0));
    scene.path(points, { role: "b", width: 3 });
    for (const [k, name] of LAWS.entries()) {
      const at = position(output.end_along[k] ?? 0, output.end_up[k] ?? 0);
      if ((output.energy[k] ?? 0) === 0 || at[1] > ZERO[1] + PER_IMPULSE * HIGH) continue;
      const gains = (output.energy[k] ?? 0) > 1.0000001;
      const role: Role = gains ? "miss" : "ink";
      scene.dot(at, k === input.law ? "b" : role, k === input.law ? 6 : 4, k !== input.law);
      const [offset, anchor] = BESIDE[k] ?? BESIDE[0];
      scene.label(at, name.charAt(0).toUpperCase(), { role, offset, anchor, size: "small" });
    }
  },
  values: (input, output) => [
    { name: "u′", meaning: "lower end, after", value: output.tip_after, unit: "m/s", role: "b" },
    { name: "e", meaning: "demanded", value: output.asked },
    {
      name: "−u_n′/u_n",
      meaning: "result",
      value: output.got,
      role: Math.abs(output.got - output.asked) > 1e-9 ? "normal" : "ink",
    },
    ...LAWS.map((name, k) => ({
      name: k === input.law ? `${name} ←` : name,
      meaning: "energy after / before",
      value: output.energy[k] ? `× ${pretty(output.energy[k] ?? 0, 3)}` : "no answer",
      role: ((output.energy[k] ?? 0) > 1.0000001 ? "miss" : "ink") as Role,
    })),
  ],
  describe(input, output) {
    const slip = output.turns
      ? "stops and reverses"
      : output.stops
        ? "stops"
        : "keeps its direction";
    const factor = output.energy[input.law] ?? 0;
    const energy =
      factor === 0
        ? "The rule gives no answer."
        : factor > 1.0000001
          ? `The kinetic energy grows, to ${pretty(factor, 3)} times what it was.`
          : `${pretty(100 * factor, 3)} % of the kinetic energy is left.`;
    return `By the rule “${LAWS[input.law] ?? ""}” the slip ${slip}. ${energy}`;
  },
});
