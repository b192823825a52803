// A ray and a box: bars show when the ray is in each slab, and small squares and red dots from which
// starts it hits the box and where the chosen method is wrong about it.

import {
  defineFigure,
  floatOrDouble,
  pretty,
  type Role,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  low: Vec2;
  high: Vec2;
  origin: Vec2;
  through: Vec2;
  z: readonly number[];
  segment: number;
  method: number;
  divided: number;
  single: number;
}

interface Output {
  box_low: Vec2;
  box_high: Vec2;
  first_quotient: readonly number[];
  second_quotient: readonly number[];
  slab_some: readonly number[];
  slab_entry: readonly number[];
  slab_exit: readonly number[];
  passes: number;
  entry: number;
  exit: number;
  entry_axis: number;
  exit_axis: number;
  hit: number;
  inside: number;
  t: number;
  point: Vec2;
  normal: Vec2;
  says: readonly number[];
  wrong: readonly number[];
  finds: readonly number[];
  method_entry: readonly number[];
  method_exit: readonly number[];
  seen: readonly number[];
  missed: readonly number[];
  starts_wrong: number;
}

const METHODS = ["the book’s", "with division", "branchless", "padded"];
const AXES = ["x", "y", "z"];
const ROLES: readonly Role[] = ["a", "b", "c"];
/** The grid of starts, as in the C++, for drawing. */
const COLUMNS = 41;
const ROWS = 25;
const SPACING = 0.25;
const FAR = 12;
const BOTTOM = -3.1;
/** The bars: t from −1 to 4 along the lower edge, one bar below another. */
const FIRST = -1;
const LAST = 4;
const LEFT = -4.2;
const TOP = -3.35;
const HEIGHT = 0.5;

const across = (t: number): number =>
  LEFT + ((Math.min(LAST, Math.max(FIRST, t)) - FIRST) / (LAST - FIRST)) * (4.9 - LEFT);
const level = (bar: number): number => TOP - HEIGHT * (bar + 1);
const on = (from: Vec2, to: Vec2, t: number): Vec2 => [
  from[0] + (to[0] - from[0]) * t,
  from[1] + (to[1] - from[1]) * t,
];
const square = ([x, y]: Vec2): Vec2[] => [
  [x - 0.03, y - 0.03],
  [x + 0.03, y - 0.03],
  [x + 0.03, y + 0.03],
  [x - 0.03, y + 0.03],
];
const interval = (from = 0, to = 0): string => `${pretty(from)} to ${pretty(to)}`;

