// A bullet and a plate, or two moving discs: the times that slices, bisection and exact arithmetic
// give for their first touch, and the starts from which slices miss it.

import { defineFigure, pretty, type Scene, type Value, type Vec2 } from "@contact/figure";

interface Input {
  target: number;
  from: Vec2;
  to: Vec2;
  radius: number;
  thickness: number;
  other_from: Vec2;
  other_to: Vec2;
  other_radius: number;
  slices: number;
  halvings: number;
  time: number;
}

interface Output {
  at: Vec2;
  other_at: Vec2;
  plate_low: Vec2;
  plate_high: Vec2;
  grown: readonly number[];
  slices: number;
  tested: readonly number[];
  overlaps: readonly number[];
  bullet: readonly number[];
  other: readonly number[];
  sliced: number;
  sliced_time: number;
  previous_free: number;
  interpolated_time: number;
  bisected: number;
  free_time: number;
  hit_time: number;
  halvings: number;
  halved: readonly number[];
  halved_overlaps: readonly number[];
  touches: number;
  time: number;
  leaves: number;
  touch_centre: Vec2;
  touch_other: Vec2;
  touch_point: Vec2;
  normal: Vec2;
  at_start: number;
  swept_meets: number;
  parts: number;
  missed_low: readonly number[];
  missed_high: readonly number[];
  shift: Vec2;
  missed: number;
}

const [PLATE, DISC] = [0, 1];
/** Under the bodies, one line of time for each method: where 0 and 1 are, and the heights. */
const START = -2.9;
const END = 4.7;
const LINES = { slices: -1.75, bisection: -2.65, exact: -3.55 } as const;
/** Half the height of a test's mark. */
const MARK = 0.17;

const plus = (v: Vec2, w: Vec2, times = 1): Vec2 => [v[0] + times * w[0], v[1] + times * w[1]];
const point = (numbers: readonly number[], i: number): Vec2 => [
  numbers[2 * i] ?? 0,
  numbers[2 * i + 1] ?? 0,
];
const points = (numbers: readonly number[]): Vec2[] =>
  Array.from({ length: numbers.length / 2 }, (_, i) => point(numbers, i));
/** Where a time is on a line of time. */
const across = (time: number): number => START + (END - START) * time;
const time = (value: number): string => pretty(value, 3);

function rectangle([x1, y1]: Vec2, [x2, y2]: Vec2): Vec2[] {
  return [
    [x1, y1],
    [x2, y1],
    [x2, y2],
    [x1, y2],
  ];
}

/** The starts from which the slices miss: the outlines of one slice, for each slice. */
function missedStarts(scene: Scene, output: Output): void {
  const size = output.missed_low.length / 2;
  for (let part = 0; part < output.parts; part++) {
    const low = points(output.missed_low.slice(part * size, (part + 1) * size));
    const high = points(output.missed_high.slice(part * size, (part + 1) * size));
    const outline = [...low, ...high.reverse()];
    for (let k = 0; k < output.slices; k++) {
      const moved = outline.map((at) => plus(at, output.shift, k));
      scene.face(moved, { role: "miss", fill: 0.22, outline: false });
    }
  }
}

function bodies(scene: Scene, input: Input, output: Output): void {
  const { target, from, to, radius, other_from, other_to, other_radius } = input;
  const outline = points(output.grown);
  scene.path([...outline, ...outline.slice(0, 1)], { role: "surface", width: 1.2, dashed: true });
  scene.arrow(from, to, { role: "b", width: 1.2, dashed: true });
  if (target === DISC) scene.arrow(other_from, other_to, { role: "a", width: 1.2, dashed: true });
  for (let k = 0; k <= output.slices; k++) {
    const overlaps = output.overlaps[k] === 1;
    const style = { role: overlaps ? "hit" : "muted", fill: overlaps ? 0.3 : 0.12 } as const;
    scene.ball(point(output.bullet, k), radius, style);
    if (target === DISC) scene.ball(point(output.other, k), other_radius, style);
  }
  if (target === DISC) scene.ball(output.other_at, other_radius, { role: "a", fill: 0.45 });
  scene.ball(output.at, radius, { role: "b", fill: 0.6 });
  if (!output.touches) return;
  scene.ball(output.touch_centre, radius, { role: "ray", fill: 0 });
  if (target === DISC) scene.ball(output.touch_other, other_radius, { role: "ray", fill: 0 });
  scene.dot(output.touch_point, "ray", 5);
  scene.arrow(output.touch_point, plus(output.touch_point, output.normal, 0.7), {
    role: "ray",
    width: 2,
  });
}

