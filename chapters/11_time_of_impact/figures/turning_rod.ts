// A rod that moves and turns towards a wall or a disc. Above: one advance, and how far the rod can
// get in it. Below: the distance over time, with all advances and the samples at equal times.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  target: number;
  from: Vec2;
  to: Vec2;
  angle: number;
  turns: number;
  wall: number;
  disc: Vec2;
  towards: number;
  exponent: number;
  step: number;
  samples: number;
}

interface Output {
  half_thickness: number;
  disc_radius: number;
  tolerance: number;
  approach: number;
  advances: number;
  ended: number;
  time: number;
  times: readonly number[];
  distances: readonly number[];
  shown: number;
  ends: readonly number[];
  on_axis: Vec2;
  on_target: Vec2;
  now: number;
  distance: number;
  next_time: number;
  next_ends: readonly number[];
  samples: number;
  sampled: readonly number[];
  sampled_distances: readonly number[];
  sampled_ends: readonly number[];
  overlapping: number;
  first_overlap: number;
  curve: readonly number[];
  touches: number;
  touch_time: number;
  touch_ends: readonly number[];
  touch_point: Vec2;
}

const [WALL, DISC] = [0, 1];
const [TOUCHES, CLEAR] = [0, 1];
const TOWARDS_WALL = 1;
/** The room of the rod. */
const LOW = -0.3;
const HIGH = 4.1;
const WIDE = 4.2;
/** The graph: where the times 0 and 1 and the distance 0 are, m of the picture per m, and the
 * largest distance that is drawn. */
const START = -3.3;
const END = 3.9;
const ZERO = -3.5;
const SCALE = 0.6;
const LARGEST = 4.4;
const SMALLEST = -0.6;

const point = (numbers: readonly number[], i: number): Vec2 => [
  numbers[2 * i] ?? 0,
  numbers[2 * i + 1] ?? 0,
];
const short = (value: number): string => pretty(value, 3);
/** Where a time and a distance are in the graph. */
const plot = (time: number, distance: number): Vec2 => [
  START + (END - START) * time,
  ZERO + SCALE * Math.max(SMALLEST, Math.min(distance, LARGEST)),
];

/** The outline of all points within a radius of a segment. */
function capsule(ends: readonly number[], radius: number): Vec2[] {
  const [start, end] = [point(ends, 0), point(ends, 1)];
  const angle = Math.atan2(end[1] - start[1], end[0] - start[0]);
  const half = (centre: Vec2, first: number): Vec2[] =>
    Array.from({ length: 17 }, (_, i): Vec2 => {
      const at = first + (i * Math.PI) / 16;
      return [centre[0] + radius * Math.cos(at), centre[1] + radius * Math.sin(at)];
    });
  return [...half(end, angle - Math.PI / 2), ...half(start, angle + Math.PI / 2)];
}

function rod(
  scene: Scene,
  ends: readonly number[],
  radius: number,
  style: { readonly role: Role; readonly fill: number; readonly dashed?: boolean },
): void {
  const outline = capsule(ends, radius);
  scene.face(outline, { role: style.role, fill: style.fill, outline: false });
  const line = { role: style.role, width: 1.5, dashed: style.dashed ?? false };
  scene.path([...outline, ...outline.slice(0, 1)], line);
}

function target(scene: Scene, { target, wall, disc }: Input, { disc_radius }: Output): void {
  if (target === DISC) {
    scene.ball(disc, disc_radius, { role: "surface", fill: 0.5 });
    return;
  }
  const right = Math.max(wall, WIDE + 0.5);
  const corners: Vec2[] = [
    [wall, LOW],
    [right, LOW],
    [right, HIGH],
    [wall, HIGH],
  ];
  scene.face(corners, { role: "surface", fill: 0.35, outline: false });
  scene.line([wall, LOW], [wall, HIGH], { role: "surface", width: 2.5 });
}

