// Two contacts of one body in the plane of their impulses: the iterations of Gauss-Seidel and of
// Jacobi step by step, the block solve of both contacts, and the residual after each iteration.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  first: number;
  second: number;
  velocity: number;
  angular_velocity: number;
  start: readonly number[];
  relaxation: number;
  share: number;
  shown: number;
}

interface Output {
  b: readonly number[];
  crosses: readonly number[];
  line1: readonly number[];
  line2: readonly number[];
  impulses: readonly number[];
  which: number;
  singular: number;
  gauss_seidel: readonly number[];
  jacobi: readonly number[];
  gauss_seidel_residual: readonly number[];
  jacobi_residual: readonly number[];
  needed: number;
  jacobi_needed: number;
  now: readonly number[];
  velocities: readonly number[];
  coupling: number;
  rate: number;
}

const MOST = 40;
/** The drawn part of the plane, N·s. */
const LOW = -0.4;
const HIGH = 2.6;
/** The body: its middle, world units for a metre, and the length of an arrow for 1 m/s. */
const BODY = { x: 3.95, y: 1.85, metre: 0.58, arrow: 0.22 } as const;
/** Residuals over iterations: where iteration 0 and a residual of 1 are, and the units. */
const RESIDUAL = { x: 0.15, y: -1.12, wide: 0.112, tall: 0.13, powers: [0, -4, -8] } as const;
/** The names of the methods: left, highest, and their distance. */
const NAMES = { x: 3, y: 0.72, apart: 0.36 } as const;
const GAUSS_SEIDEL: Role = "ray";
const JACOBI: Role = "b";
const BLOCK: Role = "hit";
const LINES: readonly Role[] = ["a", "c"];

const between = (low: number, value: number, high: number): number =>
  Math.max(low, Math.min(high, value));
const inPlane = (x: number, y: number): Vec2 => [between(LOW, x, HIGH), between(LOW, y, HIGH)];
const points = (numbers: readonly number[], count: number): Vec2[] =>
  Array.from({ length: count }, (_, i) => inPlane(numbers[2 * i] ?? 0, numbers[2 * i + 1] ?? 0));
const small = { role: "muted", size: "small" } as const;
const axis = { role: "muted", width: 1 } as const;
const counted = (needed: number): string => (needed < 0 ? `more than ${MOST}` : pretty(needed));
const iterations = (needed: number): string =>
  needed === 1 ? "1 iteration" : `${counted(needed)} iterations`;
/** Where a label goes that belongs to a point of the edge of the plane. */
function outside([x, y]: Vec2): { anchor: "start" | "middle" | "end"; offset: Vec2 } {
  if (y > HIGH - 0.01) return { anchor: "middle", offset: [0, -6] };
  if (x > HIGH - 0.01) return { anchor: "start", offset: [4, 4] };
  return y < LOW + 0.01
    ? { anchor: "middle", offset: [0, 15] }
    : { anchor: "start", offset: [4, -6] };
}
const arm = (r: number): number => BODY.x + BODY.metre * r;

function plane(scene: Scene, { shown }: Input, output: Output): void {
  const pulls = { role: "miss", fill: 0.08, outline: false } as const;
  scene.face([inPlane(LOW, LOW), inPlane(0, LOW), inPlane(0, HIGH), inPlane(LOW, HIGH)], pulls);
  scene.face([inPlane(0, LOW), inPlane(HIGH, LOW), inPlane(HIGH, 0), inPlane(0, 0)], pulls);
  scene.line(inPlane(LOW, 0), inPlane(HIGH, 0), axis);
  scene.line(inPlane(0, LOW), inPlane(0, HIGH), axis);
  scene.label([HIGH, 0], "x₁, N·s", { ...small, anchor: "end", offset: [0, -6] });
  scene.label([LOW, HIGH], "x₂, N·s", { ...small, offset: [0, -6] });
  for (const k of [1, 2]) {
    scene.line([k, -0.04], [k, 0.04], axis);
    scene.line([-0.04, k], [0.04, k], axis);
    scene.label([k, 0], pretty(k), { ...small, anchor: "middle", offset: [0, 16] });
    scene.label([0, k], pretty(k), { ...small, anchor: "end", offset: [-6, 4] });
  }
  [output.line1, output.line2].forEach((line, i) => {
    if (!output.crosses[i]) return;
    const role = LINES[i] ?? "ink";
    const [from, to] = points(line, 2) as [Vec2, Vec2];
    scene.line(from, to, { role, width: 2 });
    // Contact 1 at the higher end, contact 2 at the one on the right, so that they are apart.
    const at = i === 0 ? (from[1] > to[1] ? from : to) : from[0] > to[0] ? from : to;
    scene.label(at, i === 0 ? "v₁ = 0" : "v₂ = 0", { role, size: "small", ...outside(at) });
  });
  const start = points(output.gauss_seidel, 1)[0] ?? [0, 0];
  const solution = inPlane(output.impulses[0] ?? 0, output.impulses[1] ?? 0);
  scene.arrow(start, solution, { role: BLOCK, width: 1.6, dashed: true });
  const jacobi = points(output.jacobi, shown + 1);
  scene.path(jacobi, { role: JACOBI, width: 1.6 });
  for (const at of jacobi) scene.dot(at, JACOBI, 2.8);
  const zigzag = points(output.gauss_seidel, 2 * shown + 1);
  scene.path(zigzag, { role: GAUSS_SEIDEL, width: 2.2 });
  zigzag.forEach((at, i) => {
    scene.dot(at, GAUSS_SEIDEL, i % 2 === 0 ? 3.4 : 2);
  });
  scene.dot(solution, BLOCK, 6, true);
}

