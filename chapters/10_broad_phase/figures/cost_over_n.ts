// What each broad phase costs over n, on logarithmic axes: steps, which are counted, or times, which
// are measured in the page.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  space: number;
  spread: number;
  density: number;
  shown: number;
  at: number;
  run: number;
  measured_for: number;
  time_ms: readonly number[];
}

interface Output {
  n: number;
  steps: readonly number[];
  times: readonly number[];
  steps_at: readonly number[];
  time_at: readonly number[];
  steps_power: readonly number[];
  time_power: readonly number[];
  touching: number;
  predicted: number;
  quickest: number;
  in_time: number;
}

const METHODS: readonly { readonly name: string; readonly role: Role }[] = [
  { name: "all pairs", role: "miss" },
  { name: "sweep", role: "ray" },
  { name: "grid", role: "ball" },
  { name: "tree", role: "hit" },
];
const SIZES = 9;
const [FIRST, LAST] = [6, 14];
/** In the picture: how wide a doubling of n is, and how tall the plot. */
const WIDE = 1.1;
const TALL = 8;
const TIMES = 1;
/** The powers of ten at the lower and the upper end: of steps, and of ms. */
const RANGES = [
  [1, 8.5],
  [-3, 3],
] as const;
/** Names at the curves' ends are at least so far apart. */
const APART = 0.75;

const counted = (value: number): string => value.toLocaleString("en");
const across = (power: number): number => (power - FIRST) * WIDE;
const powers = [6, 8, 10, 12, 14];
const STEPS = ["1", "10", "10²", "10³", "10⁴", "10⁵", "10⁶", "10⁷", "10⁸"];
const MILLISECONDS = ["0.001", "0.01", "0.1", "1", "10", "100", "1,000"];

/** The height of a cost in the plot. */
function height(cost: number, shown: number): number {
  const [low, high] = RANGES[shown === TIMES ? 1 : 0];
  return (TALL * (Math.log10(cost) - low)) / (high - low);
}

function axes(scene: Scene, shown: number): void {
  const end = across(LAST);
  const [low, high] = RANGES[shown === TIMES ? 1 : 0];
  for (let power = low; power <= high; power++) {
    const y = height(10 ** power, shown);
    scene.line([0, y], [end, y], { role: "ghost", width: 0.8 });
    const text = (shown === TIMES ? MILLISECONDS[power - low] : STEPS[power]) ?? "";
    if (shown === TIMES || power % 2 === 0)
      scene.label([0, y], text, { role: "muted", offset: [-6, 4], anchor: "end", size: "small" });
  }
  for (const power of powers) {
    scene.line([across(power), 0], [across(power), TALL], { role: "ghost", width: 0.8 });
    scene.label([across(power), 0], counted(2 ** power), {
      role: "muted",
      offset: [0, 18],
      anchor: "middle",
      size: "small",
    });
  }
  scene.line([0, 0], [end, 0], { role: "muted", width: 1.2 });
  scene.label([0, TALL], shown === TIMES ? "ms" : "steps", {
    role: "ink",
    offset: [0, -10],
    anchor: "end",
    size: "small",
  });
  scene.label([end, 0], "n", { role: "ink", offset: [34, 18], anchor: "end", size: "small" });
}

function curves(scene: Scene, costs: readonly number[], shown: number): void {
  const ends: { name: string; role: Role; at: Vec2 }[] = [];
  METHODS.forEach(({ name, role }, method) => {
    const points: Vec2[] = [];
    for (let k = 0; k < SIZES; k++) {
      const cost = costs[METHODS.length * k + method] ?? 0;
      if (cost > 0) points.push([across(FIRST + k), height(cost, shown)]);
    }
    if (points.length > 1) scene.path(points, { role, width: 2.2 });
    for (const point of points) scene.dot(point, role, 3.5);
    const at = points.at(-1);
    if (at) ends.push({ name, role, at });
  });
  let free = Number.NEGATIVE_INFINITY;
  for (const { name, role, at } of ends.sort((one, other) => one.at[1] - other.at[1])) {
    free = Math.max(at[1], free + APART);
    scene.label([at[0], free], name, { role, offset: [8, 4], size: "small" });
  }
}