function world(scene: Scene, input: Input, output: Output): void {
  const thick = output.half_thickness;
  scene.arrow(input.from, input.to, { role: "b", width: 1.2, dashed: true });
  for (let k = 0; k <= output.samples; k++) {
    const ends = output.sampled_ends.slice(4 * k, 4 * k + 4);
    const overlaps = (output.sampled_distances[k] ?? 1) <= 0;
    rod(scene, ends, thick, { role: overlaps ? "miss" : "muted", fill: 0.06, dashed: true });
  }
  if (output.distance > 0 && !(input.towards === TOWARDS_WALL && input.target === WALL)) {
    // Cut off where the graph begins.
    const outline = capsule(output.ends, thick + output.distance).map(
      ([x, y]): Vec2 => [x, Math.max(y, LOW - 0.15)],
    );
    scene.face(outline, { role: "normal", fill: 0.14, outline: false });
    scene.path([...outline, ...outline.slice(0, 1)], { role: "normal", width: 1.2, dashed: true });
  }
  if (output.touches) {
    rod(scene, output.touch_ends, thick, { role: "hit", fill: 0 });
    scene.dot(output.touch_point, "hit", 5);
  }
  rod(scene, output.next_ends, thick, { role: "ray", fill: 0.12 });
  rod(scene, output.ends, thick, { role: "ray", fill: 0.65 });
  scene.line(output.on_axis, output.on_target, { role: "normal", width: 2 });
}

/** The advances: from each distance down to 0 as steeply as the bound, and up to the next one. */
function advances(scene: Scene, output: Output): void {
  for (let i = 0; i < output.advances; i++) {
    const [time, distance] = [output.times[i] ?? 0, output.distances[i] ?? 0];
    const last = i + 1 === output.advances;
    const next = last ? output.time : (output.times[i + 1] ?? 0);
    const role = i + 1 === output.shown ? "ray" : "normal";
    if (next > time) {
      const low = last ? Math.max(0, distance - output.approach * (next - time)) : 0;
      scene.line(plot(time, distance), plot(next, low), { role, width: role === "ray" ? 2.5 : 1 });
      if (!last)
        scene.line(plot(next, 0), plot(next, output.distances[i + 1] ?? 0), {
          role: "muted",
          width: 1,
          dashed: true,
        });
    }
    scene.dot(plot(time, distance), role, role === "ray" ? 5 : 3);
  }
}

function graph(scene: Scene, output: Output): void {
  scene.line(plot(0, 0), plot(1, 0), { role: "muted", width: 1.2 });
  scene.line(plot(0, 0), plot(0, LARGEST), { role: "muted", width: 1.2 });
  const small = { role: "muted", size: "small" } as const;
  scene.label(plot(0, LARGEST), "distance, m", { ...small, offset: [-4, -8] });
  scene.label(plot(1, 0), "fraction of the step", { ...small, offset: [0, 32], anchor: "end" });
  scene.label(plot(0, 0), "0", { ...small, offset: [-6, 4], anchor: "end" });
  for (const metres of [2, 4])
    scene.label(plot(0, metres), String(metres), { ...small, offset: [-6, 4], anchor: "end" });
  const size = output.curve.length;
  const curve = output.curve.map((distance, i) => plot(i / (size - 1), distance));
  scene.path(curve, { role: "ink", width: 1.5 });
  if (output.touches) {
    scene.dot(plot(output.touch_time, 0), "hit", 5);
    scene.label(plot(output.touch_time, 0), "touch", {
      role: "hit",
      size: "small",
      offset: [0, 18],
      anchor: "middle",
    });
  }
  advances(scene, output);
  for (let k = 0; k <= output.samples; k++) {
    const at = plot(output.sampled[k] ?? 0, output.sampled_distances[k] ?? 0);
    scene.dot(at, (output.sampled_distances[k] ?? 1) <= 0 ? "miss" : "muted", 4.5, true);
  }
}

const point_grip = (field: "from" | "to", label: string) =>
  ({ kind: "point", field, label, role: "b", step: 0.1, limit: [-4, 4] }) as const;