function body(scene: Scene, { first, second }: Input, output: Output): void {
  const { x, y, arrow } = BODY;
  const reach = Math.max(0.3, Math.abs(first), Math.abs(second)) + 0.08;
  const [left, right] = [arm(-reach), arm(reach)];
  const bar: Vec2[] = [
    [left, y],
    [right, y],
    [right, y + 0.12],
    [left, y + 0.12],
  ];
  scene.face(bar, { role: "ink", fill: 0.15 });
  scene.dot([x, y + 0.06], "ink", 3);
  [first, second].forEach((r, i) => {
    const role = LINES[i] ?? "ink";
    const at = arm(r);
    const foot: Vec2 = [at, y - 0.12];
    scene.line([at, y], foot, { role, width: 3 });
    const velocity = output.velocities[i] ?? 0;
    const tip: Vec2 = [at, foot[1] + arrow * between(-3, velocity, 3)];
    if (Math.abs(velocity) > 1e-6) scene.arrow(foot, tip, { role, width: 2 });
    scene.label([at, y + 0.12], i === 0 ? "v₁" : "v₂", {
      role,
      size: "small",
      anchor: "middle",
      offset: [0, -6],
    });
  });
}

function residuals(scene: Scene, { shown }: Input, output: Output): void {
  const { x, y, wide, tall, powers } = RESIDUAL;
  const at = (n: number, residual: number): Vec2 => [
    x + wide * n,
    y + tall * between(-10, Math.log10(Math.max(residual, 1e-12)), 1),
  ];
  scene.line(at(0, 1e-10), at(0, 10), axis);
  scene.line(at(0, 1e-10), at(MOST, 1e-10), axis);
  for (const power of powers) {
    scene.line(at(0, 10 ** power), at(MOST, 10 ** power), { role: "ghost", width: 1 });
    scene.label(at(0, 10 ** power), pretty(10 ** power), {
      ...small,
      anchor: "end",
      offset: [-5, 4],
    });
  }
  scene.label(at(0, 10), "residual, m/s", { ...small, offset: [6, -4] });
  scene.label(at(MOST, 1e-10), "iteration", { ...small, anchor: "end", offset: [0, 17] });
  scene.line(at(shown, 1e-10), at(shown, 10), { role: "muted", width: 1, dashed: true });
  for (const [numbers, role, width] of [
    [output.jacobi_residual, JACOBI, 1.8],
    [output.gauss_seidel_residual, GAUSS_SEIDEL, 2.4],
  ] as const)
    scene.path(
      numbers.map((residual, n) => at(n, residual)),
      { role, width },
    );
}

function names(scene: Scene): void {
  const all: readonly (readonly [string, Role])[] = [
    ["Gauss–Seidel", GAUSS_SEIDEL],
    ["Jacobi", JACOBI],
    ["both at once", BLOCK],
  ];
  all.forEach(([name, role], i) => {
    const y = NAMES.y - NAMES.apart * i;
    scene.line([NAMES.x, y], [NAMES.x + 0.3, y], { role, width: 2.5, dashed: role === BLOCK });
    scene.label([NAMES.x + 0.3, y], name, { role, size: "small", offset: [6, 4] });
  });
}

