// Above: the computed sum of many small impulses between a large one and its opposite, against
// their number. Below: the digits that the type holds for the large and the small impulse.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  power: number;
  small: number;
  count: number;
}

interface Output {
  power: number;
  count: number;
  recursive: readonly number[];
  halves: readonly number[];
  kahan: readonly number[];
  compensated: readonly number[];
  in_double: readonly number[];
  right: readonly number[];
  read: readonly number[];
  coarse: number;
  first_digit: number;
}

/** How each sum is drawn, in the order of `read`; `at` is the sample beside which its name is. */
const WAYS = [
  { field: "recursive", name: "recursive", role: "miss", width: 3, at: 42 },
  { field: "halves", name: "pairwise", role: "b", width: 2, at: 27 },
  { field: "kahan", name: "Kahan", role: "normal", width: 2, at: 33 },
  { field: "compensated", name: "compensated", role: "hit", width: 2, at: 37 },
  { field: "in_double", name: "double", role: "a", width: 2, at: 14 },
] as const;

/** The number of pushes at the right edge, which lies at 10, and how high the right total is there. */
const MOST = 1000;
const HIGH = 2.7;
/** The digits: those at the right and the left edge, how wide one is, the two rows and their scale. */
const FIRST = 52;
const LAST = -6;
const DIGIT = 10 / (FIRST - LAST + 1);
const LARGE = -2;
const SMALL = -2.8;
const SCALE = -3.3;
const POWERS = [
  [50, "2⁵⁰"],
  [40, "2⁴⁰"],
  [30, "2³⁰"],
  [20, "2²⁰"],
  [10, "2¹⁰"],
  [0, "1"],
] as const;

/** Where the digit that stands for a power of two begins; it ends, to the left, where the next begins. */
const digit = (power: number): number => DIGIT * (power - LAST + 1);

export default defineFigure<Input, Output>({
  title: "Many small impulses after a large one",
  view: { kind: "2d", x: [-0.9, 10.4], y: [-3.9, 5.9] },
  aspect: 1.2,
  initial: { power: 27, small: 0.1, count: 1000 },
  handles: [
    {
      kind: "slide",
      field: "power",
      label: "the large impulse, as a power of two, N·s",
      role: "surface",
      at: (_input, output): Vec2 => [digit(output.power), LARGE],
      along: (): Vec2 => [DIGIT, 0],
      step: 1,
      limit: [0, FIRST],
    },
  ],
  controls: [
    { kind: "slider", field: "power", label: "large: 2 to the", min: 0, max: FIRST, step: 1 },
    { kind: "slider", field: "small", label: "small", min: 0.05, max: 1, step: 0.01, unit: "N·s" },
    { kind: "slider", field: "count", label: "n", min: 0, max: MOST, step: 20 },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    const end = MOST * input.small;
    scene.arrow([0, 0], [10.3, 0], axis).arrow([0, 0], [0, 5.6], axis);
    scene.label([0, 5.6], "sum, N·s", { role: "muted", offset: [10, 6] });
    scene.label([10.3, 0], "n", { role: "muted", offset: [2, 24], anchor: "middle" });
    const small = { role: "muted", size: "small" } as const;
    for (const n of [250, 500, 750])
      scene.label([n / 100, 0], pretty(n), { ...small, offset: [0, 20], anchor: "middle" });
    for (const share of [0.5, 1, 1.5]) {
      scene.line([0, share * HIGH], [10, share * HIGH], { role: "ghost", width: 1 });
      scene.label([0, share * HIGH], pretty(share * end, 3), {
        ...small,
        offset: [-6, 4],
        anchor: "end",
      });
    }
    for (const [power, name] of POWERS) {
      scene.line([digit(power), SCALE - 0.08], [digit(power), SCALE + 0.08], axis);
      scene.label([digit(power), SCALE], name, { ...small, offset: [0, 20], anchor: "middle" });
    }
    scene.line([0, SCALE], [10, SCALE], axis);
    if (output.problem) return;

    const curve = (totals: readonly number[]): Vec2[] =>
      totals.map((total, k): Vec2 => [(10 * k) / (totals.length - 1), (total / end) * HIGH]);
    const over = (totals: readonly number[]): boolean => (totals.at(-1) ?? 0) > 1.1 * end;
    const crowded = over(output.recursive) || over(output.in_double);
    const read = (10 * output.count) / MOST;
    scene.line([read, 0], [read, 5.3], { role: "muted", width: 1.5, dashed: true });
    scene.path(curve(output.right), { role: "ghost", width: 9 });
    for (const { field, name, role, width, at } of WAYS) {
      const path = curve(output[field]);
      scene.path(path, { role, width, dashed: field === "in_double" });
      const beside = path[at];
      // Names are placed where no other curve is.
      const above =
        field === "compensated" ? !crowded : field === "in_double" || over(output[field]);
      // The numbers of the axis are below it.
      if (beside)
        scene.label(beside, name, {
          role,
          offset: [0, above || beside[1] < 0.4 ? -10 : 20],
          anchor: above ? "end" : "start",
          size: "small",
        });
    }

    const row = (from: number, count: number, y: number, role: Role, half: number): void => {
      const [left, right] = [Math.max(0, digit(from - count)), digit(from)];
      const corners: Vec2[] = [
        [left, y - half],
        [right, y - half],
        [right, y + half],
        [left, y + half],
      ];
      if (left < right) scene.face(corners, { role, fill: 1, outline: false });
    };
    const begin = output.first_digit;
    row(output.power, 53, LARGE, "a", 0.03);
    row(output.power, 24, LARGE, "miss", 0.09);
    row(begin, 24, SMALL, "ink", 0.09);
    scene.line([digit(begin), SMALL], [digit(begin), LARGE + 0.4], {
      role: "ink",
      width: 1,
      dashed: true,
    });
    scene.label([10, LARGE], "digits of the large impulse", {
      role: "surface",
      offset: [0, -17],
      anchor: "end",
      size: "small",
    });
    scene.label([digit(begin), SMALL], "of a small one", {
      role: "ink",
      offset: [8, 4],
      size: "small",
    });
  },
  values: (_input, output) => [
    { name: "right", meaning: "n times the small one", value: output.read[5] ?? 0, unit: "N·s" },
    ...WAYS.map(({ field, name, role }, k) => ({
      name: field === "in_double" ? "recursive" : name,
      meaning: field === "in_double" ? "double precision" : "single precision",
      value: output.read[k] ?? 0,
      unit: "N·s",
      role,
    })),
    {
      name: "ulp",
      meaning: "of the large float",
      value: output.coarse,
      unit: "N·s",
      role: "miss",
    },
  ],
  describe(input, output) {
    const [order = 0, halves = 0, kahan = 0, compensated = 0, double = 0, right = 0] = output.read;
    return `After 2 to the power ${pretty(output.power)} N·s, ${pretty(output.count)} impulses of ${pretty(input.small)} N·s and the large one reversed, the sum should be ${pretty(right)} N·s. In single precision recursive summation gives ${pretty(order)}, pairwise ${pretty(halves)}, Kahan’s ${pretty(kahan)}, compensated ${pretty(compensated)}; in double precision recursive summation gives ${pretty(double)}.`;
  },
});
