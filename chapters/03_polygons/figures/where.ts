// A polygon and a point. The chosen method shows what it counts; a red dot is a position at which
// it is wrong.

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
  e: Vec2;
  f: Vec2;
  g: Vec2;
  h: Vec2;
  p: Vec2;
  method: number;
  joined: number;
  rule: number;
  single: number;
}

interface Output {
  from: readonly number[];
  to: readonly number[];
  where: number;
  says: readonly number[];
  wrong: readonly number[];
  winding: number;
  sum: readonly number[];
  part: readonly number[];
  crosses: readonly number[];
  crossing: readonly number[];
  inside: readonly number[];
  missed: readonly number[];
  grid_wrong: number;
}

const NAMES = ["a", "b", "c", "d", "e", "f", "g", "h"] as const;
const METHODS = [
  "the book’s",
  "edge tests",
  "angle sum",
  "quadrants",
  "ends included",
  "crossings",
  "scanline",
] as const;
const WHERE = ["outside", "on the edge", "inside"];
const DEGREES = 180 / Math.PI;
/** The grid of the C++, and the ends of the level of p. */
const COLUMNS = 41;
const ROWS = 29;
const SPACING = 0.25;
const FAR = 8;

/** Dragged points move in tenths of this, in eighths of a metre, which are stored without rounding. */
const GRIP_STEP = 1.25;

const signed = (value = 0): string => (value > 0 ? `+${value}` : pretty(value));
const degrees = (value = 0): string => `${pretty(Math.round(value * DEGREES))}°`;
const middle = (from: Vec2, to: Vec2): Vec2 => [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];

/** A small mark that lines are drawn over. */
const square = ([x, y]: Vec2): Vec2[] => [
  [x - 0.03, y - 0.03],
  [x + 0.03, y - 0.03],
  [x + 0.03, y + 0.03],
  [x - 0.03, y + 0.03],
];

/** What a method decides by. */
function reason(method: number, sum = 0): string {
  switch (method) {
    case 0:
      return `winding number ${pretty(sum)}`;
    case 1:
      return `on the inner side of ${sum} edges`;
    case 2:
      return `angles add up to ${degrees(sum)}`;
    case 3:
      return `${pretty(sum)} quadrants`;
    case 4:
      return `edges met: ${sum}`;
    case 5:
      return `edges crossed: ${sum}`;
    default:
      return `steps to the right: ${pretty(sum)}`;
  }
}

