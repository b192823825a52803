// Two boxes and their signed separations along fifteen axes as bars, to the right of the middle if
// positive. The plane is perpendicular to the axis of the largest one. Three of the tests are wrong
// for some boxes: then the bars are red.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec3,
  vectorAt,
} from "@contact/figure";

interface Input {
  b: Vec3;
  nose_a: Vec3;
  nose_b: Vec3;
  roll_a: number;
  roll_b: number;
  half_a: Vec3;
  half_b: Vec3;
  size: number;
  method: number;
  epsilon: number;
}

interface Output {
  corner_a: readonly number[];
  corner_b: readonly number[];
  separation: readonly number[];
  skipped: readonly number[];
  skipped_count: number;
  largest: number;
  axis: number;
  normal: Vec3;
  on: Vec3;
  shortest: number;
  state: number;
  apart: readonly number[];
  wrong: readonly number[];
  exact_largest: number;
}

const XYZ = ["x", "y", "z"] as const;
const AXES: readonly string[] = [
  ...XYZ.map((i) => `face ${i} of A`),
  ...XYZ.map((i) => `face ${i} of B`),
  ...XYZ.flatMap((i) => XYZ.map((j) => `edges ${i} × ${j}`)),
];
const METHODS = [
  "exact",
  "rounded cosines",
  "short products skipped",
  "cosines and epsilon",
] as const;
const STATES = ["disjoint", "touching", "overlapping"];
/** Cells of a bar, half of them on each side of 0, and how much of a half length each one is. */
const CELLS = 40;
const CELL = 0.1;
/** The corners of each face, in order. */
const FACES = [
  [0, 2, 6, 4],
  [1, 3, 7, 5],
  [0, 1, 5, 4],
  [2, 3, 7, 6],
  [0, 1, 3, 2],
  [4, 5, 7, 6],
] as const;

function box(scene: Scene, corners: readonly number[], role: Role): void {
  for (const face of FACES)
    scene.face(
      face.map((k) => vectorAt(corners, k)),
      { role, fill: 0.16, outline: true, hides: true },
    );
}

/** A bar from the middle: at least one cell, unless the separation is exactly 0. */
function bar({ size }: Input, output: Output, k: number, role: Role): (Role | undefined)[] {
  if (output.skipped[k]) return Array.from({ length: CELLS }, () => undefined);
  const cells = (output.separation[k] ?? 0) / size / CELL;
  const middle = CELLS / 2;
  return Array.from({ length: CELLS }, (_, i) => {
    const filled = i < middle ? middle - i <= Math.ceil(-cells) : i - middle < Math.ceil(cells);
    return filled ? role : "ghost";
  });
}

interface Bar {
  readonly name: string;
  readonly cells: readonly (Role | undefined)[];
}

function bars(input: Input, output: Output): Bar[] {
  const wrong = output.wrong[input.method] === 1;
  return AXES.map((name, k) => {
    const positive = (output.separation[k] ?? 0) > 0;
    const usual = positive ? "hit" : "muted";
    const highlighted = wrong ? "miss" : positive ? "hit" : "ray";
    return { name, cells: bar(input, output, k, k === output.axis ? highlighted : usual) };
  });
}

/** Two boxes with an edge towards each other; the edges cross. */
const CROSSED = {
  b: [2.9375, 0, 0],
  nose_a: [0, -1.5, 0],
  nose_b: [0, -1.5, 0.5625],
  roll_a: 45,
  roll_b: 45,
  half_a: [1, 1, 1],
  half_b: [1, 1, 1],
  size: 1,
  epsilon: 1e-6,
} as const;

