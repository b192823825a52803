// A ball between two walls of springs, in time steps: its states in the plane of penetration and
// speed, and what each integration scheme makes of its energy.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  step: number;
  stiffness: number;
  ratio: number;
  scheme: number;
  phase: number;
}

interface Output {
  damping: number;
  rate: number;
  behaviour: number;
  limit: number;
  has_limit: number;
  semi_implicit_limit: number;
  recorded: number;
  trace: readonly number[];
  trace_bounce: readonly number[];
  exact: readonly number[];
  energy: readonly number[];
  counted: readonly number[];
  kept: number;
  first_kept: number;
  steps: number;
  min_kept: number;
  max_kept: number;
  ten_percent: number;
}

const SCHEMES: readonly { readonly name: string; readonly short: string; readonly role: Role }[] = [
  { name: "explicit Euler", short: "explicit", role: "miss" },
  { name: "semi-implicit Euler", short: "semi-implicit", role: "ray" },
  { name: "implicit damper", short: "impl. damper", role: "c" },
  { name: "implicit Euler", short: "implicit", role: "hit" },
  { name: "velocity Verlet", short: "v. Verlet", role: "a" },
  { name: "position Verlet", short: "p. Verlet", role: "b" },
  { name: "Runge–Kutta (RK4)", short: "RK4", role: "ball" },
];
const BOUNCES = 12;
/** The plane of penetration and speed: where 0 is, its unit, and what it shows. */
const PLANE = { x: 1.75, y: 6.2, unit: 1.5, d: [-0.9, 1.7], p: [-1.75, 1.75] } as const;
/** Energies: where 0 bounces and no change are, and the width of a bounce and of a power of ten. */
const ENERGY = { x: 5.7, y: 6.2, wide: 0.22, tall: 1.05, powers: [-2, 0, 2] } as const;
/** The axis of the step, in ω₀ h. */
const STEP = { x: 0.6, y: 1.7, unit: 2.5, most: 4 } as const;
/** Names at the ends of curves are at least so far apart, and end here. */
const APART = 0.46;
const HIGHEST = 8.75;

const between = (low: number, value: number, high: number): number =>
  Math.max(low, Math.min(high, value));
const inPlane = (d: number, p: number): Vec2 => [
  PLANE.x + PLANE.unit * between(PLANE.d[0], d, PLANE.d[1]),
  PLANE.y + PLANE.unit * between(PLANE.p[0], p, PLANE.p[1]),
];
const ofEnergy = (bounce: number, energy: number): Vec2 => [
  ENERGY.x + ENERGY.wide * bounce,
  ENERGY.y + ENERGY.tall * between(-2.5, Math.log10(Math.max(energy, 1e-9)), 2.5),
];
const ofStep = (angle: number): Vec2 => [STEP.x + STEP.unit * between(0, angle, STEP.most), STEP.y];
const points = (numbers: readonly number[]): Vec2[] =>
  Array.from({ length: numbers.length / 2 }, (_, i) =>
    inPlane(numbers[2 * i] ?? 0, numbers[2 * i + 1] ?? 0),
  );
const named = (scheme: number): string => SCHEMES[scheme]?.name ?? "–";
const small = { role: "muted", size: "small" } as const;
const axis = { role: "muted", width: 1 } as const;

function plane(scene: Scene, { scheme }: Input, output: Output): void {
  const [far, near] = [PLANE.d[1], PLANE.d[0]];
  scene.face(
    [
      inPlane(0, PLANE.p[0]),
      inPlane(far, PLANE.p[0]),
      inPlane(far, PLANE.p[1]),
      inPlane(0, PLANE.p[1]),
    ],
    { role: "surface", fill: 0.12, outline: false },
  );
  scene.line(inPlane(near, 0), inPlane(far, 0), axis);
  scene.line(inPlane(0, PLANE.p[0]), inPlane(0, PLANE.p[1]), axis);
  scene.label(inPlane(near, PLANE.p[1]), "approach over penetration", {
    ...small,
    offset: [0, -10],
  });
  scene.label(inPlane(1, 0), "v/ω₀", { ...small, offset: [8, 16] });
  for (const [p, text] of [
    [1, "v"],
    [-1, "−v"],
  ] as const)
    scene.label(inPlane(near, p), text, { ...small, offset: [-4, 4], anchor: "end" });
  scene.line(inPlane(1, -0.05), inPlane(1, 0.05), axis);
  scene.path(points(output.exact), { role: "ink", width: 1.4, dashed: true });

  const role = SCHEMES[scheme]?.role ?? "ray";
  const all = points(output.trace).slice(0, output.recorded);
  for (let bounce = BOUNCES; bounce >= 0; bounce--) {
    const part = all.filter((_, i) => output.trace_bounce[i] === bounce);
    if (part.length < 2) continue;
    const first = bounce === 0;
    scene.path(part, { role: first ? role : "muted", width: first ? 2.2 : 1 });
    if (first) for (const at of part) scene.dot(at, role, 3.5);
  }
}