export default defineFigure<Input, Output>({
  title: "Is the point inside?",
  view: { kind: "2d", x: [-5, 5], y: [-3.6, 3.6] },
  aspect: 1.3,
  initial: {
    a: [-3, -2.5],
    b: [3, -3],
    c: [4, 1.5],
    d: [0, 3],
    e: [-4, 2],
    f: [0, 1],
    g: [2, -0.5],
    h: [-1, -1],
    p: [-0.5, 2],
    method: 4,
    joined: 0,
    rule: 0,
    single: 0,
  },
  handles: [
    ...NAMES.map((field) => ({
      kind: "point" as const,
      field,
      label: `${field}, a vertex of the polygon`,
      role: "surface" as const,
      step: GRIP_STEP,
      limit: [-4.75, 4.75] as const,
    })),
    {
      kind: "point",
      field: "p",
      label: "p, the point",
      role: "ray",
      step: GRIP_STEP,
      limit: [-4.75, 4.75],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "Method",
      options: [
        { value: 1, label: "dot products with the edges’ normals" },
        { value: 2, label: "sum of angles" },
        { value: 3, label: "quadrants" },
        { value: 4, label: "crossings, ends included" },
        { value: 5, label: "crossings, lower end only" },
        { value: 6, label: "scanline, + and −" },
        { value: 0, label: "winding number, exact: the book’s" },
      ],
    },
    {
      kind: "choice",
      field: "joined",
      label: "Vertices",
      options: [
        { value: 0, label: "joined in order" },
        { value: 1, label: "joined to the third next" },
        { value: 2, label: "a to e, with the hole f g h" },
      ],
    },
    {
      kind: "choice",
      field: "rule",
      label: "Rule",
      options: [
        { value: 0, label: "even-odd" },
        { value: 1, label: "non-zero" },
      ],
    },
    floatOrDouble,
    { kind: "numbers", field: "p", label: "p", role: "ray", step: 0.5 },
    ...NAMES.map((field) => ({
      kind: "numbers" as const,
      field,
      label: field,
      role: "surface" as const,
      step: 0.5,
    })),
  ],
  draw(scene, input, output) {
    const { p, method } = input;
    const vertices = NAMES.map((name) => input[name]);
    for (const [i, at] of vertices.entries())
      scene.label(at, NAMES[i] ?? "", { role: "surface", offset: [0, -15], anchor: "middle" });
    if (output.problem) return;

    for (let row = 0; row < ROWS + NAMES.length; row++) {
      const level = vertices[row - ROWS]?.[1] ?? (row - (ROWS - 1) / 2) * SPACING;
      for (let column = 0; column < COLUMNS; column++) {
        const at: Vec2 = [(column - (COLUMNS - 1) / 2) * SPACING, level];
        const cell = row * COLUMNS + column;
        if (output.missed[cell]) scene.dot(at, "miss", 2.6);
        else if (output.inside[cell] && row < ROWS)
          scene.face(square(at), { role: "surface", fill: 0.45, outline: false });
      }
    }

    const wrong = output.wrong[method] === 1;
    const role: Role = wrong ? "miss" : output.says[method] ? "hit" : "ray";
    if (method === 0 || method >= 4)
      scene.line(method === 6 ? [-FAR, p[1]] : p, [FAR, p[1]], { role: "ray", width: 1.5 });
    if (method === 3) {
      scene.line([-FAR, p[1]], [FAR, p[1]], { role: "ray", width: 1, dashed: true });
      scene.line([p[0], -FAR], [p[0], FAR], { role: "ray", width: 1, dashed: true });
    }
    const labelled = new Map<number, number>();
    for (let i = 0; i < NAMES.length; i++) {
      const from = vertices[output.from[i] ?? 0] ?? p;
      const to = vertices[output.to[i] ?? 0] ?? p;
      const part = output.part[i] ?? 0;
      const side: Role = part > 0 ? "hit" : "miss";
      const style = { role: method === 1 ? side : "surface", width: method === 1 ? 3 : 2 } as const;
      scene.arrow(from, middle(from, to), style).line(from, to, style);
      if (method === 1) {
        const word = part > 0 ? "inner side" : part < 0 ? "outer" : "on its line";
        scene.label(middle(from, to), word, { role: side, size: "small", anchor: "middle" });
      } else if (method === 2) {
        scene.line(p, from, { role: "ray", width: 1, dashed: true });
        const name = degrees(part);
        scene.label(middle(from, to), name, { role: "ray", anchor: "middle", size: "small" });
      } else if (method === 3) {
        const name = signed(part);
        if (part)
          scene.label(middle(from, to), name, { role: "ray", anchor: "middle", size: "small" });
      } else if (output.crosses[i]) {
        const x = output.crossing[i] ?? 0;
        scene.dot([x, p[1]], "ray", 5, !part);
        const above = labelled.get(x) ?? 0;
        labelled.set(x, above + 1);
        if (part)
          scene.label([x, p[1]], signed(part), {
            role: "ray",
            offset: [8, -8 - 15 * above],
            size: "small",
          });
      }
    }
    scene.dot(p, role, 5);
    scene.label(p, `p: ${WHERE[output.says[method] ?? 0]}${wrong ? ", wrong" : ""}`, {
      role,
      offset: [0, -19],
      anchor: "middle",
    });
  },
  values: (input, output) => [
    ...METHODS.map(
      (name, i): Value => ({
        name,
        meaning: reason(i, output.sum[i]),
        value: `${WHERE[output.says[i] ?? 0]}${output.wrong[i] ? ", wrong" : ""}`,
        role: output.wrong[i] ? "miss" : "hit",
      }),
    ),
    {
      name: "red",
      meaning: `positions at which the method is wrong (${METHODS[input.method]})`,
      value: output.grid_wrong,
      role: output.grid_wrong ? "miss" : "ink",
    },
  ],
  describe(input, output) {
    const wrong = METHODS.filter((_, i) => output.wrong[i]);
    const others = wrong.length ? `wrong here: ${wrong.join(", ")}` : "every method is right here";
    return `p is ${WHERE[output.where]}, with winding number ${pretty(output.winding)}; ${others}. The chosen method (${METHODS[input.method]}) is wrong at ${output.grid_wrong} of the positions tested.`;
  },
});