/** A line of time with its name, and the time at which the method finds the touch. */
function line(scene: Scene, name: string, y: number, found: number | undefined, text: string) {
  scene.line([START, y], [END, y], { role: "muted", width: 1 });
  scene.label([START, y], name, { role: "ink", offset: [-8, 4], anchor: "end", size: "small" });
  const role = name === "exact" ? "ray" : found === undefined ? "miss" : "hit";
  const at = across(found ?? 0.5);
  scene.label([at, y], text, { role, offset: [0, -11], anchor: "middle", size: "small" });
  if (found !== undefined)
    scene.line([at, y - 1.3 * MARK], [at, y + 1.3 * MARK], { role, width: 3 });
}

function tests(scene: Scene, y: number, times: readonly number[], overlaps: readonly number[]) {
  times.forEach((tested, i) => {
    const at: Vec2 = [across(tested), y];
    if (overlaps[i] === 1) scene.dot(at, "hit", 3.5);
    else scene.dot(at, "muted", 3, true);
  });
}

function lines(scene: Scene, { time: now }: Input, output: Output): void {
  const top = LINES.slices + 2 * MARK;
  const low = LINES.exact - 2 * MARK;
  if (output.touches) {
    const width = Math.max(output.leaves, output.time + 0.002);
    scene.face(rectangle([across(output.time), low], [across(width), top]), {
      role: "ray",
      fill: 0.22,
      outline: false,
    });
  }
  scene.line([across(now), low], [across(now), top], { role: "b", width: 1.2, dashed: true });
  const missed = output.touches ? "misses the touch" : "no touch";
  const sliced = output.sliced ? output.sliced_time : undefined;
  line(scene, "slices", LINES.slices, sliced, sliced === undefined ? missed : time(sliced));
  tests(
    scene,
    LINES.slices,
    output.tested.slice(0, output.slices + 1),
    output.overlaps.slice(0, output.slices + 1),
  );
  const hit = output.bisected ? output.hit_time : undefined;
  line(
    scene,
    "bisection",
    LINES.bisection,
    hit,
    hit === undefined ? "has no slice to halve" : time(hit),
  );
  tests(scene, LINES.bisection, output.halved.slice(0, output.halvings), output.halved_overlaps);
  const exact = output.touches ? output.time : undefined;
  line(scene, "exact", LINES.exact, exact, exact === undefined ? "no touch" : time(exact));
  for (const [at, text] of [
    [0, "0"],
    [1, "1"],
  ] as const)
    scene.label([across(at), low], text, {
      role: "muted",
      offset: [0, 12],
      anchor: "middle",
      size: "small",
    });
  scene.label([across(0.5), low], "fraction of the step", {
    role: "muted",
    offset: [0, 12],
    anchor: "middle",
    size: "small",
  });
}

const grip = (
  field: "from" | "to" | "other_from" | "other_to",
  label: string,
  role: "a" | "b",
  from?: "from" | "other_from",
) =>
  ({
    kind: "point",
    field,
    label,
    role,
    ...(from ? { from } : {}),
    step: 0.1,
    limit: [-5, 5],
  }) as const;

/** Of the bullet. */
const SHOT = { from: [-3.6, 0.4], to: [4.4, 1.4], radius: 0.3 } as const;

