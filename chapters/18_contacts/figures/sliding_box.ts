// A box that slides to rest, seen from above, with the friction cone and with the pyramid: where it
// stops, the friction on it, and its speed.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  speed: number;
  direction: number;
  friction: number;
  rate: number;
  mean: number;
  time: number;
}

interface Output {
  formula: number;
  duration: number;
  moment: readonly number[];
  cone_path: readonly number[];
  pyramid_path: readonly number[];
  cone_speed: readonly number[];
  pyramid_speed: readonly number[];
  cone_position: readonly number[];
  pyramid_position: readonly number[];
  cone_velocity: readonly number[];
  pyramid_velocity: readonly number[];
  cone_friction: readonly number[];
  pyramid_friction: readonly number[];
  cone_stop: readonly number[];
  pyramid_stop: readonly number[];
  cone_distance: number;
  pyramid_distance: number;
  pyramid_aside: number;
  cone_stops: readonly number[];
  pyramid_stops: readonly number[];
}

const CONE: Role = "hit";
const PYRAMID: Role = "miss";
const LAST = 1.2;
const FASTEST = 3.2;
/** The ground from above: the start, world units for a metre, half a box, and the ends of the tangents. */
const MAP = { x: 0.7, y: 2.55, metre: 2.2, half: 0.2, end: 4 } as const;
/** An arrow for 1 m/s, in world units. */
const ARROW = 0.4;
/** The friction over the normal impulse: the middle, and world units for 1. */
const BOUND = { x: 6.65, y: 5.55, one: 1.1 } as const;
/** The speeds over time. */
const CURVE = { left: 5.6, right: 7.7, bottom: 2.15, top: 3.6 } as const;
/** The three axes at the bottom: their length and height, and what they measure. */
const AXIS = { y: 0.85, long: 1.9 } as const;
const AXES = [
  { field: "speed", name: "speed, m/s", low: 0.5, high: FASTEST, left: 0.4 },
  { field: "direction", name: "direction, °", low: 0, high: 90, left: 3.05 },
  { field: "friction", name: "friction μ", low: 0.3, high: 1, left: 5.7 },
] as const;

const between = (low: number, value: number, high: number): number =>
  Math.max(low, Math.min(high, value));
const small = { role: "muted", size: "small" } as const;
const axis = { role: "muted", width: 1 } as const;
const onMap = (x: number, y: number): Vec2 => [MAP.x + MAP.metre * x, MAP.y + MAP.metre * y];
const pointOf = ([x = 0, y = 0]: readonly number[]): Vec2 => onMap(x, y);
const pointsOf = (numbers: readonly number[]): Vec2[] =>
  Array.from({ length: numbers.length / 2 }, (_, i) => pointOf(numbers.slice(2 * i, 2 * i + 2)));
const onAxis = (which: 0 | 1 | 2, value: number): Vec2 => {
  const { low, high, left } = AXES[which];
  return [left + (AXIS.long * between(0, value - low, high - low)) / (high - low), AXIS.y];
};

function square([x, y]: Vec2, half: number): Vec2[] {
  return [
    [x - half, y - half],
    [x + half, y - half],
    [x + half, y + half],
    [x - half, y + half],
  ];
}

