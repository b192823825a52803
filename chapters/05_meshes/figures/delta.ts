// A mesh that moves while a point goes from a to b. Left the world; right the same as the mesh sees
// it: the point's path is an arc, the segment that is tested is its chord.

import { defineFigure, pretty, type Role, type Scene, type Vec2 } from "@contact/figure";

interface Input {
  a: Vec2;
  b: Vec2;
  start: Vec2;
  end: Vec2;
  turned: number;
  turn: number;
  time: number;
  substeps: number;
}

interface Output {
  before: readonly number[];
  after: readonly number[];
  now: readonly number[];
  point_now: Vec2;
  carried: Vec2;
  carried_by_rows: Vec2;
  outline: readonly number[];
  path: readonly number[];
  path_now: Vec2;
  chords: readonly number[];
  used: number;
  bound: number;
  deviation: number;
  path_hit: number;
  path_at: Vec2;
  path_s: number;
  chord_hit: number;
  chord_at: Vec2;
  chord_s: number;
  present_hit: number;
  present_at: Vec2;
  verdict: number;
  columns: readonly number[];
  rows: readonly number[];
  mixed: Vec2;
  mixed_off: number;
}

/** The right half of the drawing, in which the origin of the mesh is here. */
const BODY: Vec2 = [2.8, 0];
const VERDICTS = ["hit", "free", "undecided"];
/** Dragged points move in tenths of this. */
const GRIP_STEP = 0.5;

const point = (numbers: readonly number[], i: number): Vec2 => [
  numbers[2 * i] ?? 0,
  numbers[2 * i + 1] ?? 0,
];
const points = (numbers: readonly number[]): Vec2[] =>
  Array.from({ length: numbers.length / 2 }, (_, i) => point(numbers, i));
const right = ([x, y]: Vec2): Vec2 => [x + BODY[0], y + BODY[1]];
/** Without what is left of rounding. */
const rounded = (value: number): number => Math.round(value * 1e6) / 1e6 + 0;
/** Entries of one row of a 4 × 4 matrix, to two decimals. */
const row = (matrix: readonly number[], i: number, columns: readonly number[]): number[] =>
  columns.map((column) => Math.round((matrix[4 * i + column] ?? 0) * 100) / 100 + 0);