export default defineFigure<Input, Output>({
  title: "A bullet and a plate: slices, bisection, and the exact time",
  view: { kind: "2d", x: [-5.2, 5.2], y: [-4.3, 3.7] },
  aspect: 1.3,
  initial: {
    target: PLATE,
    ...SHOT,
    thickness: 0.4,
    other_from: [2.6, -0.4],
    other_to: [-1.4, 2.4],
    other_radius: 0.5,
    slices: 3,
    halvings: 5,
    time: 0,
  },
  handles: [
    grip("to", "end of the bullet’s path", "b"),
    grip("from", "start of the bullet", "b"),
    {
      kind: "slide",
      field: "thickness",
      label: "thickness of the plate, m",
      role: "surface",
      at: ({ target }, { plate_high, plate_low }): Vec2 =>
        target === PLATE
          ? [plate_high[0], (plate_high[1] + plate_low[1]) / 2 + 1]
          : [Number.NaN, 0],
      along: (): Vec2 => [0.5, 0],
      step: 0.05,
      limit: [0.05, 4],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "time",
      label: "time",
      min: 0,
      max: 1,
      step: 0.005,
      play: 4,
    },
    { kind: "slider", field: "slices", label: "slices", min: 1, max: 40, step: 1 },
    { kind: "slider", field: "halvings", label: "halvings", min: 0, max: 20, step: 1 },
    {
      kind: "choice",
      field: "target",
      label: "target",
      options: [
        { value: PLATE, label: "plate at rest" },
        { value: DISC, label: "moving disc" },
      ],
    },
    {
      kind: "states",
      label: "Bullet",
      options: [
        { label: "through the plate", fields: { target: PLATE, ...SHOT, slices: 3 } },
        {
          label: "past its corner",
          fields: { target: PLATE, from: [-3.6, 2.24], to: [4.4, 3.04], radius: 0.3, slices: 10 },
        },
        {
          label: "paths that cross at different times",
          fields: {
            target: DISC,
            from: [-3.6, 0.4],
            to: [4.4, 1.4],
            other_from: [2.2, 0],
            other_to: [1.8, 2.9],
            slices: 3,
          },
        },
      ],
    },
    { kind: "numbers", field: "from", label: "start", role: "b", step: 0.1 },
    { kind: "numbers", field: "to", label: "end", role: "b", step: 0.1 },
    { kind: "numbers", field: "radius", label: "radius", role: "b", step: 0.05, unit: "m" },
    { kind: "numbers", field: "thickness", label: "thickness", step: 0.05, unit: "m" },
    { kind: "numbers", field: "other_from", label: "disc, start", role: "a", step: 0.1 },
    { kind: "numbers", field: "other_to", label: "disc, end", role: "a", step: 0.1 },
    {
      kind: "numbers",
      field: "other_radius",
      label: "disc, radius",
      role: "a",
      step: 0.05,
      unit: "m",
    },
  ],
  draw(scene, input, output) {
    if (output.problem) {
      scene.arrow(input.from, input.to, { role: "b", width: 1.2, dashed: true });
      return;
    }
    missedStarts(scene, output);
    if (output.parts > 0)
      scene.label([-5.1, 3.4], "coloured: starts from which the slices miss it", {
        role: "miss",
        size: "small",
      });
    if (input.target === PLATE)
      scene.face(rectangle(output.plate_low, output.plate_high), { role: "surface", fill: 0.8 });
    bodies(scene, input, output);
    // Under the lines of time nothing of the bodies is visible.
    lines(scene, input, output);
  },
  values(_input, output): Value[] {
    const { sliced, sliced_time, previous_free, interpolated_time, bisected, free_time, hit_time } =
      output;
    return [
      {
        name: "slices",
        meaning: sliced ? "the first one that ends in an overlap" : "none ends in an overlap",
        value: sliced ? sliced_time : "–",
        role: sliced ? "hit" : "miss",
      },
      {
        name: "put back",
        meaning: "to the test before that overlap",
        value: sliced ? previous_free : "–",
      },
      {
        name: "interpolated",
        meaning: "between these two tests, by their gaps",
        value: sliced ? interpolated_time : "–",
      },
      {
        name: "bisection",
        meaning: bisected ? "free at the first, overlapping at the second" : "has nothing to halve",
        value: bisected ? `${pretty(free_time, 4)} … ${pretty(hit_time, 4)}` : "–",
        role: bisected ? "hit" : "miss",
      },
      {
        name: "exact",
        meaning: output.at_start ? "they touch at the start" : "the first touch",
        value: output.touches ? output.time : "none",
        role: "ray",
      },
      {
        name: "swept",
        meaning: "the volumes that both sweep in the step",
        value: output.swept_meets ? "meet" : "do not meet",
      },
      {
        name: "contact",
        meaning: "the point on both surfaces at the touch, m",
        value: output.touches ? output.touch_point : "–",
      },
    ];
  },
  describe({ target, from }, output) {
    const many = output.slices === 1 ? "One slice" : `${output.slices} slices`;
    if (!output.touches)
      return target === PLATE
        ? "The bullet does not touch the plate in this step: the path of its centre does not enter the dashed outline, the plate grown by the bullet’s radius."
        : `The bullet and the disc do not touch in this step: their centres are never as close as the sum of their radii.${output.swept_meets ? " The volumes that they sweep meet, because each passes the crossing at another time." : ""}`;
    const exact = `They first touch after ${time(output.time)} of the step`;
    if (output.missed)
      return `${exact}, and ${many.toLowerCase()} miss${output.slices === 1 ? "es" : ""} this touch: the start (${pretty(from[0], 3)}, ${pretty(from[1], 3)}) is in the coloured region, from which no test sees an overlap.`;
    return `${exact}. ${many} show${output.slices === 1 ? "s" : ""} an overlap at ${time(output.sliced_time)}, and ${output.halvings} halvings narrow that down to ${time(output.hit_time)}.`;
  },
});
