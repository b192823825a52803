// GJK step by step: above the two bodies, below all differences of their points, A − B, with the
// origin O. The distance of the bodies is that of O from A − B.

import { defineFigure, pretty, type Scene, type Value, type Vec2 } from "@contact/figure";

interface Input {
  a: Vec2;
  b: Vec2;
  turn_a: Vec2;
  shape: number;
  step: number;
}

interface Output {
  vertex_a: readonly number[];
  corners_b: number;
  vertex_b: readonly number[];
  corners: number;
  difference: readonly number[];
  steps: number;
  shown: number;
  finished: number;
  count: number;
  simplex: readonly number[];
  closest: Vec2;
  distance: number;
  direction: Vec2;
  support_a: Vec2;
  support_b: Vec2;
  next: Vec2;
  lower: number;
  contains: number;
  on_a: Vec2;
  on_b: Vec2;
  all_distance: number;
}

/** Where the origin of A − B is drawn. */
const ORIGIN: Vec2 = [1.2, -4];
/** Between the two pictures. */
const MIDDLE = -2.1;
/** Dragged points move in tenths of this, in sixteenths of a metre. */
const GRIP_STEP = 0.625;

const plus = (v: Vec2, w: Vec2, times = 1): Vec2 => [v[0] + times * w[0], v[1] + times * w[1]];
/** A difference as drawn. */
const below = (w: Vec2): Vec2 => plus(ORIGIN, w);
const vertices = (count: number): string => `${count} ${count === 1 ? "vertex" : "vertices"}`;
/** The name of a simplex in the plane. */
const simplexName = (count: number): string =>
  ["", "a point", "a segment", "a triangle"][count] ?? "";

const points = (numbers: readonly number[], count: number): Vec2[] =>
  Array.from({ length: count }, (_, i): Vec2 => [numbers[2 * i] ?? 0, numbers[2 * i + 1] ?? 0]);

function closed(scene: Scene, outline: readonly Vec2[], role: "a" | "b" | "c", fill: number): void {
  scene.face(outline, { role, fill, outline: false });
  scene.path([...outline, ...outline.slice(0, 1)], { role, width: 2 });
}

/** The direction that GJK asks for, the supports, and the line that gives the lower bound. */
function asked(scene: Scene, output: Output): void {
  const { closest, direction, support_a, support_b, next } = output;
  const across: Vec2 = [-direction[1], direction[0]];
  scene.line(below(plus(next, across, -1.6)), below(plus(next, across, 1.6)), {
    role: "normal",
    width: 1,
    dashed: true,
  });
  scene.arrow(below(closest), below(plus(closest, direction, 0.6)), { role: "normal", width: 2.5 });
  scene.dot(below(next), "normal", 6);
  scene.label(below(next), "w", { role: "normal", offset: [10, 18] });
  scene.arrow(support_a, plus(support_a, direction, 0.4), { role: "a", width: 2 });
  scene.arrow(support_b, plus(support_b, direction, -0.4), { role: "b", width: 2 });
  scene.dot(support_a, "a", 6).dot(support_b, "b", 6);
}

function simplex(scene: Scene, output: Output): void {
  const corners = points(output.simplex, output.count).map(below);
  if (corners.length > 2) scene.face(corners, { role: "ray", fill: 0.3, outline: false });
  if (corners.length > 1)
    scene.path([...corners, ...corners.slice(0, 1)], { role: "ray", width: 3 });
  for (const corner of corners) scene.dot(corner, "ray", 5);
  if (output.finished && output.contains) return;
  scene.line(ORIGIN, below(output.closest), { role: "hit", width: 2, dashed: !output.finished });
  scene.dot(below(output.closest), "hit", 5);
  scene.label(below(output.closest), "v", { role: "hit", offset: [-10, -10], anchor: "end" });
}

const point = (field: "a" | "b", label: string) =>
  ({ kind: "point", field, label, role: field, step: GRIP_STEP, limit: [-1.25, 1.25] }) as const;

const APART = { a: [-0.875, 0], b: [1, 0], turn_a: [-0.5625, 0.5625] } as const;