export default defineFigure<Input, Output>({
  title: "Fifteen axes of two boxes",
  view: {
    kind: "3d",
    target: [1.6, 0, -2.35],
    azimuth: -68,
    elevation: 22,
    span: 6.4,
    projection: "orthographic",
  },
  aspect: 0.64,
  initial: { ...CROSSED, b: [3.125, 0, 0], nose_b: [0, -1.5, 0.25], method: 0 },
  handles: [
    {
      kind: "point",
      field: "nose_a",
      label: "direction of A’s x axis",
      role: "a",
      limit: [-2, 2],
    },
    {
      kind: "point",
      field: "nose_b",
      from: "b",
      label: "direction of B’s x axis",
      role: "b",
      limit: [-2, 2],
    },
    { kind: "point", field: "b", label: "centre of B", role: "b", step: 0.625, limit: [-4, 4] },
  ],
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "Test",
      options: [
        { value: 0, label: "exact" },
        { value: 1, label: "rounded cosines, no epsilon" },
        { value: 2, label: "skip short cross products" },
        { value: 3, label: "add epsilon to the cosines" },
      ],
    },
    {
      kind: "choice",
      field: "epsilon",
      label: "Epsilon",
      options: [
        { value: 1e-6, label: "10⁻⁶" },
        { value: 1e-5, label: "10⁻⁵" },
        { value: 1e-3, label: "10⁻³" },
      ],
    },
    {
      kind: "states",
      label: "Boxes",
      options: [
        {
          label: "nearly parallel",
          fields: {
            ...CROSSED,
            b: [2.875, 0, 0],
            nose_b: [0, -1.5, 0.09375],
            half_a: [1.5, 1, 1],
            half_b: [1.5, 1, 1],
            epsilon: 1e-3,
            method: 3,
          },
        },
        {
          label: "5 cm, crossed",
          fields: { ...CROSSED, size: 0.05, method: 2 },
        },
        {
          label: "parallel",
          fields: {
            ...CROSSED,
            b: [1.25, -0.125, -0.625],
            nose_a: [-1.5, 0, -1],
            nose_b: [1.5, 0, 1],
            roll_a: 30,
            roll_b: 210,
            method: 1,
          },
        },
      ],
    },
    { kind: "slider", field: "roll_a", label: "turn A", min: 0, max: 360, step: 5, unit: "°" },
    { kind: "slider", field: "roll_b", label: "turn B", min: 0, max: 360, step: 5, unit: "°" },
    {
      kind: "choice",
      field: "size",
      label: "Unit",
      options: [
        { value: 1, label: "1 m" },
        { value: 0.05, label: "5 cm" },
      ],
    },
    { kind: "numbers", field: "nose_a", label: "A’s x axis", role: "a" },
    { kind: "numbers", field: "half_a", label: "A’s half", role: "a" },
    { kind: "numbers", field: "b", label: "B", role: "b", step: 0.0625 },
    { kind: "numbers", field: "nose_b", label: "B’s x axis", role: "b" },
    { kind: "numbers", field: "half_b", label: "B’s half", role: "b" },
  ],
  draw(scene, input, output) {
    const { b, nose_a, nose_b } = input;
    scene.arrow([0, 0, 0], nose_a, { role: "a", width: 1.5, through: true });
    const tip: Vec3 = [b[0] + nose_b[0], b[1] + nose_b[1], b[2] + nose_b[2]];
    scene.arrow(b, tip, { role: "b", width: 1.5, through: true });
    if (output.problem) return;
    box(scene, output.corner_a, "a");
    box(scene, output.corner_b, "b");
    scene.label(vectorAt(output.corner_a, 6), "A", { role: "a", offset: [0, -10] });
    scene.label(vectorAt(output.corner_b, 6), "B", { role: "b", offset: [0, -10] });
    const role = output.wrong[input.method] ? "miss" : output.apart[input.method] ? "hit" : "ray";
    scene.patch(output.on, output.normal, 1.3, { role, fill: 0.12 });
    scene.strips(bars(input, output));
  },
  values: ({ method }, output) => [
    {
      name: "boxes",
      meaning: "decided exactly",
      value: STATES[output.state] ?? "",
      role: output.state === 0 ? "hit" : "ray",
    },
    testValue(method, output),
    {
      name: "largest",
      meaning: `separation, ${AXES[output.axis] ?? ""}`,
      value: output.largest,
      unit: "m",
      role: output.wrong[method] ? "miss" : "ink",
    },
    {
      name: "exact",
      meaning: "the largest of all axes",
      value: output.exact_largest,
      unit: "m",
    },
    { name: "skipped", meaning: "axes without a bar", value: output.skipped_count },
    { name: "shortest", meaning: "cross product of unit edges", value: output.shortest },
  ],
  describe({ method }, output) {
    const axis = AXES[output.axis] ?? "";
    const largest = `the largest separation is ${pretty(output.largest)} m, ${axis}`;
    const now = `The boxes are ${STATES[output.state] ?? ""}.`;
    if (!output.wrong[method]) {
      if (output.apart[method]) return `${now} A plane separates them: ${largest}.`;
      return output.state === 1
        ? `${now} A plane has them on its two sides: ${largest}.`
        : `${now} No axis separates them: ${largest}.`;
    }
    const says = output.apart[method] ? "apart" : "not apart";
    return `${now} The test says wrongly that they are ${says}: ${largest}.`;
  },
});

function testValue(method: number, output: Output): Value {
  const wrong = output.wrong[method] === 1;
  return {
    name: "test",
    meaning: METHODS[method] ?? METHODS[0],
    value: `${output.apart[method] ? "apart" : "not apart"}${wrong ? ": wrong" : ""}`,
    role: wrong ? "miss" : "hit",
  };
}
