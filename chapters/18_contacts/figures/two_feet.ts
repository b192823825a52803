// A box that falls onto two of its corners: what three methods for its two contacts make of it, side
// by side, with the velocities of both corners after the impact.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  restitution: number;
  friction: number;
  tilt: number;
  sideways: number;
  right_first: number;
  time: number;
}

interface Output {
  mass: number;
  inertia: number;
  lever_arms: readonly number[];
  b: readonly number[];
  impulses: readonly number[];
  before: readonly number[];
  after: readonly number[];
  angular_velocity: readonly number[];
  energy: readonly number[];
  box: readonly number[];
  angle: readonly number[];
  sunk: readonly number[];
  alike: number;
}

const METHODS: readonly { readonly name: string; readonly role: Role }[] = [
  { name: "one by one", role: "miss" },
  { name: "one point", role: "b" },
  { name: "all at once", role: "hit" },
];
const SIDES = ["left", "right"] as const;
/** Middles of the three drawings, m apart, and half the width of their ground. */
const FIRST = 1.05;
const APART = 2.45;
const HALF = 1.12;
/** Length of an arrow for 1 m/s. */
const ARROW = 0.17;
/** The three axes at the bottom: their starts, length, height, and what they measure. */
const AXIS = { y: -1.55, long: 1.8 } as const;
const AXES = [
  { field: "restitution", name: "restitution e", low: 0, high: 1 },
  { field: "tilt", name: "tilt, degrees", low: -9, high: 9 },
  { field: "friction", name: "friction μ", low: 0, high: 1 },
] as const;

const between = (low: number, value: number, high: number): number =>
  Math.max(low, Math.min(high, value));
const middle = (method: number): number => FIRST + APART * method;
const startOf = (axis: number): number => middle(axis) - AXIS.long / 2;
const onAxis = (axis: number, value: number): Vec2 => {
  const { low, high } = AXES[axis] ?? { low: 0, high: 1 };
  return [startOf(axis) + (AXIS.long * between(0, value - low, high - low)) / (high - low), AXIS.y];
};
const small = { role: "muted", size: "small" } as const;

function drawing(scene: Scene, method: number, { time }: Input, output: Output): void {
  const { name, role } = METHODS[method] ?? { name: "", role: "ink" as const };
  const x = middle(method);
  const ground: Vec2[] = [
    [x - HALF, -0.12],
    [x + HALF, -0.12],
    [x + HALF, 0],
    [x - HALF, 0],
  ];
  scene.face(ground, { role: "surface", fill: 0.25, outline: false });
  scene.line([x - HALF, 0], [x + HALF, 0], { role: "surface", width: 2.5 });
  const corners = Array.from({ length: 4 }, (_, i): Vec2 => {
    const at = 2 * (4 * method + i);
    return [x + (output.box[at] ?? 0), output.box[at + 1] ?? 0];
  });
  scene.face(corners, { role, fill: 0.3 });
  for (const at of corners.slice(0, 2)) scene.dot(at, role, 4);
  scene.label([x, 1.72], name, { role, anchor: "middle" });
  if (time < 0) return;
  SIDES.forEach((_, side) => {
    const velocity = output.after[2 * method + side] ?? 0;
    const foot: Vec2 = [x + (output.lever_arms[side] ?? 0), 0];
    const tip: Vec2 = [foot[0], ARROW * velocity];
    if (Math.abs(velocity) > 1e-6) scene.arrow(foot, tip, { role: "ink", width: 2 });
    scene.label(tip, Math.abs(velocity) < 1e-6 ? "0" : pretty(velocity, 2), {
      role: "ink",
      size: "small",
      anchor: "middle",
      offset: [0, velocity < -1e-6 ? 14 : velocity > 1e-6 ? -6 : 20],
    });
  });
}

function axes(scene: Scene): void {
  AXES.forEach(({ name, low, high }, i) => {
    const [from, to] = [onAxis(i, low), onAxis(i, high)];
    scene.line(from, to, { role: "muted", width: 1.5 });
    for (const end of [low, high])
      scene.label(onAxis(i, end), pretty(end), { ...small, anchor: "middle", offset: [0, 20] });
    scene.label([(from[0] + to[0]) / 2, AXIS.y], name, {
      ...small,
      anchor: "middle",
      offset: [0, 34],
    });
  });
}

const grip = (axis: 0 | 1 | 2, label: string, role: Role, step: number) => {
  const { field, low, high } = AXES[axis];
  return {
    kind: "slide",
    field,
    label,
    role,
    at: (input: Input): Vec2 => onAxis(axis, input[field]),
    along: (): Vec2 => [AXIS.long / (high - low), 0],
    step,
    limit: [low, high],
  } as const;
};