function energies(scene: Scene, { scheme }: Input, output: Output): void {
  const low = ofEnergy(0, 1e-3)[1];
  const high = ofEnergy(0, 1e3)[1];
  const end = ofEnergy(BOUNCES, 1);
  scene.line([ENERGY.x, low], [ENERGY.x, high], axis);
  for (const power of ENERGY.powers) {
    const at = ofEnergy(0, 10 ** power);
    scene.line(at, [end[0], at[1]], { role: "ghost", width: 1 });
    scene.label(at, pretty(10 ** power), { ...small, offset: [-6, 4], anchor: "end" });
  }
  scene.label([ENERGY.x, high], "energy after each bounce", { ...small, offset: [-14, -12] });
  for (const bounce of [4, 8, 12])
    scene.label([ofEnergy(bounce, 1)[0], low], pretty(bounce), {
      ...small,
      offset: [0, 14],
      anchor: "middle",
    });
  scene.path(
    Array.from({ length: BOUNCES + 1 }, (_, n) => ofEnergy(n, output.kept ** n)),
    { role: "ink", width: 1.4, dashed: true },
  );
  const ends: { name: string; role: Role; at: Vec2 }[] = [];
  SCHEMES.forEach(({ short, role }, s) => {
    const made = output.counted[s] ?? 0;
    const path = Array.from({ length: made + 1 }, (_, n) =>
      ofEnergy(n, output.energy[(BOUNCES + 1) * s + n] ?? 1),
    );
    scene.path(path, { role, width: s === scheme ? 3 : 1.3 });
    if (s === scheme) for (const at of path) scene.dot(at, role, 3);
    const at = path.at(-1);
    if (at) ends.push({ name: short, role, at });
  });
  // From the lowest up, then from the highest possible down.
  const sorted = ends.sort((one, other) => one.at[1] - other.at[1]);
  const heights: number[] = [];
  for (const { at } of sorted) heights.push(Math.max(at[1], (heights.at(-1) ?? -99) + APART));
  for (let i = heights.length - 1; i >= 0; i--)
    heights[i] = Math.min(heights[i] ?? 0, (heights[i + 1] ?? HIGHEST + APART) - APART);
  sorted.forEach(({ name, role, at }, i) => {
    scene.label([Math.max(at[0], ENERGY.x + 1.2), heights[i] ?? at[1]], name, {
      role,
      offset: [8, 4],
      size: "small",
    });
  });
}

function mark(scene: Scene, angle: number, text: string, role: Role, below = false): void {
  if (!(angle <= STEP.most)) return;
  const [x, y] = ofStep(angle);
  scene.line([x, y - 0.25], [x, y + 0.25], { role, width: 2.5 });
  const offset: Vec2 = [0, below ? 42 : -16];
  scene.label([x, y], text, { role, offset, anchor: "middle", size: "small" });
}

function steps(scene: Scene, { step }: Input, output: Output): void {
  const { rate, limit, ten_percent } = output;
  const stable = output.has_limit ? between(0, rate * limit, STEP.most) : STEP.most;
  scene.line(ofStep(0), ofStep(STEP.most), axis);
  if (stable > 0) scene.line(ofStep(0), ofStep(stable), { role: "hit", width: 4 });
  if (stable < STEP.most) scene.line(ofStep(stable), ofStep(STEP.most), { role: "miss", width: 4 });
  if (output.has_limit) mark(scene, rate * limit, `limit ${pretty(limit, 3)} s`, "miss");
  if (ten_percent > 0) mark(scene, rate * ten_percent, "energy within 10 %", "hit", true);
  for (const angle of [0, 1, 2, 3, 4])
    scene.label(ofStep(angle), pretty(angle), { ...small, offset: [0, 22], anchor: "middle" });
  scene.label(ofStep(STEP.most), "ω₀ h", {
    role: "ink",
    offset: [4, -12],
    anchor: "middle",
    size: "small",
  });
  scene.line(ofStep(rate * step), [ofStep(rate * step)[0], STEP.y + 0.35], {
    role: "muted",
    width: 1,
  });
}