export default defineFigure<Input, Output>({
  title: "Is the ray in all slabs at once?",
  view: { kind: "2d", x: [-5, 5], y: [-5.7, 3.1] },
  aspect: 1.1,
  initial: {
    low: [-0.5, -1],
    high: [2, 1.25],
    origin: [-3.5, -2],
    through: [-2, -1],
    z: [-1, 1, 0, 0],
    segment: 0,
    method: 2,
    divided: 1,
    single: 0,
  },
  handles: [
    {
      kind: "point",
      field: "low",
      label: "a corner of the box",
      role: "surface",
      step: 2.5,
      limit: [-3, 3],
    },
    {
      kind: "point",
      field: "high",
      label: "the opposite corner of the box",
      role: "surface",
      step: 2.5,
      limit: [-3, 3],
    },
    {
      kind: "point",
      field: "through",
      label: "q, the point with t = 1",
      role: "ray",
      step: 2.5,
      limit: [-4.5, 4.5],
    },
    {
      kind: "point",
      field: "origin",
      label: "o, start of the ray",
      role: "ray",
      step: 2.5,
      limit: [-4.5, 4.5],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "Method",
      options: [
        { value: 2, label: "branchless, times 1/d" },
        { value: 1, label: "slabs with division" },
        { value: 3, label: "padded: with a later exit" },
        { value: 0, label: "the book’s: exact decision" },
      ],
    },
    {
      kind: "choice",
      field: "segment",
      label: "Test",
      options: [
        { value: 0, label: "the ray from o through q" },
        { value: 1, label: "the segment from o to q" },
      ],
    },
    {
      kind: "choice",
      field: "divided",
      label: "Positions",
      options: [
        { value: 1, label: "as they are" },
        { value: 10, label: "divided by 10" },
      ],
    },
    floatOrDouble,
    { kind: "numbers", field: "origin", label: "o", role: "ray", step: 0.25 },
    { kind: "numbers", field: "through", label: "q", role: "ray", step: 0.25 },
    { kind: "numbers", field: "low", label: "corner", role: "surface", step: 0.25 },
    { kind: "numbers", field: "high", label: "corner", role: "surface", step: 0.25 },
    {
      kind: "numbers",
      field: "z",
      label: "z",
      step: 0.25,
      axes: ["corner", "corner", "o", "q"],
    },
  ],
  draw(scene, input, output) {
    const { origin, through, method } = input;
    scene.label(origin, "o", { role: "ray", offset: [0, -18], anchor: "middle" });
    scene.label(through, "q", { role: "ray", offset: [0, -18], anchor: "middle" });
    if (output.problem) return;
    const { box_low: low, box_high: high } = output;

    for (let i = 0; i < COLUMNS * ROWS; i++) {
      const at: Vec2 = [
        ((i % COLUMNS) - (COLUMNS - 1) / 2) * SPACING,
        (Math.floor(i / COLUMNS) - (ROWS - 1) / 2) * SPACING,
      ];
      if (output.missed[i]) scene.dot(at, "miss", 2.6);
      else if (output.seen[i])
        scene.face(square(at), { role: "surface", fill: 0.45, outline: false });
    }
    for (const x of [low[0], high[0]])
      scene.line([x, -3], [x, 3], { role: "a", width: 1, dashed: true });
    for (const y of [low[1], high[1]])
      scene.line([-5, y], [5, y], { role: "b", width: 1, dashed: true });
    const corners: Vec2[] = [low, [high[0], low[1]], high, [low[0], high[1]]];
    scene.face(corners, { role: output.hit ? "hit" : "surface", fill: 0.14 });

    const down = through[1] - origin[1];
    // Not into the bars.
    const last = down < 0 ? Math.min(FAR, (BOTTOM - origin[1]) / down) : FAR;
    const far = input.segment ? through : on(origin, through, last);
    scene.line(origin, far, { role: "ray", width: 2, arrow: input.segment === 0 });
    if (output.hit && output.passes) {
      const from = on(origin, through, Math.max(0, output.entry));
      const to = on(origin, through, input.segment ? Math.min(1, output.exit) : output.exit);
      scene.line(from, to, { role: "hit", width: 5 });
      if (!output.inside) {
        const tip: Vec2 = [from[0] + output.normal[0] * 0.7, from[1] + output.normal[1] * 0.7];
        scene.arrow(from, tip, { role: "normal", width: 2 }).dot(from, "hit", 5);
      }
    }

    for (let i = 0; i < 3; i++) {
      const role = ROLES[i] ?? "ink";
      const entry = output.slab_entry[i] ?? 0;
      const exit = output.slab_exit[i] ?? 0;
      scene.label([LEFT, level(i)], AXES[i] ?? "", { role, offset: [-10, 5], anchor: "end" });
      if (!output.slab_some[i])
        scene.label([across(0), level(i)], "never in this slab", {
          role: "miss",
          offset: [8, 5],
          size: "small",
        });
      else if (exit >= FIRST && entry <= LAST)
        scene.line([across(entry), level(i)], [across(exit), level(i)], { role, width: 7 });
      if (output.slab_some[i] && exit >= FIRST && entry <= LAST && entry === exit)
        scene.dot([across(entry), level(i)], role, 4);
    }
    scene.label([LEFT, level(3)], "all", { role: "hit", offset: [-6, 5], anchor: "end" });
    if (output.passes && output.exit >= FIRST && output.entry <= LAST) {
      const to: Vec2 = [across(output.exit), level(3)];
      scene.line([across(output.entry), level(3)], to, { role: "hit", width: 7 });
      if (output.hit) scene.dot([across(output.t), level(3)], "hit", 5);
    }
    for (const t of [0, 1, 2, 3]) {
      scene.line([across(t), TOP], [across(t), level(3) - 0.12], {
        role: t === 0 ? "ray" : "ghost",
        width: t === 0 ? 2 : 1,
      });
      scene.label([across(t), TOP], t === 0 ? "t = 0" : `${t}`, {
        role: "muted",
        offset: [0, -5],
        anchor: "middle",
        size: "small",
      });
    }

    if (output.wrong[method]) {
      const words = output.says[method] ? "hit, where there is none" : "no hit, where there is one";
      scene.label([0, 2.65], `${METHODS[method]}: ${words}`, { role: "miss", anchor: "middle" });
    }
  },
  values(input, output) {
    const quotient = (i: number): Value => ({
      name: AXES[i] ?? "",
      meaning: "(low − o)/d, (high − o)/d",
      value: `${pretty(output.first_quotient[i] ?? 0)}, ${pretty(output.second_quotient[i] ?? 0)}`,
      role: ROLES[i] ?? "ink",
    });
    const axis = (i: number): string => (i < 0 ? "" : `, ${AXES[i]}`);
    return [
      ...[0, 1, 2].map(quotient),
      {
        name: "entry",
        meaning: `the latest of three${axis(output.entry_axis)}`,
        value: output.passes ? output.entry : "–",
        role: "hit",
      },
      {
        name: "exit",
        meaning: `the earliest of three${axis(output.exit_axis)}`,
        value: output.passes ? output.exit : "–",
        role: "hit",
      },
      ...METHODS.map((name, i): Value => {
        const found = output.says[i] ? "hit" : "miss";
        return {
          name,
          meaning: output.finds[i]
            ? interval(output.method_entry[i], output.method_exit[i])
            : "no common interval",
          value: output.wrong[i] ? `${found}, wrong` : found,
          role: output.wrong[i] ? "miss" : "hit",
        };
      }),
      {
        name: "red",
        meaning: `starts from which it is wrong (${METHODS[input.method]})`,
        value: output.starts_wrong,
        role: output.starts_wrong ? "miss" : "ink",
      },
    ];
  },
  describe(input, output) {
    const part = input.segment ? "segment" : "ray";
    const wrong = METHODS.filter((_, i) => output.wrong[i]);
    const others = wrong.length ? `Wrong here: ${wrong.join(", ")}.` : "All methods agree.";
    const found = output.hit
      ? output.inside
        ? `The ${part} starts inside the box and leaves it at t = ${pretty(output.exit)}.`
        : `The ${part} is in all slabs from t = ${pretty(output.entry)} to ${pretty(output.exit)}.`
      : `The ${part} does not hit the box.`;
    return `${found} ${others} The chosen method (${METHODS[input.method]}) is wrong from ${output.starts_wrong} of the starts tested.`;
  },
});
