// Balls that hit a row of balls: what leaves when one pair after the other collides, and when all
// contacts act at once.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  balls: number;
  moving: number;
  restitution: number;
  time: number;
}

interface Output {
  balls: number;
  radius: number;
  impact: number;
  one_after: readonly number[];
  once_after: readonly number[];
  one_position: readonly number[];
  once_position: readonly number[];
  one_velocity: readonly number[];
  once_velocity: readonly number[];
  one_leave: number;
  once_leave: number;
  collisions: number;
  one_energy: number;
  once_energy: number;
  differ: number;
}

interface Row {
  readonly name: string;
  readonly role: Role;
  readonly y: number;
  readonly positions: readonly number[];
  readonly velocities: readonly number[];
  readonly leave: number;
}

const ONE: Role = "miss";
const ONCE: Role = "hit";
const LAST = 1.8;
/** The axis of time. */
const TIME = { left: 0.5, right: 7.5, y: 0.75 } as const;

const between = (low: number, value: number, high: number): number =>
  Math.max(low, Math.min(high, value));
const small = { role: "muted", size: "small" } as const;
const atTime = (t: number): Vec2 => [
  TIME.left + ((TIME.right - TIME.left) * between(0, t, LAST)) / LAST,
  TIME.y,
];

/** World units for a metre: the row with 1.1 m on either side. */
const metre = ({ balls, radius }: Output): number => 7.6 / (2 * radius * balls + 2.2);

function row(scene: Scene, { time }: Input, output: Output, it: Row): void {
  const { name, role, y, positions, velocities, leave } = it;
  const scale = metre(output);
  const radius = scale * output.radius;
  scene.line([0.1, y - radius], [7.9, y - radius], { role: "surface", width: 2 });
  scene.label([0.1, y + 1.25], name, { role });
  if (time >= output.impact)
    scene.label([7.9, y + 1.25], `${leave} of ${output.balls} move`, { role, anchor: "end" });
  for (let i = 0; i < output.balls; i++) {
    const x = 4 + scale * (positions[i] ?? 0);
    const velocity = velocities[i] ?? 0;
    if (x > 7.9) continue; // out of the picture
    scene.ball([x, y], radius, { role, fill: 0.35 });
    const above = y + radius + 0.2;
    if (Math.abs(velocity) > 1e-9)
      scene.arrow([x, above], [x + 0.5 * velocity, above], { role: "ink", width: 2 });
    // In a long row the numbers alternate between two lines.
    const line = output.balls > 3 ? i % 2 : 0;
    scene.label([x, y - radius], Math.abs(velocity) > 1e-9 ? pretty(velocity, 2) : "0", {
      role: "ink",
      size: "small",
      anchor: "middle",
      offset: [0, 16 + 14 * line],
    });
  }
}

function timeAxis(scene: Scene, { impact }: Output): void {
  scene.line(atTime(0), atTime(LAST), { role: "muted", width: 1.5 });
  for (const [t, name] of [
    [0, "0"],
    [impact, "impact"],
    [LAST, `${LAST} s`],
  ] as const)
    scene.label(atTime(t), name, { ...small, anchor: "middle", offset: [0, 26] });
}

export default defineFigure<Input, Output>({
  title: "A row of balls is hit",
  view: { kind: "2d", x: [0, 8], y: [-0.2, 7.3] },
  aspect: 1.08,
  initial: { balls: 5, moving: 1, restitution: 1, time: 0.4 },
  handles: [
    {
      kind: "slide",
      field: "time",
      label: "time, s",
      role: "a",
      at: ({ time }): Vec2 => atTime(time),
      along: (): Vec2 => [(TIME.right - TIME.left) / LAST, 0],
      step: 0.02,
      limit: [0, LAST],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "time",
      label: "time",
      min: 0,
      max: LAST,
      step: 0.02,
      unit: "s",
      play: 4,
    },
    { kind: "slider", field: "balls", label: "balls", min: 2, max: 7, step: 1 },
    { kind: "slider", field: "moving", label: "balls that arrive", min: 1, max: 6, step: 1 },
    { kind: "slider", field: "restitution", label: "restitution e", min: 0, max: 1, step: 0.05 },
    {
      kind: "states",
      label: "Row",
      options: [
        {
          label: "one ball hits two",
          fields: { balls: 3, moving: 1, restitution: 1, time: 1.6 },
        },
        {
          label: "two hit three",
          fields: { balls: 5, moving: 2, restitution: 1, time: 1.6 },
        },
        { label: "one hits one", fields: { balls: 2, moving: 1, restitution: 1, time: 1.6 } },
        {
          label: "with loss",
          fields: { balls: 5, moving: 1, restitution: 0.5, time: 1.6 },
        },
      ],
    },
  ],
  draw(scene, input, output) {
    if (output.problem) return;
    row(scene, input, output, {
      name: "pair by pair",
      role: ONE,
      y: 5.6,
      positions: output.one_position,
      velocities: output.one_velocity,
      leave: output.one_leave,
    });
    row(scene, input, output, {
      name: "all at once",
      role: ONCE,
      y: 2.65,
      positions: output.once_position,
      velocities: output.once_velocity,
      leave: output.once_leave,
    });
    timeAxis(scene, output);
  },
  values({ time }, output): Value[] {
    const { balls } = output;
    const when = time < output.impact ? "before" : "after";
    return [
      {
        name: "v",
        meaning: `${when}, pair by pair, m/s`,
        value: output.one_velocity.slice(0, balls),
        role: ONE,
      },
      {
        name: "v",
        meaning: `${when}, all at once, m/s`,
        value: output.once_velocity.slice(0, balls),
        role: ONCE,
      },
      { name: "collisions", meaning: "of pairs", value: output.collisions },
      { name: "E'/E", meaning: "pair by pair", value: output.one_energy },
      { name: "E'/E", meaning: "all at once", value: output.once_energy },
    ];
  },
  describe({ time }, output) {
    if (time < output.impact)
      return `Balls arrive at 1 m/s. They hit the row after ${output.impact} s. How many balls will move then?`;
    if (!output.differ) return "Both methods give the same velocities.";
    return `If one pair after the other collides, ${output.one_leave} of ${output.balls} balls move afterwards, and the last has ${pretty(output.one_after[output.balls - 1] ?? 0, 2)} m/s. If all contacts act at once, ${output.once_leave} move, and the last has ${pretty(output.once_after[output.balls - 1] ?? 0, 2)} m/s. The momentum is the same.`;
  },
});