function map(scene: Scene, output: Output): void {
  const start = onMap(0, 0);
  scene.line(start, [MAP.x + MAP.end, MAP.y], axis);
  scene.line(start, [MAP.x, MAP.y + MAP.end], axis);
  for (const metres of [0.5, 1, 1.5]) {
    const [x, y] = onMap(metres, 0);
    scene.line([x, y - 0.07], [x, y + 0.07], axis);
    scene.label([x, y], `${metres} m`, { ...small, anchor: "middle", offset: [0, 18] });
    const [across, up] = onMap(0, metres);
    scene.line([across - 0.07, up], [across + 0.07, up], axis);
  }
  scene.path(pointsOf(output.cone_stops), { role: CONE, width: 1.2, dashed: true });
  scene.path(pointsOf(output.pyramid_stops), { role: PYRAMID, width: 1.2, dashed: true });
  scene.face(square(start, MAP.half), { role: "muted", fill: 0, dashed: true });
  for (const [path, position, velocity, stop, role] of [
    [
      output.pyramid_path,
      output.pyramid_position,
      output.pyramid_velocity,
      output.pyramid_stop,
      PYRAMID,
    ],
    [output.cone_path, output.cone_position, output.cone_velocity, output.cone_stop, CONE],
  ] as const) {
    scene.path(pointsOf(path), { role, width: 2 });
    scene.dot(pointOf(stop), role, 4);
    const now = pointOf(position);
    scene.face(square(now, MAP.half), { role, fill: 0.3 });
    const [x = 0, y = 0] = velocity;
    if (x * x + y * y > 1e-6)
      scene.arrow(now, [now[0] + ARROW * x, now[1] + ARROW * y], { role, width: 2.2 });
  }
  // The legend is above all that can be drawn.
  for (const [down, name, metres, role] of [
    [0, "v²/(2μg)", output.formula, "ink"],
    [16, "cone", output.cone_distance, CONE],
    [32, "pyramid", output.pyramid_distance, PYRAMID],
  ] as const)
    scene.label([0.25, 7.55], `${name}: ${pretty(metres, 3)} m`, {
      role,
      size: "small",
      offset: [0, down],
    });
}

function bounds(scene: Scene, { friction }: Input, output: Output): void {
  const { x, y, one } = BOUND;
  const radius = one * between(0, friction, 1.1);
  scene.face(square([x, y], radius), { role: PYRAMID, fill: 0.1 });
  scene.ball([x, y], radius, { role: CONE, fill: 0.15 });
  scene.line([x - 1.2, y], [x + 1.2, y], axis);
  scene.line([x, y - 1.2], [x, y + 1.2], axis);
  for (const [force, role] of [
    [output.pyramid_friction, PYRAMID],
    [output.cone_friction, CONE],
  ] as const) {
    const [along = 0, across = 0] = force;
    if (along * along + across * across > 1e-6)
      scene.arrow([x, y], [x + one * along, y + one * across], { role, width: 2.4 });
  }
  scene.label([x, 7.15], "friction ÷ load", { ...small, anchor: "middle" });
}

function speeds(scene: Scene, { time, speed }: Input, output: Output): void {
  const { left, right, bottom, top } = CURVE;
  const at = (t: number, v: number): Vec2 => [
    left + ((right - left) * t) / LAST,
    bottom + ((top - bottom) * between(0, v, FASTEST)) / FASTEST,
  ];
  scene.line([left, bottom], [right, bottom], axis);
  scene.line([left, bottom], [left, top], axis);
  scene.label([left, top], pretty(FASTEST), { ...small, anchor: "end", offset: [-5, 4] });
  scene.label([left, top], "speed, m/s", { ...small, offset: [-6, -10] });
  scene.label([left, bottom], "0", { ...small, anchor: "middle", offset: [0, 16] });
  scene.label(at(1, 0), "1 s", { ...small, anchor: "middle", offset: [0, 16] });
  scene.line(at(0, speed), at(output.duration, 0), { role: "ink", width: 1, dashed: true });
  for (const [curve, role] of [
    [output.pyramid_speed, PYRAMID],
    [output.cone_speed, CONE],
  ] as const)
    scene.path(
      curve.map((v, i) => at(output.moment[i] ?? 0, v)),
      { role, width: 2 },
    );
  scene.line(at(time, 0), at(time, FASTEST), { role: "muted", width: 1, dashed: true });
}

function axes(scene: Scene): void {
  for (const which of [0, 1, 2] as const) {
    const { name, low, high } = AXES[which];
    const [from, to] = [onAxis(which, low), onAxis(which, high)];
    scene.line(from, to, { role: "muted", width: 1.5 });
    for (const end of [low, high])
      scene.label(onAxis(which, end), pretty(end), { ...small, anchor: "middle", offset: [0, 26] });
    scene.label([(from[0] + to[0]) / 2, AXIS.y], name, {
      ...small,
      anchor: "middle",
      offset: [0, 40],
    });
  }
}