/** n^1.05, or nothing if there is no exponent. */
const power = (exponent: number): string => (exponent === 0 ? "" : `n^${exponent.toFixed(2)}`);

export default defineFigure<Input, Output>({
  title: "Cost of a broad phase over the number of boxes",
  view: { kind: "2d", x: [-1.9, 10.9], y: [-0.9, 8.6] },
  aspect: 1.2,
  initial: {
    space: 0,
    spread: 0,
    density: 1,
    shown: 0,
    at: 10,
    run: 0,
    measured_for: 0,
    time_ms: Array(METHODS.length * SIZES).fill(0),
  },
  handles: [
    {
      kind: "slide",
      field: "at",
      label: "log₂ of the n whose numbers are shown",
      role: "muted",
      at: ({ at }): Vec2 => [across(at), 0],
      along: (): Vec2 => [WIDE, 0],
      step: 1,
      limit: [FIRST, LAST],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "space",
      label: "boxes in",
      options: [
        { value: 0, label: "a cube" },
        { value: 1, label: "a floor" },
        { value: 2, label: "a corridor" },
      ],
    },
    {
      kind: "choice",
      field: "spread",
      label: "edges",
      options: [
        { value: 0, label: "all of 1 m" },
        { value: 1, label: "from 0.25 m to 4 m" },
        { value: 2, label: "1 m, but one box contains all" },
      ],
    },
    {
      kind: "choice",
      field: "density",
      label: "a box of 1 m touches",
      options: [
        { value: 0, label: "0.1 boxes" },
        { value: 1, label: "1 box" },
        { value: 2, label: "10 boxes" },
      ],
    },
    {
      kind: "choice",
      field: "shown",
      label: "show",
      options: [
        { value: 0, label: "steps" },
        { value: 1, label: "times" },
      ],
    },
    {
      kind: "measure",
      field: "time_ms",
      label: "Measure the times here",
      run: "run",
      repeats: "repeats",
      setting: { field: "measured_for", output: "setting" },
    },
    { kind: "slider", field: "at", label: "log₂ n", min: FIRST, max: LAST, step: 1 },
  ],
  draw(scene, { shown, at }, output) {
    axes(scene, shown);
    if (output.problem) return;
    scene.line([across(at), 0], [across(at), TALL], { role: "muted", width: 1, dashed: true });
    if (shown === TIMES && !output.in_time)
      scene.label([across(10), TALL / 2], "Nothing has been measured with these boxes.", {
        role: "muted",
        anchor: "middle",
        size: "small",
      });
    curves(scene, shown === TIMES ? output.times : output.steps, shown);
  },
  values({ shown }, output): Value[] {
    const inTime = shown === TIMES;
    const rows = METHODS.map(({ name, role }, method): Value => {
      const time = output.time_at[method] ?? 0;
      const grows = power((inTime ? output.time_power : output.steps_power)[method] ?? 0);
      return {
        name,
        meaning: grows === "" ? "not measured" : `grows as ${grows}`,
        value: inTime
          ? time > 0
            ? `${pretty(time, 3)} ms`
            : "–"
          : counted(output.steps_at[method] ?? 0),
        role,
      };
    });
    const named = (method: number): string => METHODS[method]?.name ?? "–";
    return [
      { name: "n", meaning: "boxes in this table", value: counted(output.n) },
      ...rows,
      { name: "touching", meaning: "pairs of boxes", value: counted(output.touching) },
      { name: "predicted", meaning: "to be the cheapest", value: named(output.predicted) },
      { name: "quickest", meaning: "as measured here", value: named(output.quickest) },
    ];
  },
  describe({ shown }, output) {
    const inTime = shown === TIMES;
    if (inTime && !output.in_time) return "Press “Measure the times here” to run the methods.";
    const exponents = inTime ? output.time_power : output.steps_power;
    const list = METHODS.map(({ name }, method) => {
      const exponent = exponents[method] ?? 0;
      return `${name} ${exponent === 0 ? "not known yet" : exponent.toFixed(2)}`;
    }).join(", ");
    return `Exponents of n, from n = 512 on, in ${inTime ? "times" : "steps"}: ${list}.${inTime ? "" : " Sorting is not counted."}`;
  },
});
