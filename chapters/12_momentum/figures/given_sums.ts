// The errors of five sums of a list of impulses against the number of impulses, on a logarithmic
// scale; above them the impulses themselves, each as a line.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  impulses: readonly number[];
  type: number;
  count: number;
}

interface Output {
  recursive: readonly number[];
  halves: readonly number[];
  kahan: readonly number[];
  compensated: readonly number[];
  book: readonly number[];
  count: number;
  read: readonly number[];
  errors: readonly number[];
  right: number;
  size: number;
}

/**
 * How each error is drawn, in the order of `read`; a wide one lies under those after it. Beside `named` impulses is its
 * name, or at the last ones before them that have an error.
 */
const WAYS = [
  { field: "recursive", name: "recursive", role: "miss", width: 3, named: 24 },
  { field: "halves", name: "pairwise", role: "b", width: 2, named: 50 },
  { field: "kahan", name: "Kahan", role: "normal", width: 2, named: 76 },
  { field: "compensated", name: "compensated", role: "hit", width: 5, named: 104 },
  { field: "book", name: "the book’s", role: "ink", width: 1.5, named: 62 },
] as const;

const TERMS = 128;
/** Powers of ten at the lower and the upper edge, and how high one of them is. */
const LOW = -18;
const HIGH = -4;
const TALL = 0.45;
const height = (error: number): number =>
  (Math.max(LOW, Math.min(HIGH, Math.log10(error))) - LOW) * TALL;
const across = (n: number): number => (10 * n) / TERMS;
/** The impulses are above the errors; the largest is as high as HALF. */
const MIDDLE = 7.6;
const HALF = 0.8;

export default defineFigure<Input, Output>({
  title: "Errors of the sums of given impulses",
  view: { kind: "2d", x: [-1.2, 10.9], y: [-0.9, 8.7] },
  aspect: 1.15,
  initial: {
    // A triangle wave, as of a force that changes sign.
    impulses: Array.from(
      { length: TERMS },
      (_, k) => Math.round(1000 * (4 * Math.abs(((k / 11) % 1) - 0.5) - 1)) / 1000,
    ),
    type: 0,
    count: 100,
  },
  handles: [
    {
      kind: "slide",
      field: "count",
      label: "n, the number of impulses that are added",
      role: "muted",
      at: (_input, output): Vec2 => [across(output.count), 0],
      along: (): Vec2 => [across(1), 0],
      step: 1,
      limit: [1, TERMS],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "type",
      label: "numbers",
      options: [
        { value: 0, label: "single precision" },
        { value: 1, label: "double precision" },
      ],
    },
    { kind: "slider", field: "count", label: "n", min: 1, max: TERMS, step: 1 },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    const small = { role: "muted", size: "small" } as const;
    scene.arrow([0, 0], [10.4, 0], axis).arrow([0, 0], [0, 6.6], axis);
    scene.label([10.4, 0], "n", { role: "muted", offset: [6, 5] });
    for (let power = LOW; power <= HIGH; power += 2) {
      const y = height(10 ** power);
      scene.line([0, y], [10, y], { role: "ghost", width: 1 });
      scene.label([0, y], `1e${power}`, { ...small, offset: [-6, 4], anchor: "end" });
    }
    for (const n of [32, 64, 96])
      scene.label([across(n), 0], pretty(n), { ...small, offset: [0, 20], anchor: "middle" });
    scene.line([0, MIDDLE], [10, MIDDLE], axis);
    scene.label([0, MIDDLE], "J", { ...small, offset: [-6, 4], anchor: "end" });
    const largest = Math.max(...input.impulses.map(Math.abs));
    for (const [k, impulse] of input.impulses.entries()) {
      const x = across(k + 1);
      if (largest > 0)
        scene.line([x, MIDDLE], [x, MIDDLE + (HALF * impulse) / largest], {
          role: k < output.count ? "ray" : "ghost",
          width: 2,
        });
    }
    if (output.problem) return;
    const read = across(output.count);
    scene.line([read, 0], [read, MIDDLE - HALF], { role: "muted", width: 1.5, dashed: true });
    for (const { field, name, role, width, named } of WAYS) {
      // An error of 0 has no logarithm, and interrupts its curve.
      let piece: Vec2[] = [];
      const finish = (): void => {
        if (piece.length > 1) scene.path(piece, { role, width });
        else if (piece[0]) scene.dot(piece[0], role, width);
        piece = [];
      };
      for (const [k, error] of output[field].entries()) {
        if (height(error) > 0) piece.push([across(k + 1), height(error)]);
        else finish();
      }
      finish();
      const errors = output[field].slice(0, named);
      const beside = errors.map((error) => height(error) > 0).lastIndexOf(true);
      const below = field === "compensated";
      if (beside >= 0)
        scene.label([across(beside + 1), height(errors[beside] ?? 0)], name, {
          role,
          offset: [0, below ? 20 : -10],
          anchor: "middle",
          size: "small",
        });
    }
  },
  values: (_input, output) => [
    { name: "right", meaning: "exact, then rounded", value: output.right, unit: "N·s" },
    { name: "Σ|J|", meaning: "sum of the magnitudes", value: output.size, unit: "N·s" },
    ...WAYS.map(({ name, role }, k) => ({
      name,
      meaning: `error ${pretty(output.errors[k] ?? 0, 2)} Σ|J|`,
      value: output.read[k] ?? 0,
      unit: "N·s",
      role: role as Role,
    })),
  ],
  describe(input, output) {
    const told = WAYS.map(({ name }, k) => `${name} ${pretty(output.errors[k] ?? 0, 2)}`);
    const type = input.type > 0 ? "double" : "single";
    return `After ${pretty(output.count)} impulses in ${type} precision the errors, relative to the sum of the magnitudes, are: ${told.join(", ")}.`;
  },
});
