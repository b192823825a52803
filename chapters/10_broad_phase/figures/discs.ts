// Thousands of discs in a room and one of the reader's: which pairs of boxes a broad phase
// compares, and where.

import { defineFigure, type Role, type Scene, type Value, type Vec2 } from "@contact/figure";

interface Input {
  number: number;
  method: number;
  edge: number;
  yours: Vec2;
  radius: number;
  mixed: number;
  time: number;
}

interface Output {
  count: number;
  radii: readonly number[];
  centre: readonly number[];
  state: readonly number[];
  compared: number;
  all_pairs: number;
  sweep: number;
  grid: number;
  tree: number;
  entries: number;
  nodes: number;
  touching: number;
  cheapest: number;
  compared_with_yours: number;
  touching_yours: number;
  cells: number;
  in_cell: readonly number[];
  max_in_cell: number;
  at_x: readonly number[];
  max_at_x: number;
  boxes: number;
  box_low: readonly number[];
  box_high: readonly number[];
  many_cells: number;
}

const METHODS = ["all pairs", "sweep", "grid", "tree"] as const;
const [SWEEP, GRID, TREE] = [1, 2, 3];
/** Of the room, m. */
const SIDE = 10;
/** The highest bar of the sweep, and the top of its line. */
const TALL = 1.2;
const LINE = -0.25;
/** Discs by state: plain, touching another, compared with yours, touching yours. */
const LOOKS: readonly { readonly role: Role; readonly fill: number }[] = [
  { role: "muted", fill: 0.3 },
  { role: "a", fill: 0.75 },
  { role: "ray", fill: 0.75 },
  { role: "hit", fill: 1 },
];

const counted = (value: number): string => value.toLocaleString("en");