const grip = (which: 0 | 1 | 2, label: string, step: number) => {
  const { field, low, high } = AXES[which];
  return {
    kind: "slide",
    field,
    label,
    role: "a",
    at: (input: Input): Vec2 => onAxis(which, input[field]),
    along: (): Vec2 => [AXIS.long / (high - low), 0],
    step,
    limit: [low, high],
  } as const;
};

export default defineFigure<Input, Output>({
  title: "A box slides to rest",
  view: { kind: "2d", x: [0, 8], y: [-0.4, 7.95] },
  aspect: 1,
  initial: { speed: 3, direction: 25, friction: 0.5, rate: 120, mean: 1, time: 0.2 },
  handles: [
    grip(0, "speed at the start, m/s", 0.1),
    grip(1, "direction from the first tangent, degrees", 1),
    grip(2, "coefficient of friction", 0.05),
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
      play: 4,
    },
    {
      kind: "slider",
      field: "speed",
      label: "speed v",
      min: 0.5,
      max: FASTEST,
      step: 0.1,
      unit: "m/s",
    },
    {
      kind: "slider",
      field: "direction",
      label: "direction",
      min: 0,
      max: 90,
      step: 1,
      unit: "°",
    },
    { kind: "slider", field: "friction", label: "friction μ", min: 0.3, max: 1, step: 0.05 },
    { kind: "slider", field: "rate", label: "steps a second", min: 5, max: 240, step: 5 },
    {
      kind: "choice",
      field: "mean",
      label: "moved by",
      options: [
        { value: 1, label: "mean velocity of a step" },
        { value: 0, label: "velocity after a step" },
      ],
    },
    {
      kind: "states",
      label: "Box",
      options: [
        {
          label: "along a tangent",
          fields: { speed: 3, direction: 0, friction: 0.5, rate: 120, mean: 1 },
        },
        {
          label: "along the diagonal",
          fields: { speed: 3, direction: 45, friction: 0.5, rate: 120, mean: 1 },
        },
        {
          label: "obliquely",
          fields: { speed: 3, direction: 25, friction: 0.5, rate: 120, mean: 1 },
        },
        { label: "few steps", fields: { speed: 3, friction: 0.5, rate: 10, mean: 0 } },
      ],
    },
  ],
  draw(scene, input, output) {
    if (output.problem) return;
    map(scene, output);
    bounds(scene, input, output);
    speeds(scene, input, output);
    axes(scene);
  },
  values(_input, output): Value[] {
    return [
      { name: "d", meaning: "v²/(2μg)", value: output.formula, unit: "m" },
      {
        name: "d_1",
        meaning: "distance in steps, cone",
        value: output.cone_distance,
        unit: "m",
        role: CONE,
      },
      {
        name: "d_2",
        meaning: "distance in steps, pyramid",
        value: output.pyramid_distance,
        unit: "m",
        role: PYRAMID,
      },
      { name: "t", meaning: "v/(μg)", value: output.duration, unit: "s" },
      {
        name: "x_1",
        meaning: "stops at, cone, m",
        value: output.cone_stop,
        role: CONE,
      },
      {
        name: "x_2",
        meaning: "stops at, pyramid, m",
        value: output.pyramid_stop,
        role: PYRAMID,
      },
      {
        name: "beside",
        meaning: "how far the pyramid's box stops from the straight line",
        value: Math.abs(output.pyramid_aside),
        unit: "m",
        role: PYRAMID,
      },
    ];
  },
  describe({ speed, friction, direction }, output) {
    const start = `At ${pretty(speed, 3)} m/s with μ = ${pretty(friction, 3)} the box stops after ${pretty(output.cone_distance, 4)} m with the cone, and by the formula after ${pretty(output.formula, 4)} m.`;
    const pyramid = `With the pyramid and a start at ${pretty(direction, 3)}° from the first tangent, it stops after ${pretty(output.pyramid_distance, 4)} m`;
    const aside = Math.abs(output.pyramid_aside);
    return aside < 1e-9
      ? `${start} ${pyramid}, on the straight line.`
      : `${start} ${pyramid}, ${pretty(aside, 2)} m to one side of the straight line.`;
  },
});
