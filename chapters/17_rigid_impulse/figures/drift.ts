// The error of four methods of integrating an orientation, or five, against time, on a logarithmic
// scale.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  steps: number;
  angular_velocity: number;
  shape: number;
  angle: number;
  also: number;
  at: number;
}

interface Output {
  matrix: readonly number[];
  quaternion: readonly number[];
  exponential: readonly number[];
  midpoint: readonly number[];
  other: readonly number[];
  read: readonly number[];
  length: number;
}

const WAYS = [
  ["matrix", "Euler’s matrix", "a"],
  ["quaternion", "quaternion", "b"],
  ["exponential", "exponential map", "c"],
  ["midpoint", "midpoint", "hit"],
] as const;
/** Where the name of each is: sample, pixels below it, and anchor. Curves may be one, so no two names have one time. */
const NAMES = [
  [35, -10, "middle"],
  [17, 22, "end"],
  [40, 20, "end"],
  [7, 22, "middle"],
] as const;
/** The fifth curve, by the number of its choice. */
const OTHERS = ["", "orthonormalised", "one moment for all axes"] as const;
/** Powers of ten at the lower and the upper edge, and how high one of them is. */
const LOW = -8;
const HIGH = 2;
const TALL = 0.6;
/** Where a power of ten is on the scale. */
const height = (power: number): number => (Math.max(LOW, Math.min(HIGH, power)) - LOW) * TALL;

export default defineFigure<Input, Output>({
  title: "Drift of an orientation",
  view: { kind: "2d", x: [-1.2, 10.9], y: [-0.9, 6.5] },
  aspect: 1.35,
  initial: {
    steps: 60,
    angular_velocity: 3,
    shape: 0.5,
    angle: 37,
    also: 0,
    at: 5,
  },
  handles: [
    {
      kind: "slide",
      field: "at",
      label: "t, the time that is read off, s",
      role: "muted",
      at: (input): Vec2 => [input.at, 0],
      along: (): Vec2 => [1, 0],
      step: 0.25,
      limit: [0, 10],
    },
  ],
  controls: [
    { kind: "slider", field: "steps", label: "steps a second", min: 8, max: 480, step: 4 },
    {
      kind: "slider",
      field: "angular_velocity",
      label: "ω",
      min: 0,
      max: 30,
      step: 0.5,
      unit: "rad/s",
    },
    { kind: "slider", field: "shape", label: "I₃/I₁", min: 0.05, max: 2, step: 0.05 },
    {
      kind: "slider",
      field: "angle",
      label: "ω to the axis",
      min: 0,
      max: 90,
      step: 1,
      unit: "°",
    },
    {
      kind: "choice",
      field: "also",
      label: "a fifth curve",
      options: [
        { value: 0, label: "none" },
        { value: 1, label: "Euler’s matrix, orthonormalised" },
        { value: 2, label: "one moment for all axes" },
      ],
    },
    { kind: "slider", field: "at", label: "t", min: 0, max: 10, step: 0.25, unit: "s" },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow([0, 0], [10.6, 0], axis).arrow([0, 0], [0, 6.3], axis);
    scene.label([10.6, 0], "t, s", { role: "muted", offset: [0, 20], anchor: "end" });
    for (let power = LOW; power <= HIGH; power += 2) {
      scene.line([0, height(power)], [10.4, height(power)], { role: "ghost", width: 1 });
      scene.label([0, height(power)], power === 0 ? "1" : `1e${power}`, {
        role: "muted",
        offset: [-6, 4],
        anchor: "end",
        size: "small",
      });
    }
    for (const t of [2, 4, 6, 8])
      scene.label([t, 0], pretty(t), {
        role: "muted",
        offset: [0, 20],
        anchor: "middle",
        size: "small",
      });
    scene.line([input.at, 0], [input.at, 6.1], { role: "muted", width: 1, dashed: true });
    if (output.problem) return;
    const curveOf = (errors: readonly number[]): Vec2[] =>
      errors.map((error, i): Vec2 => [i / 4, height(Math.log10(error))]).filter(([, y]) => y > 0);
    for (const [k, [field, name, role]] of WAYS.entries()) {
      const curve = curveOf(output[field]);
      // An exact method lies below the scale and has no curve.
      if (curve.length < 2) continue;
      scene.path(curve, { role, width: k === 1 ? 5 : 2, dashed: k === 2 });
      const [sample, below, anchor] = NAMES[k] ?? NAMES[0];
      const at = curve[Math.min(sample, curve.length - 1)];
      if (at) scene.label(at, name, { role, offset: [0, below], anchor, size: "small" });
    }
    const other = curveOf(output.other);
    if (other.length < 2) return;
    scene.path(other, { role: "miss", width: 2 });
    // Where its name is clear of the names of the others.
    scene.label(other[2] ?? [0, 0], OTHERS[input.also] ?? "", {
      role: "miss",
      offset: [0, -10],
      size: "small",
    });
  },
  values: (input, output) => [
    ...WAYS.map(([, name, role], k) => ({
      name,
      meaning: "error at t",
      value: output.read[k] ?? 0,
      role: role as Role,
    })),
    ...(input.also > 0
      ? [
          {
            name: OTHERS[input.also] ?? "",
            meaning: "error at t",
            value: output.read[4] ?? 0,
            role: "miss" as Role,
          },
        ]
      : []),
    {
      name: "length",
      meaning: "of the longest column of Euler’s matrix, at 10 s",
      value: output.length,
      role: "a" as Role,
    },
  ],
  describe(input, output) {
    const other =
      input.also > 0
        ? ` The fifth curve, ${OTHERS[input.also]}, is off by ${pretty(output.read[4] ?? 0, 2)}.`
        : "";
    return `At ${pretty(input.at)} s and ${pretty(input.steps)} steps a second, Euler’s matrix is off by ${pretty(output.read[0] ?? 0, 2)}, the quaternion by ${pretty(output.read[1] ?? 0, 2)}, the exponential map by ${pretty(output.read[2] ?? 0, 2)} and the midpoint by ${pretty(output.read[3] ?? 0, 2)}.${other}`;
  },
});
