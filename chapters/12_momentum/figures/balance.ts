// Above: the drift of the total momentum of four bodies against the number of collisions, in three
// programs. Below: the bodies and their initial velocities.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  v0: number;
  v1: number;
  v2: number;
  v3: number;
  power: number;
  wide: number;
  order: number;
  share: number;
}

interface Output {
  collisions: number;
  read_at: number;
  mass: readonly number[];
  before: number;
  size: number;
  formulas: readonly number[];
  impulses: readonly number[];
  grid: readonly number[];
  read: readonly number[];
  off: readonly number[];
  most: number;
}

/** How each program is drawn, in the order of `read`. */
const WAYS: readonly {
  field: "formulas" | "impulses" | "grid";
  name: string;
  role: Role;
  width: number;
  dashed: boolean;
}[] = [
  { field: "formulas", name: "formulas", role: "miss", width: 2, dashed: false },
  { field: "impulses", name: "impulses", role: "b", width: 2, dashed: true },
  { field: "grid", name: "on a grid", role: "hit", width: 3.5, dashed: false },
];

/** Where no drift is drawn and how high the most; the bodies; how long 1 m/s is. */
const ZERO = 2.7;
const HIGH = 2.4;
const LINE = -2.3;
const NAMES = -0.75;
const PLACES = [1.1, 3.7, 6.3, 8.9] as const;
const LONG = 0.28;
const FIELDS = ["v0", "v1", "v2", "v3"] as const;

/** The least of 1, 2, 5, 10, 20, … that is not smaller. */
function above(most: number): number {
  let size = 1;
  for (let step = 0; size < most; ++step) size *= [2, 2.5, 2][step % 3] ?? 2;
  return size;
}

export default defineFigure<Input, Output>({
  title: "Drift of the total momentum",
  view: { kind: "2d", x: [-0.9, 10.7], y: [-3.4, 5.9] },
  aspect: 1.2,
  initial: { v0: 3, v1: -2, v2: 1.5, v3: -1, power: 4, wide: 0, order: 0, share: 80 },
  handles: [
    ...FIELDS.map((field, i) => ({
      kind: "slide" as const,
      field,
      label: `initial velocity of body ${i + 1}, m/s`,
      role: "ball" as const,
      at: (input: Input): Vec2 => [(PLACES[i] ?? 0) + LONG * input[field], LINE - 0.65],
      along: (): Vec2 => [LONG, 0],
      step: 0.1,
      limit: [-4, 4] as const,
    })),
    {
      kind: "slide",
      field: "share",
      label: "position of the reading, % of all collisions",
      role: "muted",
      at: (input): Vec2 => [input.share / 10, ZERO + HIGH + 0.3],
      along: (): Vec2 => [0.1, 0],
      step: 1,
      limit: [0, 100],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "wide",
      label: "Type",
      options: [
        { value: 0, label: "float" },
        { value: 1, label: "double" },
      ],
    },
    { kind: "slider", field: "power", label: "collisions: 10 to the", min: 2, max: 5, step: 1 },
    { kind: "slider", field: "order", label: "sequence", min: 0, max: 50, step: 1 },
    {
      kind: "slider",
      field: "share",
      label: "read at",
      min: 0,
      max: 100,
      step: 1,
      unit: "%",
      play: 5,
    },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow([0, ZERO], [10.4, ZERO], axis);
    scene.arrow([0, ZERO - HIGH], [0, ZERO + HIGH + 0.5], axis);
    scene.label([0, ZERO + HIGH + 0.5], "drift, in u Σ m|v|", { role: "muted", offset: [8, 2] });
    scene.line([-0.8, LINE - 0.28], [10.6, LINE - 0.28], { role: "surface", width: 2 });
    for (const [i, field] of FIELDS.entries()) {
      const x = PLACES[i] ?? 0;
      const mass = output.mass[i] ?? 0;
      const foot: Vec2 = [x, LINE - 0.65];
      scene.line([x, LINE - 0.5], [x, LINE - 0.8], axis);
      if (Math.abs(input[field]) > 0.2)
        scene.line(foot, [x + LONG * input[field], foot[1]], { role: "ball", width: 2.5 });
      if (output.problem) continue;
      const radius = 0.2 + 0.12 * (mass - 1);
      scene.ball([x, LINE - 0.28 + radius], radius, { role: "ball", fill: 0.3 });
      scene.label([x, LINE - 0.28 + 2 * radius], `${pretty(mass, 2)} kg`, {
        role: "muted",
        offset: [0, -5],
        anchor: "middle",
        size: "small",
      });
    }
    if (output.problem) return;

    const most = above(output.most);
    const small = { role: "muted", size: "small" } as const;
    for (const share of [-1, -0.5, 0.5, 1]) {
      const y = ZERO + share * HIGH;
      scene.line([0, y], [10, y], { role: "ghost", width: 1 });
      scene.label([0, y], pretty(share * most, 3), { ...small, offset: [-6, 4], anchor: "end" });
    }
    for (const share of [0.5, 1]) {
      scene.label([10 * share, ZERO - HIGH], pretty(share * output.collisions), {
        ...small,
        offset: [0, 18],
        anchor: "middle",
      });
    }
    const read = input.share / 10;
    scene.line([read, ZERO - HIGH], [read, ZERO + HIGH + 0.3], {
      role: "muted",
      width: 1,
      dashed: true,
    });
    for (const [k, { field, name, role, width, dashed }] of WAYS.entries()) {
      const drift = output[field];
      scene.path(
        drift.map((off, k): Vec2 => [(10 * k) / (drift.length - 1), ZERO + (off / most) * HIGH]),
        { role, width, dashed },
      );
      scene.dot([read, ZERO + ((output.read[k] ?? 0) / most) * HIGH], role, 4);
      scene.line([0.2 + 3.6 * k, NAMES], [0.9 + 3.6 * k, NAMES], { role, width, dashed });
      scene.label([0.9 + 3.6 * k, NAMES], name, { role, offset: [6, 4], size: "small" });
    }
  },
  values: (_input, output) => [
    { name: "Σ m v", meaning: "initial", value: output.before, unit: "N·s" },
    { name: "Σ m|v|", meaning: "initial", value: output.size, unit: "N·s" },
    { name: "n", meaning: "collisions so far", value: output.read_at },
    ...WAYS.map(({ name, role }, k) => ({
      name,
      meaning: "drift so far",
      value: output.off[k] ?? 0,
      unit: "N·s",
      role,
    })),
  ],
  describe(_input, output) {
    const [formulas = 0, impulses = 0, grid = 0] = output.off;
    return `After ${pretty(output.read_at)} collisions the total momentum, initially ${pretty(output.before)} N·s, has drifted by ${pretty(formulas)} N·s with formulas, by ${pretty(impulses)} N·s with impulses and by ${pretty(grid)} N·s on a grid.`;
  },
});