const behaviours = ["decays", "stays bounded", "grows"] as const;

export default defineFigure<Input, Output>({
  title: "The length of the step, and the energy of a bounce",
  view: { kind: "2d", x: [0, 11.5], y: [0.2, 10] },
  aspect: 1.17,
  initial: { step: 0.02, stiffness: 1000, ratio: 0, scheme: 1, phase: 0.5 },
  handles: [
    {
      kind: "slide",
      field: "step",
      label: "length of the step, s",
      role: "b",
      at: ({ step }, { rate }): Vec2 => ofStep(rate * step),
      along: (_input, { rate }): Vec2 => [STEP.unit * rate, 0],
      step: 0.0005,
      limit: [0.0005, 0.2],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "scheme",
      label: "scheme",
      options: SCHEMES.map(({ name }, value) => ({ value, label: name })),
    },
    {
      kind: "slider",
      field: "step",
      label: "step",
      min: 0.0005,
      max: 0.125,
      step: 0.0005,
      unit: "s",
    },
    { kind: "slider", field: "ratio", label: "damping ratio", min: 0, max: 1.5, step: 0.01 },
    {
      kind: "slider",
      field: "phase",
      label: "first overlap, over v h",
      min: 0,
      max: 0.99,
      step: 0.01,
    },
    { kind: "numbers", field: "stiffness", label: "k", step: 10, unit: "N/m" },
    {
      kind: "states",
      label: "Step",
      options: [
        { label: "20 steps in a contact", fields: { step: 0.005 } },
        { label: "5 steps", fields: { step: 0.02 } },
        {
          label: "just below the limit",
          fields: { scheme: 1, ratio: 0, stiffness: 1000, step: 0.06 },
        },
        { label: "beyond", fields: { scheme: 1, ratio: 0, stiffness: 1000, step: 0.07 } },
      ],
    },
  ],
  draw(scene, input, output) {
    if (output.problem) return;
    plane(scene, input, output);
    energies(scene, input, output);
    steps(scene, input, output);
  },
  values({ scheme }, output): Value[] {
    const role = SCHEMES[scheme]?.role ?? "ray";
    return [
      { name: "c", meaning: "damper of both walls", value: output.damping, unit: "N·s/m" },
      {
        name: "limit",
        meaning: `smallest step that grows: ${named(scheme)}`,
        value: output.has_limit ? output.limit : "none",
        unit: "s",
        role: "miss",
      },
      {
        name: "limit_si",
        meaning: "the same for semi-implicit Euler",
        value: output.semi_implicit_limit,
        unit: "s",
      },
      {
        name: "this step",
        meaning: "on a spring that is never left",
        value: behaviours[output.behaviour] ?? "–",
      },
      { name: "steps", meaning: "in the first contact", value: output.steps },
      {
        name: "E₁/E₀",
        meaning: "energy left after one bounce, in steps",
        value: output.first_kept,
        role,
      },
      { name: "e²", meaning: "the same by the closed form", value: output.kept },
      {
        name: "bounds",
        meaning: "of that, wherever the steps fall",
        value: output.max_kept
          ? `${pretty(output.min_kept, 3)} … ${pretty(output.max_kept, 3)}`
          : "–",
      },
    ];
  },
  describe({ scheme, step, ratio }, output) {
    const name = named(scheme);
    const made = output.counted[scheme] ?? 0;
    const last = output.energy[(BOUNCES + 1) * scheme + made] ?? 1;
    const limit = output.has_limit
      ? step < output.limit
        ? `below its limit of ${pretty(output.limit, 3)} s`
        : `not below its limit of ${pretty(output.limit, 3)} s`
      : "for which it has no limit";
    const energy = made
      ? `After ${made} bounce${made === 1 ? "" : "s"} the energy is ${pretty(last, 3)} times that at the start; the closed form gives ${pretty(output.kept ** made, 3)}.`
      : "The ball does not leave the first wall.";
    return `${name[0]?.toUpperCase()}${name.slice(1)} with a step of ${pretty(step, 3)} s, ${limit}${ratio === 0 ? ", without a damper" : ""}. ${energy}`;
  },
});