export default defineFigure<Input, Output>({
  title: "A turning rod: conservative advancement, and samples that pass the touch",
  view: { kind: "2d", x: [-4.2, 4.2], y: [-4.7, 4.2] },
  aspect: 0.92,
  initial: {
    target: WALL,
    from: [-2.6, 2.1],
    to: [0.5, 1.7],
    angle: 90,
    turns: 1.5,
    wall: 1.1,
    disc: [1, 1],
    towards: 0,
    exponent: -2,
    step: 1,
    samples: 4,
  },
  handles: [
    point_grip("to", "end of the path of the rod’s centre"),
    point_grip("from", "start of the rod’s centre"),
    {
      kind: "slide",
      field: "wall",
      label: "position of the wall, m",
      role: "surface",
      at: ({ target, wall }): Vec2 => (target === WALL ? [wall, 0.2] : [Number.NaN, 0]),
      along: (): Vec2 => [1, 0],
      step: 0.1,
      limit: [-3, 4],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "step",
      label: "advance",
      min: 1,
      max: 60,
      step: 1,
      play: 30,
    },
    { kind: "slider", field: "turns", label: "turns", min: -3, max: 3, step: 0.05 },
    { kind: "slider", field: "samples", label: "slices", min: 1, max: 30, step: 1 },
    {
      kind: "choice",
      field: "target",
      label: "target",
      options: [
        { value: WALL, label: "wall" },
        { value: DISC, label: "disc" },
      ],
    },
    {
      kind: "choice",
      field: "towards",
      label: "bound",
      options: [
        { value: 0, label: "in all directions" },
        { value: TOWARDS_WALL, label: "towards the wall" },
      ],
    },
    {
      kind: "choice",
      field: "exponent",
      label: "tolerance",
      options: [
        { value: -1, label: "0.1 m" },
        { value: -2, label: "0.01 m" },
        { value: -3, label: "0.001 m" },
      ],
    },
    { kind: "numbers", field: "angle", label: "angle at the start", step: 15, unit: "°" },
    { kind: "numbers", field: "from", label: "start", role: "b", step: 0.1 },
    { kind: "numbers", field: "to", label: "end", role: "b", step: 0.1 },
    { kind: "numbers", field: "disc", label: "disc", role: "surface", step: 0.1 },
  ],
  draw(scene, input, output) {
    if (output.problem) {
      scene.arrow(input.from, input.to, { role: "b", width: 1.2, dashed: true });
      return;
    }
    target(scene, input, output);
    world(scene, input, output);
    scene.line([-9, LOW - 0.15], [9, LOW - 0.15], { role: "ghost", width: 1 });
    graph(scene, output);
  },
  values(_input, output): Value[] {
    const { shown, advances, now, distance, approach, next_time, ended, time } = output;
    return [
      {
        name: "advance",
        meaning: `starts at t = ${short(now)} of the step`,
        value: `${shown} of ${advances}`,
        role: "ray",
      },
      { name: "d", meaning: "distance at t", value: distance, unit: "m", role: "normal" },
      {
        name: "μ",
        meaning: "no two points approach by more in a step",
        value: approach,
        unit: "m",
        role: "normal",
      },
      {
        name: "t + d/μ",
        meaning: shown < advances ? "no touch before this time" : "the search has ended at",
        value: next_time,
        role: "ray",
      },
      {
        name: "result",
        meaning:
          ended === TOUCHES
            ? `closer than ${output.tolerance} m`
            : ended === CLEAR
              ? "no touch in the step"
              : "too many advances",
        value: time,
      },
      {
        name: "touch",
        meaning: "the first one",
        value: output.touches ? output.touch_time : "none",
        role: "hit",
      },
      {
        name: "samples",
        meaning:
          output.overlapping > 0
            ? `overlap; the first after ${short(output.first_overlap)}`
            : "overlap",
        value: `${output.overlapping} of ${output.samples + 1}`,
        ...(output.touches && output.overlapping === 0 ? { role: "miss" as const } : {}),
      },
    ];
  },
  describe(_input, output) {
    const { advances, ended, time, touches, touch_time, overlapping, samples } = output;
    if (touches && touch_time === 0) return "The rod touches its target at the start.";
    const steps = advances === 1 ? "One advance" : `${advances} advances`;
    const end = advances === 1 ? "ends" : "end";
    const before = touches
      ? `before the touch at ${pretty(touch_time, 4)}`
      : `where the rod is closer than ${output.tolerance} m, but it never touches`;
    const found =
      ended === TOUCHES
        ? `${steps} ${end} at ${pretty(time, 4)} of the step, ${before}`
        : ended === CLEAR
          ? `${steps} prove${advances === 1 ? "s" : ""} that there is no touch in the step`
          : `${steps} reach only ${pretty(time, 4)} of the step`;
    if (!touches) return `${found}.`;
    return overlapping === 0
      ? `${found}; the samples miss the touch: none of the ${samples + 1} overlaps.`
      : `${found}; ${overlapping} of the ${samples + 1} samples overlap.`;
  },
});