export default defineFigure<Input, Output>({
  title: "GJK on the differences of two bodies",
  view: { kind: "2d", x: [-3.4, 3.4], y: [-5.9, 2.1] },
  aspect: 0.85,
  initial: { ...APART, shape: 0, step: 1 },
  handles: [
    {
      kind: "point",
      field: "turn_a",
      from: "a",
      label: "direction of body A",
      role: "a",
      step: GRIP_STEP,
      limit: [-1.25, 1.25],
    },
    point("a", "position of body A"),
    point("b", "position of body B"),
  ],
  controls: [
    { kind: "slider", field: "step", label: "step", min: 1, max: 26, step: 1 },
    {
      kind: "choice",
      field: "shape",
      label: "Body B",
      options: [
        { value: 0, label: "polygon" },
        { value: 1, label: "ellipse" },
      ],
    },
    {
      kind: "states",
      label: "Bodies",
      options: [
        { label: "apart", fields: { ...APART, step: 1 } },
        { label: "overlapping", fields: { ...APART, b: [0, -0.125], step: 1 } },
      ],
    },
    { kind: "numbers", field: "a", label: "A", role: "a", step: 0.0625 },
    { kind: "numbers", field: "turn_a", label: "direction", role: "a", step: 0.0625 },
    { kind: "numbers", field: "b", label: "B", role: "b", step: 0.0625 },
  ],
  draw(scene, { a, b, turn_a }, output) {
    scene.arrow(a, plus(a, turn_a), { role: "a", width: 1.2, dashed: true });
    scene.label(a, "A", { role: "a", offset: [-12, 22], anchor: "end" });
    scene.label(b, "B", { role: "b", offset: [12, 22] });
    if (output.problem) return;
    closed(scene, points(output.vertex_a, output.vertex_a.length / 2), "a", 0.3);
    closed(scene, points(output.vertex_b, output.corners_b), "b", 0.3);
    scene.line([-9, MIDDLE], [9, MIDDLE], { role: "ghost", width: 1 });

    const difference = points(output.difference, output.corners).map(below);
    closed(scene, difference, "c", 0.12);
    scene.label([-3.3, MIDDLE], "A − B", { role: "c", offset: [0, 20] });
    scene.dot(ORIGIN, "ink", 5);
    scene.label(ORIGIN, "O", { role: "ink", offset: [10, 16] });
    simplex(scene, output);
    if (!output.finished) asked(scene, output);
    else if (!output.contains)
      scene
        .line(output.on_a, output.on_b, { role: "hit", width: 2.5 })
        .dot(output.on_a, "a", 6)
        .dot(output.on_b, "b", 6);
  },
  values: (_input, output): Value[] => [
    {
      name: "step",
      meaning: output.finished ? "the search has ended" : "asks for one vertex more",
      value: output.finished ? `after ${output.steps}` : `${output.shown} of ${output.steps}`,
    },
    { name: "simplex", meaning: "of differences", value: simplexName(output.count), role: "ray" },
    {
      name: "|v|",
      meaning: "the bodies are at most as far apart",
      value: output.distance,
      unit: "m",
      role: "hit",
    },
    {
      name: "v·w/|v|",
      meaning: "and at least as far",
      value: output.lower,
      unit: "m",
      role: "normal",
    },
    {
      name: "answer",
      meaning: output.finished ? "up to rounding" : "not known yet",
      value: !output.finished
        ? "–"
        : output.contains
          ? "O is inside"
          : `${pretty(output.all_distance)} m`,
    },
  ],
  describe(_input, output) {
    const { count, distance, lower, shown, steps } = output;
    if (output.finished)
      return output.contains
        ? `After ${steps} steps the simplex, ${simplexName(count)}, contains the origin: the bodies have a common point.`
        : `After ${steps} steps both bounds agree: the bodies are ${pretty(distance)} m apart, and v separates them.`;
    const bound =
      lower > 0
        ? `All of A − B is beyond the line through w, so the bodies are at least ${pretty(lower)} m apart: v separates them.`
        : "The line through w does not separate A − B from the origin, so v does not separate the bodies.";
    return `Step ${shown} of ${steps}: the simplex has ${vertices(count)}, and v is its point closest to the origin. w is the difference that is farthest towards the origin. ${bound}`;
  },
});