export default defineFigure<Input, Output>({
  title: "A box falls onto two of its corners",
  view: { kind: "2d", x: [-0.15, 7.15], y: [-2.15, 1.95] },
  aspect: 1.62,
  initial: { restitution: 0.4, friction: 0, tilt: 0, sideways: 0, right_first: 0, time: 0.12 },
  handles: [
    grip(0, "restitution", "a", 0.01),
    grip(1, "tilt before the impact, degrees", "a", 0.25),
    grip(2, "coefficient of friction", "a", 0.01),
  ],
  controls: [
    {
      kind: "slider",
      field: "time",
      label: "time",
      min: -0.3,
      max: 1.2,
      step: 0.01,
      unit: "s",
      play: 5,
    },
    { kind: "slider", field: "restitution", label: "restitution", min: 0, max: 1, step: 0.01 },
    { kind: "slider", field: "tilt", label: "tilt", min: -9, max: 9, step: 0.25, unit: "°" },
    { kind: "slider", field: "friction", label: "friction μ", min: 0, max: 1, step: 0.01 },
    {
      kind: "slider",
      field: "sideways",
      label: "velocity to the right",
      min: -1.5,
      max: 1.5,
      step: 0.1,
      unit: "m/s",
    },
    {
      kind: "choice",
      field: "right_first",
      label: "first of the list",
      options: [
        { value: 0, label: "left corner" },
        { value: 1, label: "right corner" },
      ],
    },
    {
      kind: "states",
      label: "Box",
      options: [
        {
          label: "falls flat",
          fields: { restitution: 0.4, friction: 0, tilt: 0, sideways: 0, time: 0.12 },
        },
        {
          label: "without loss",
          fields: { restitution: 1, friction: 0, tilt: 0, sideways: 0, time: 0.15 },
        },
        {
          label: "one corner first",
          fields: { restitution: 0.4, friction: 0, tilt: 4, sideways: 0, time: 0.1 },
        },
        {
          label: "slides with friction",
          fields: { restitution: 0, friction: 0.5, tilt: 0, sideways: 1.5, time: 0.5 },
        },
      ],
    },
  ],
  draw(scene, input, output) {
    if (output.problem) return;
    METHODS.forEach((_, method) => {
      drawing(scene, method, input, output);
    });
    axes(scene);
  },
  values(_input, output): Value[] {
    const of = (method: number, numbers: readonly number[]): readonly number[] =>
      numbers.slice(2 * method, 2 * method + 2);
    return [
      { name: "v", meaning: "of the corners before: left, right, m/s", value: output.before },
      ...METHODS.map(
        ({ name, role }, method): Value => ({
          name: `v'_${method + 1}`,
          meaning: `after: ${name}`,
          value: of(method, output.after),
          role,
        }),
      ),
      {
        name: "ω'",
        meaning: "angular velocities after, rad/s",
        value: output.angular_velocity,
      },
      { name: "E'/E", meaning: "kinetic energy after, over before", value: output.energy },
      { name: "angle", meaning: "of the three boxes now, degrees", value: output.angle },
      { name: "sunk", meaning: "deepest corner so far, m", value: output.sunk },
      { name: "x", meaning: "impulses of all at once, μ = 0, N·s", value: output.impulses },
    ];
  },
  describe({ restitution, tilt, right_first }, output) {
    const e = pretty(restitution, 2);
    if (output.alike)
      return `With a tilt of ${pretty(tilt, 3)}° one corner alone meets the ground, and all three methods give it the same impulse; they differ when the other corner follows.`;
    const turn = Math.abs(output.angular_velocity[0] ?? 0);
    const [left = 0, right = 0] = output.after;
    const first = SIDES[right_first === 1 ? 1 : 0];
    const closing =
      Math.min(left, right) < -1e-9
        ? ` and leaves the ${SIDES[left < right ? 0 : 1]} corner moving into the ground with ${pretty(-Math.min(left, right), 3)} m/s`
        : "";
    return `The box arrives with 3 m/s and e = ${e}. One contact after the other, the ${first} corner first, makes it rotate with ${pretty(turn, 3)} rad/s${closing}; one contact alone makes it rotate with ${pretty(Math.abs(output.angular_velocity[1] ?? 0), 3)} rad/s; all at once leaves ${pretty(Math.abs(output.angular_velocity[2] ?? 0) < 1e-9 ? 0 : Math.abs(output.angular_velocity[2] ?? 0), 3)} rad/s.`;
  },
});