/** The outline of a capsule, for drawing. */
const capsule = (from: Vec2, to: Vec2, radius: number): Vec2[] => {
  const start = Math.atan2(to[1] - from[1], to[0] - from[0]) - Math.PI / 2;
  return Array.from({ length: 34 }, (_, i): Vec2 => {
    const angle = start + ((i % 17) * Math.PI) / 16 + (i < 17 ? 0 : Math.PI);
    const [x, y] = i < 17 ? to : from;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
};

function mark(scene: Scene, at: Vec2, text: string, role: Role, down: number): void {
  scene.dot(at, role, 5);
  scene.label(at, text, { role, offset: [-8, down], anchor: "end", size: "small" });
}

export default defineFigure<Input, Output>({
  title: "A mesh that moves",
  view: { kind: "2d", x: [-2.1, 5.1], y: [-2.8, 3] },
  aspect: 1.2,
  initial: {
    a: [0.4, 0.1],
    b: [0.7, 0.5],
    start: [-0.9, -0.8],
    end: [-0.6, -0.4],
    turned: -20,
    turn: 70,
    time: 0.4,
    substeps: 1,
  },
  handles: [
    {
      kind: "point",
      field: "start",
      label: "the mesh’s origin at the start",
      role: "surface",
      step: GRIP_STEP,
      limit: [-2, 1.7],
    },
    {
      kind: "point",
      field: "end",
      label: "the mesh’s origin at the end",
      role: "surface",
      step: GRIP_STEP,
      limit: [-2, 1.7],
    },
    {
      kind: "point",
      field: "a",
      label: "a, the point at the start",
      role: "ray",
      step: GRIP_STEP,
      limit: [-2, 1.7],
    },
    {
      kind: "point",
      field: "b",
      label: "b, the point at the end",
      role: "ray",
      step: GRIP_STEP,
      limit: [-2, 1.7],
    },
  ],
  controls: [
    { kind: "slider", field: "turn", label: "θ", min: -180, max: 180, step: 5, unit: "°" },
    { kind: "slider", field: "turned", label: "at first", min: -180, max: 180, step: 5, unit: "°" },
    { kind: "slider", field: "time", label: "time", min: 0, max: 1, step: 0.01, play: 3 },
    {
      kind: "choice",
      field: "substeps",
      label: "Chords",
      options: [1, 2, 4, 8, 16].map((value) => ({ value, label: String(value) })),
    },
    {
      kind: "states",
      label: "Motion",
      options: [
        { label: "it turns", fields: { start: [-0.7, -0.5], end: [-0.7, -0.5], turn: 140 } },
        { label: "it shifts", fields: { start: [-1.3, -0.7], end: [-0.7, 0.9], turn: 0 } },
      ],
    },
    { kind: "numbers", field: "a", label: "a", role: "ray" },
    { kind: "numbers", field: "b", label: "b", role: "ray" },
    { kind: "numbers", field: "start", label: "start", role: "surface" },
    { kind: "numbers", field: "end", label: "end", role: "surface" },
  ],
  draw(scene, input, output) {
    const { a, b, start, end } = input;
    scene.line([1.8, -4], [1.8, 5], { role: "ghost", width: 1 });
    scene.label([-0.15, 2.7], "in the world", { role: "muted", anchor: "middle" });
    scene.label([3.45, 2.7], "seen from the mesh", { role: "muted", anchor: "middle" });
    scene.label(a, "a", { role: "ray", offset: [-17, 5], anchor: "end" });
    scene.label(b, "b", { role: "ray", offset: [17, 5] });
    scene.line(start, end, { role: "surface", width: 1, dashed: true });
    scene.line(a, b, { role: "ray", width: 2.5, arrow: true });
    if (output.problem) return;

    // The world.
    scene.face(points(output.before), { role: "surface", fill: 0.05, dashed: true });
    scene.face(points(output.after), { role: "surface", fill: 0.2 });
    scene.face(points(output.now), { role: "ghost", fill: 0.12 });
    scene.dot(output.point_now, "ink", 4);
    scene.line(output.carried, b, { role: "b", width: 2 });
    scene.dot(output.carried, "b", 4);
    scene.label(output.carried, "a′", { role: "b", offset: [0, 20], anchor: "middle" });
    if (output.present_hit) scene.dot(output.present_at, "ray", 5, true);

    // The mesh's view.
    scene.face(points(output.outline).map(right), { role: "surface", fill: 0.2 });
    scene.dot(BODY, "surface", 4);
    const chords = points(output.chords)
      .slice(0, output.used + 1)
      .map(right);
    for (let i = 0; i + 1 < chords.length; i++) {
      const [from, to] = [chords[i] ?? a, chords[i + 1] ?? a];
      if (output.bound > 0)
        scene.face(capsule(from, to, output.bound), { role: "b", fill: 0.12, outline: false });
      scene.line(from, to, { role: "b", width: 2 });
    }
    const path = points(output.path).map(right);
    scene.path(path, { role: "ray", width: 2.5 });
    scene.dot(right(output.path_now), "ink", 4);
    const [first, last] = [path[0] ?? a, path.at(-1) ?? b];
    scene.dot(first, "b", 4).dot(last, "ray", 4);
    scene.label(first, "a′", { role: "b", offset: [0, -10], anchor: "middle" });
    scene.label(last, "b", { role: "ray", offset: [0, 21], anchor: "middle" });
    if (output.path_hit) mark(scene, right(output.path_at), "path", "ray", -9);
    if (output.chord_hit) mark(scene, right(output.chord_at), "chord", "b", 17);
  },
  values(input, output) {
    const judged = (hit: number): Role => (hit === output.path_hit ? "hit" : "miss");
    const found = (hit: number, s: number): string => (hit ? `hit at ${pretty(s, 3)}` : "no hit");
    return [
      {
        name: "path",
        meaning: "of the point",
        value: found(output.path_hit, output.path_s),
        role: "ray",
      },
      {
        name: "chord",
        meaning: input.substeps > 1 ? "any of them" : "from a′ to b",
        value: found(output.chord_hit, output.chord_s),
        role: judged(output.chord_hit),
      },
      {
        name: "present",
        meaning: "pose alone",
        value: output.present_hit ? "hit" : "no hit",
        role: judged(output.present_hit),
      },
      { name: "certified", meaning: "", value: VERDICTS[output.verdict] ?? "" },
      { name: "distance", meaning: "of both", value: rounded(output.deviation), unit: "m" },
      { name: "bound", meaning: "of it", value: output.bound, unit: "m", role: "b" },
      { name: "M₁M₀⁻¹", meaning: "row x", value: row(output.columns, 0, [0, 1, 3]) },
      { name: "M₁M₀⁻¹", meaning: "row y", value: row(output.columns, 1, [0, 1, 3]) },
      { name: "M₀⁻¹M₁", meaning: "row x", value: row(output.rows, 0, [0, 1]) },
      { name: "M₀⁻¹M₁", meaning: "row y", value: row(output.rows, 1, [0, 1]) },
      { name: "M₀⁻¹M₁", meaning: "last row", value: row(output.rows, 3, [0, 1]) },
      { name: "a′", meaning: "= M₁M₀⁻¹ a", value: output.carried.map(rounded), role: "b" },
      { name: "a′", meaning: "= a M₀⁻¹M₁", value: output.carried_by_rows.map(rounded), role: "b" },
      {
        name: "mixed",
        meaning: "M₀⁻¹M₁ a",
        value: output.mixed.map(rounded),
        role: output.mixed_off > 0.005 ? "miss" : "ink",
      },
    ];
  },
  describe(input, output) {
    const does = (hit: number): string => (hit ? "hits it" : "misses it");
    return `As the mesh sees it, the point’s path ${does(output.path_hit)}, and the chord ${does(output.chord_hit)}. With the present pose alone a b ${does(output.present_hit)}. For a turn of ${pretty(input.turn)}° the bound is ${pretty(output.bound, 3)} m.`;
  },
});
