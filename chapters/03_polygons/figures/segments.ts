// Two segments and how they meet: the book's answer is filled, those of the textbook are rings.

import {
  defineFigure,
  floatOrDouble,
  pretty,
  type Role,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  a: Vec2;
  b: Vec2;
  c: Vec2;
  d: Vec2;
  far: number;
  divided: number;
  single: number;
}

interface Output {
  stored: readonly number[];
  moved: number;
  meeting: number;
  point: Vec2;
  along_first: number;
  along_second: number;
  along_bound: number;
  point_bound: number;
  overlap_start: Vec2;
  overlap_end: Vec2;
  found: readonly number[];
  found_at: readonly number[];
  off: readonly number[];
  off_book: number;
  by_parameters: number;
  by_rounded: number;
  wrong: readonly number[];
}

const MEETING = ["do not meet", "cross", "touch", "overlap"];
const ENDS = ["a", "b", "c", "d"] as const;
const TEXTBOOK = ["slopes", "parameters"] as const;

/** Dragged ends move in tenths of this, in eighths of a metre, which are stored without rounding. */
const GRIP_STEP = 1.25;

const at = (numbers: readonly number[], i: number): Vec2 => [
  numbers[2 * i] ?? 0,
  numbers[2 * i + 1] ?? 0,
];
/** An error or a bound, m. */
const metres = (error = 0): string => (error === 0 ? "0" : `${pretty(error, 3)} m`);

export default defineFigure<Input, Output>({
  title: "Do the segments meet?",
  view: { kind: "2d", x: [-5, 5], y: [-3.4, 3.4], grid: 1 },
  aspect: 1.35,
  initial: { a: [-3, -1], b: [3, 2], c: [-1, 2.5], d: [-0.5, -2], far: 0, divided: 1, single: 0 },
  handles: ENDS.map((field, i) => ({
    kind: "point" as const,
    field,
    label: `${field}, an end of the ${i < 2 ? "first" : "second"} segment`,
    role: (i < 2 ? "a" : "b") as Role,
    step: GRIP_STEP,
    limit: [-4.5, 4.5] as const,
  })),
  controls: [
    {
      kind: "choice",
      field: "divided",
      label: "Ends",
      options: [
        { value: 1, label: "as they are" },
        { value: 10, label: "divided by 10" },
      ],
    },
    { kind: "slider", field: "far", label: "k > 0: moved by 2ᵏ m", min: 0, max: 50, step: 1 },
    floatOrDouble,
    ...ENDS.map((field, i) => ({
      kind: "numbers" as const,
      field,
      label: field,
      role: (i < 2 ? "a" : "b") as Role,
      step: 0.5,
    })),
  ],
  draw(scene, input, output) {
    for (const [i, name] of ENDS.entries())
      scene.label(input[name], name, {
        role: i < 2 ? "a" : "b",
        offset: [0, -16],
        anchor: "middle",
      });
    if (output.problem) {
      scene.line(input.a, input.b, { role: "a" }).line(input.c, input.d, { role: "b" });
      return;
    }
    const { stored, meeting, point } = output;
    scene.line(at(stored, 0), at(stored, 1), { role: "a", width: 3 });
    scene.line(at(stored, 2), at(stored, 3), { role: "b", width: 3 });
    const beside = ([x]: Vec2, line: number) =>
      x > 1
        ? ({ offset: [-16, 22 + 17 * line], anchor: "end" } as const)
        : ({ offset: [14, 22 + 17 * line], anchor: "start" } as const);
    const common = meeting === 3 ? output.overlap_start : point;
    let line = 0;
    if (meeting > 0)
      scene.label(common, `they ${MEETING[meeting]}`, { role: "hit", ...beside(common, line++) });
    for (const [i, name] of TEXTBOOK.entries()) {
      const wrong = output.wrong[i] === 1;
      const role: Role = wrong ? "miss" : "muted";
      const position = output.found[i] ? at(output.found_at, i) : common;
      if (output.found[i]) scene.dot(position, role, 9 + 3 * i, true);
      const words = output.found[i]
        ? `${name}: ${i ? MEETING[output.by_parameters] : "they meet"}`
        : `not by ${name}`;
      if (wrong) scene.label(position, words, { role, size: "small", ...beside(position, line++) });
    }
    if (meeting === 3)
      scene.line(output.overlap_start, output.overlap_end, { role: "hit", width: 7 });
    else if (meeting > 0) scene.dot(point, "hit", 5);
  },
  values(_input, output) {
    const judged = (name: string, formula: string, text: string, i: number): Value => ({
      name,
      meaning:
        output.found[i] && output.meeting ? `point off by ${metres(output.off[i])}` : formula,
      value: `${text}${output.wrong[i] ? ", wrong" : ""}`,
      role: output.wrong[i] ? "miss" : "hit",
    });
    const found = (i: number): string => (output.found[i] ? "a point" : "no point");
    return [
      {
        name: "the book’s",
        meaning: output.meeting
          ? `point within ${metres(output.point_bound)}, off by ${metres(output.off_book)}`
          : "exact orientations",
        value: MEETING[output.meeting] ?? "",
        role: "hit",
      },
      judged("slopes", "y = m x + c", found(0), 0),
      judged(
        "parameters",
        "Cramer’s rule",
        output.found[1] ? (MEETING[output.by_parameters] ?? "") : found(1),
        1,
      ),
      judged("orientations", "rounded", MEETING[output.by_rounded] ?? "", 2),
      {
        name: "x",
        meaning:
          output.meeting === 3
            ? "start of the overlap, in the drawing"
            : "the common point, in the drawing",
        value: output.meeting ? output.point : "–",
        role: "hit",
      },
      {
        name: "s, t",
        meaning: "fractions of the two segments",
        value: output.meeting ? [output.along_first, output.along_second] : "–",
      },
      {
        name: "moved",
        meaning: "along x, before the ends are stored",
        value: output.moved,
        unit: "m",
      },
    ];
  },
  describe(_input, output) {
    const [slopes = 0, parameters = 0, rounded = 0] = output.wrong;
    const wrong = [
      ...(slopes ? ["slopes"] : []),
      ...(parameters ? ["parameters"] : []),
      ...(rounded ? ["rounded orientations"] : []),
    ];
    const others = wrong.length
      ? `Wrong here: ${wrong.join(", ")}.`
      : "The textbook’s methods agree.";
    return `The segments ${MEETING[output.meeting]}. ${others}`;
  },
});
