// The friction of a contact at one visit: the sum that would stop the slip, and the nearest sum that
// Coulomb's law allows.

import { defineFigure, pretty, type Scene, type Value, type Vec2 } from "@contact/figure";

interface Input {
  sum: readonly number[];
  slip: readonly number[];
  effective_mass: number;
  mu: number;
  normal: number;
}

interface Output {
  limit: number;
  wanted: readonly number[];
  after: readonly number[];
  change: readonly number[];
  left: readonly number[];
  sticks: number;
  clamped_change: readonly number[];
  by_axis: readonly number[];
  change_is_wrong: number;
  axis_is_wrong: number;
}

const EDGE = 2.2;
const KEY = { left: -2.1, right: -0.05, high: -2.5, low: -2.8 } as const;
const small = { role: "muted", size: "small" } as const;
const origin: Vec2 = [0, 0];
const point = ([x = 0, y = 0]: readonly number[]): Vec2 => [x, y];

function disc(scene: Scene, { limit }: Output): void {
  scene.line([-EDGE, 0], [EDGE, 0], { role: "muted", width: 1 });
  scene.line([0, -EDGE], [0, EDGE], { role: "muted", width: 1 });
  scene.ball(origin, limit, { role: "surface", fill: 0.2 });
}

function others(scene: Scene, output: Output): void {
  if (output.axis_is_wrong) {
    const { limit } = output;
    const corners: Vec2[] = [
      [-limit, -limit],
      [limit, -limit],
      [limit, limit],
      [-limit, limit],
      [-limit, -limit],
    ];
    scene.path(corners, { role: "b", width: 1, dashed: true });
    scene.dot(point(output.by_axis), "b", 5, true);
  }
  if (output.change_is_wrong) scene.dot(point(output.clamped_change), "miss", 5, true);
}

/** What is what, below all that can be dragged. */
function key(scene: Scene, output: Output): void {
  const { left, right, high, low } = KEY;
  scene.ball([left, high], 0.1, { role: "surface", fill: 0.2 });
  scene.label([left, high], "radius: μ · normal impulse", { ...small, offset: [14, 4] });
  for (const [shown, x, name, role] of [
    [output.change_is_wrong, left, "change clamped", "miss"],
    [output.axis_is_wrong, right, "each component clamped", "b"],
  ] as const) {
    if (!shown) continue;
    scene.dot([x, low], role, 5, true);
    scene.label([x, low], name, { role, size: "small", offset: [14, 4] });
  }
}

export default defineFigure<Input, Output>({
  title: "The disc of friction",
  view: { kind: "2d", x: [-2.3, 2.3], y: [-2.95, 2.3] },
  aspect: 0.95,
  initial: { sum: [0.8, 0.3], slip: [-0.6, 1.3], effective_mass: 1, mu: 0.5, normal: 2 },
  handles: [
    {
      kind: "point",
      field: "slip",
      label: "slip, m/s",
      role: "c",
      step: 0.05,
      limit: [-2.2, 2.2],
    },
    {
      kind: "point",
      field: "sum",
      label: "sum of the friction before, N·s",
      role: "a",
      step: 0.05,
      limit: [-2.2, 2.2],
    },
  ],
  controls: [
    { kind: "slider", field: "mu", label: "μ", min: 0, max: 1, step: 0.05 },
    {
      kind: "slider",
      field: "normal",
      label: "normal impulse",
      min: 0,
      max: 4,
      step: 0.1,
      unit: "N·s",
    },
    {
      kind: "slider",
      field: "effective_mass",
      label: "effective mass",
      min: 0.2,
      max: 2,
      step: 0.1,
      unit: "kg",
    },
    {
      kind: "numbers",
      field: "sum",
      label: "sum before",
      role: "a",
      axes: ["first", "second"],
      step: 0.1,
      unit: "N·s",
    },
    {
      kind: "numbers",
      field: "slip",
      label: "slip",
      role: "c",
      axes: ["first", "second"],
      step: 0.1,
      unit: "m/s",
    },
    {
      kind: "states",
      label: "Contact",
      options: [
        { label: "sticks", fields: { sum: [0.3, 0.2], slip: [0.5, -0.3], mu: 0.5, normal: 2 } },
        { label: "slides", fields: { sum: [0.8, 0.3], slip: [-0.6, 1.3], mu: 0.5, normal: 2 } },
        {
          label: "slides obliquely",
          fields: { sum: [0, 0], slip: [-1.6, -1.2], mu: 0.5, normal: 2 },
        },
        { label: "less normal impulse", fields: { sum: [0.9, 0], slip: [0, 0], normal: 1 } },
      ],
    },
  ],
  draw(scene, { sum, slip }, output) {
    if (output.problem) return;
    disc(scene, output);
    const [from, wanted, after] = [point(sum), point(output.wanted), point(output.after)];
    scene.arrow(origin, point(slip), { role: "c", width: 2 });
    scene.arrow(origin, from, { role: "a", width: 2 });
    scene.arrow(from, wanted, { role: "muted", width: 1.5, dashed: true });
    if (!output.sticks) scene.line(wanted, after, { role: "muted", width: 1, dashed: true });
    others(scene, output);
    scene.arrow(origin, after, { role: "hit", width: 3 });
    key(scene, output);
  },
  values(_input, output): Value[] {
    return [
      { name: "limit", meaning: "μ times the normal impulse, N·s", value: output.limit },
      { name: "wanted", meaning: "sum that would stop the slip, N·s", value: output.wanted },
      { name: "sum", meaning: "after the visit, N·s", value: output.after, role: "hit" },
      { name: "change", meaning: "impulse on the bodies, N·s", value: output.change },
      { name: "slip", meaning: "after the visit, m/s", value: output.left, role: "c" },
      { name: "contact", meaning: "after the visit", value: output.sticks ? "sticks" : "slides" },
      {
        name: "sum",
        meaning: "if the change were clamped instead, N·s",
        value: output.clamped_change,
        role: "miss",
      },
      {
        name: "sum",
        meaning: "if each component were clamped, N·s",
        value: output.by_axis,
        role: "b",
      },
    ];
  },
  describe(_input, output) {
    const limit = pretty(output.limit, 3);
    if (output.sticks)
      return `The sum that stops the slip lies in the disc of radius ${limit} N·s, so the contact sticks.`;
    return `The sum that would stop the slip lies outside the disc of radius ${limit} N·s. The nearest point of the disc is the new sum, and the contact slides on.`;
  },
});