/** Few corners where there are many discs, which are small then. */
function disc(scene: Scene, [x, y]: Vec2, radius: number, corners: number, state: number): void {
  const outline = Array.from({ length: corners }, (_, i): Vec2 => {
    const angle = ((2 * i + 1) * Math.PI) / corners;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
  const { role, fill } = LOOKS[state] ?? { role: "muted", fill: 0.3 };
  scene.face(outline, { role, fill, outline: false });
}

function rectangle([x1, y1]: Vec2, [x2, y2]: Vec2): Vec2[] {
  return [
    [x1, y1],
    [x2, y1],
    [x2, y2],
    [x1, y2],
  ];
}

function cells(scene: Scene, edge: number, { cells, in_cell, max_in_cell }: Output): void {
  for (let k = 0; k <= cells; k++) {
    const at = Math.min(k * edge, SIDE);
    scene.line([at, 0], [at, SIDE], { role: "ghost", width: 0.5 });
    scene.line([0, at], [SIDE, at], { role: "ghost", width: 0.5 });
  }
  for (let y = 0; y < cells; y++) {
    for (let x = 0; x < cells; x++) {
      const here = in_cell[cells * y + x] ?? 0;
      if (here === 0) continue;
      const upTo = (k: number): number => Math.min((k + 1) * edge, SIDE);
      scene.face(rectangle([x * edge, y * edge], [upTo(x), upTo(y)]), {
        role: "ball",
        fill: 0.1 + (0.6 * here) / max_in_cell,
        outline: false,
      });
    }
  }
}

/** Under the room the comparisons along the line, and in it the strip that your disc occupies. */
function sweepLine(scene: Scene, { yours, radius }: Input, { at_x, max_at_x }: Output): void {
  const wide = SIDE / at_x.length;
  at_x.forEach((here, i) => {
    if (here === 0) return;
    const low: Vec2 = [i * wide, LINE - (TALL * here) / max_at_x];
    scene.face(rectangle(low, [(i + 1) * wide, LINE]), { role: "ball", fill: 0.7, outline: false });
  });
  scene.line([0, LINE], [SIDE, LINE], { role: "muted", width: 1 });
  const [from, to] = [Math.max(0, yours[0] - radius), Math.min(SIDE, yours[0] + radius)];
  if (from < to)
    scene.face(rectangle([from, LINE - TALL], [to, SIDE]), {
      role: "b",
      fill: 0.1,
      outline: false,
    });
}

function nodes(scene: Scene, { boxes, box_low, box_high }: Output): void {
  for (let i = 0; i < boxes; i++) {
    const low: Vec2 = [box_low[2 * i] ?? 0, box_low[2 * i + 1] ?? 0];
    const high: Vec2 = [box_high[2 * i] ?? 0, box_high[2 * i + 1] ?? 0];
    const corners = rectangle(low, high);
    scene.face(corners, { role: "ball", fill: 0.05, outline: false });
    scene.path([...corners, low], { role: "ball", width: 1.2 });
  }
}

export default defineFigure<Input, Output>({
  title: "Discs in a room, and the pairs that a broad phase compares",
  view: { kind: "2d", x: [-0.2, 10.2], y: [-1.6, 10.2] },
  aspect: 0.9,
  initial: { number: 1000, method: 2, edge: 0.5, yours: [4, 5.5], radius: 0.6, mixed: 0, time: 1 },
  handles: [
    {
      kind: "point",
      field: "yours",
      label: "your disc",
      role: "b",
      step: 0.1,
      limit: [0, SIDE],
    },
    {
      kind: "slide",
      field: "radius",
      label: "radius of your disc, m",
      role: "b",
      at: ({ yours, radius }): Vec2 => [yours[0] + radius, yours[1]],
      along: (): Vec2 => [1, 0],
      step: 0.05,
      limit: [0.05, 5],
    },
    {
      kind: "slide",
      field: "edge",
      label: "edge of a cell, m",
      role: "ball",
      // Other methods have no cells.
      at: ({ edge, method }): Vec2 => (method === GRID ? [edge, 0] : [Number.NaN, 0]),
      along: (): Vec2 => [1, 0],
      step: 0.05,
      limit: [0.05, 5],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "method",
      options: METHODS.map((label, value) => ({ value, label })),
    },
    {
      kind: "slider",
      field: "time",
      label: "time",
      min: 0,
      max: 8,
      step: 0.01,
      unit: "s",
      play: 8,
    },
    { kind: "slider", field: "number", label: "discs", min: 8, max: 5000, step: 8 },
    { kind: "slider", field: "edge", label: "cell", min: 0.05, max: 5, step: 0.05, unit: "m" },
    {
      kind: "choice",
      field: "mixed",
      label: "sizes",
      options: [
        { value: 0, label: "equal" },
        { value: 1, label: "mixed" },
      ],
    },
    { kind: "numbers", field: "yours", label: "yours", role: "b", step: 0.1 },
    { kind: "numbers", field: "radius", label: "radius", role: "b", step: 0.05, unit: "m" },
  ],
  draw(scene, input, output) {
    const { yours, radius, method, edge } = input;
    scene.path([...rectangle([0, 0], [SIDE, SIDE]), [0, 0]], { role: "surface", width: 2.5 });
    scene.ball(yours, radius, { role: "b", fill: 0.25 });
    if (output.problem) return;
    if (method === GRID) cells(scene, edge, output);
    if (method === SWEEP) sweepLine(scene, input, output);
    if (method === TREE) nodes(scene, output);
    const corners = output.count > 1500 ? 6 : output.count > 300 ? 10 : 24;
    for (let i = 0; i < output.count; i++) {
      const centre: Vec2 = [output.centre[2 * i] ?? 0, output.centre[2 * i + 1] ?? 0];
      disc(scene, centre, output.radii[i % 4] ?? 0, corners, output.state[i] ?? 0);
    }
    if (method === GRID && output.cells === 0)
      scene.label([SIDE / 2, -0.5], "These cells are too small to be drawn.", {
        role: "muted",
        anchor: "middle",
        size: "small",
      });
  },
  values(input, output): Value[] {
    const row = (method: number, value: number, meaning: string): Value => {
      const name = METHODS[method] ?? "";
      const shown = { name, meaning, value: counted(value) };
      return method === input.method ? { ...shown, role: "hit" } : shown;
    };
    return [
      { name: "touching", meaning: "pairs of boxes", value: counted(output.touching) },
      row(0, output.all_pairs, "comparisons, each with each"),
      row(SWEEP, output.sweep, "comparisons of boxes that overlap along x"),
      row(
        GRID,
        output.grid,
        `comparisons in cells, and ${counted(output.entries)} steps for entries`,
      ),
      row(TREE, output.tree, `comparisons in leaves, and ${counted(output.nodes)} of nodes`),
      {
        name: "yours",
        meaning: `is compared with so many discs; touching: ${counted(output.touching_yours)}`,
        value: counted(output.compared_with_yours),
        role: "ray",
      },
      {
        name: "cheapest",
        meaning: "predicted before any of them runs",
        value: METHODS[output.cheapest] ?? "",
      },
    ];
  },
  describe(input, output) {
    const method = METHODS[input.method] ?? "The method";
    const by = input.method === 0 ? "Comparing all pairs" : `The ${method}`;
    const found = `${by} takes ${counted(output.compared)} comparisons of boxes to find the ${counted(output.touching)} pairs that touch.`;
    if (input.method === GRID && output.many_cells)
      return `${found} Your disc covers so many cells that it is compared with all others.`;
    return found;
  },
});