export default defineFigure<Input, Output>({
  title: "Two impulses, iteration by iteration",
  view: { kind: "2d", x: [-0.62, 4.9], y: [-2.72, 2.9] },
  aspect: 1.05,
  initial: {
    first: -1.2,
    second: 0.9,
    velocity: -2.5,
    angular_velocity: 0.4,
    start: [0, 0],
    relaxation: 1,
    share: 0.5,
    shown: 3,
  },
  handles: [
    {
      kind: "point",
      field: "start",
      label: "impulses at the start, N·s",
      role: GAUSS_SEIDEL,
      step: 0.05,
      limit: [0, 2.6],
    },
    {
      kind: "slide",
      field: "first",
      label: "lever arm of contact 1, m",
      role: LINES[0] ?? "a",
      at: ({ first }): Vec2 => [arm(first), BODY.y - 0.12],
      along: (): Vec2 => [BODY.metre, 0],
      step: 0.05,
      limit: [-1.4, 1.4],
    },
    {
      kind: "slide",
      field: "second",
      label: "lever arm of contact 2, m",
      role: LINES[1] ?? "c",
      at: ({ second }): Vec2 => [arm(second), BODY.y - 0.12],
      along: (): Vec2 => [BODY.metre, 0],
      step: 0.05,
      limit: [-1.4, 1.4],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "shown",
      label: "iterations shown",
      min: 0,
      max: MOST,
      step: 1,
      play: 12,
    },
    {
      kind: "slider",
      field: "velocity",
      label: "velocity before",
      min: -4,
      max: 1,
      step: 0.1,
      unit: "m/s",
    },
    {
      kind: "slider",
      field: "angular_velocity",
      label: "angular velocity before",
      min: -6,
      max: 6,
      step: 0.1,
      unit: "rad/s",
    },
    {
      kind: "slider",
      field: "relaxation",
      label: "over-relaxation: factor of Gauss–Seidel's changes",
      min: 0.5,
      max: 1.9,
      step: 0.05,
    },
    {
      kind: "choice",
      field: "share",
      label: "Jacobi applies",
      options: [
        { value: 0.5, label: "half of each change" },
        { value: 1, label: "each change" },
      ],
    },
    {
      kind: "numbers",
      field: "start",
      label: "impulses at the start",
      axes: ["x₁", "x₂"],
      step: 0.1,
      unit: "N·s",
    },
    {
      kind: "states",
      label: "Contacts",
      options: [
        {
          label: "on both sides",
          fields: { first: -1.2, second: 0.9, velocity: -2.5, angular_velocity: 0.4 },
        },
        {
          label: "on one side",
          fields: {
            first: 0.4,
            second: 0.9,
            velocity: -1.5,
            angular_velocity: -3.4,
            start: [0, 0],
          },
        },
        {
          label: "one is enough",
          fields: { first: 0.2, second: 0.9, velocity: -2, angular_velocity: 0, start: [0, 0] },
        },
        {
          label: "at one point",
          fields: {
            first: 0.5,
            second: 0.5,
            velocity: -2.5,
            angular_velocity: 0,
            share: 1,
            start: [0, 0],
          },
        },
        {
          label: "not coupled",
          fields: {
            first: -0.5,
            second: 0.5,
            velocity: -2.5,
            angular_velocity: 0.4,
            start: [0, 0],
          },
        },
      ],
    },
  ],
  draw(scene, input, output) {
    if (output.problem) return;
    plane(scene, input, output);
    body(scene, input, output);
    residuals(scene, input, output);
    names(scene);
  },
  values({ shown }, output): Value[] {
    const n = between(0, Math.round(shown), MOST);
    return [
      {
        name: "x",
        meaning: "both contacts at once (block solve), N·s",
        value: output.impulses,
        role: BLOCK,
      },
      {
        name: `x_${n}`,
        meaning: "Gauss–Seidel after the iterations shown, N·s",
        value: output.now,
        role: GAUSS_SEIDEL,
      },
      { name: `v_${n}`, meaning: "velocities of the contacts then, m/s", value: output.velocities },
      {
        name: "residual",
        meaning: "of Gauss–Seidel then, m/s",
        value: output.gauss_seidel_residual[n] ?? 0,
      },
      { name: "coupling", meaning: "a₁₂ / √(a₁₁ a₂₂)", value: output.coupling },
      {
        name: "coupling²",
        meaning: "factor of the error in each iteration, if both push",
        value: output.rate,
      },
      {
        name: "iterations",
        meaning: "of Gauss–Seidel to a residual of 10⁻⁹ m/s",
        value: counted(output.needed),
        role: GAUSS_SEIDEL,
      },
      {
        name: "iterations",
        meaning: "of Jacobi to the same residual",
        value: counted(output.jacobi_needed),
        role: JACOBI,
      },
    ];
  },
  describe(_input, output) {
    const pushing = ["Neither contact pushes", "Only contact 1 pushes", "Only contact 2 pushes"];
    const who = pushing[output.which] ?? "Both contacts push";
    if (output.singular)
      return `Both contacts act at one point, so the matrix has no inverse and only the sum of the impulses is determined; Gauss–Seidel needs ${iterations(output.needed)}, Jacobi ${counted(output.jacobi_needed)}.`;
    return `${who}: solving for both at once takes one step. The coupling is ${pretty(output.coupling, 3)}; from this start Gauss–Seidel needs ${iterations(output.needed)} to a residual of 10⁻⁹ m/s, Jacobi ${counted(output.jacobi_needed)}.`;
  },
});
