// Tenths are added on a line; below, the neighbourhood of the sum, magnified so that every number
// is visible.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  a: number;
  b: number;
  digits: number;
}

interface Output {
  a: number;
  b: number;
  sum: number;
  nearest: number;
  spacing: number;
  decimal_at: number;
  exact_at: number;
  nearest_at: number;
  error_a: number;
  error_b: number;
  neighbour_at: readonly number[];
  equal: number;
}

/** The line of tenths: its height, and the heights of the two arrows; world units in a tenth. */
const LINE = 3;
const A = 3.35;
const B = 3.8;
const TENTH = 0.5;
const MOST = 10;
/** The magnified part: the height of its line, its middle, its half width, world units in an ulp. */
const GLASS = 0.9;
const MIDDLE = 5;
const HALF = 4.6;
const ULP = 1.7;

const digits = (bits: number): number => (bits < 53 ? 9 : 17);
const text = (x: number, bits: number): string => x.toPrecision(digits(bits));

export default defineFigure<Input, Output>({
  title: "Tenths, as a computer adds them",
  view: { kind: "2d", x: [-0.2, 10.2], y: [-1, 4.3] },
  aspect: 1.6,
  initial: { a: 1, b: 2, digits: 53 },
  handles: [
    {
      kind: "slide",
      field: "a",
      label: "a, in tenths",
      role: "a",
      at: (_input, output): Vec2 => [TENTH * output.a, A],
      along: (): Vec2 => [TENTH, 0],
      step: 1,
      limit: [1, MOST],
    },
    {
      kind: "slide",
      field: "b",
      label: "b, in tenths",
      role: "b",
      at: (_input, output): Vec2 => [TENTH * (output.a + output.b), B],
      along: (): Vec2 => [TENTH, 0],
      step: 1,
      limit: [1, MOST],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "digits",
      label: "Stored in",
      options: [
        { value: 53, label: "double precision" },
        { value: 24, label: "single precision" },
      ],
    },
    { kind: "slider", field: "a", label: "a", min: 1, max: MOST, step: 1, unit: "tenths" },
    { kind: "slider", field: "b", label: "b", min: 1, max: MOST, step: 1, unit: "tenths" },
  ],
  draw(scene, _input, output) {
    scene.line([0, LINE], [2 * MOST * TENTH, LINE], { role: "muted", width: 1 });
    for (let tenth = 0; tenth <= 2 * MOST; tenth += 1) {
      const x = tenth * TENTH;
      const long = tenth % 10 === 0;
      scene.line([x, LINE], [x, LINE - (long ? 0.16 : 0.08)], { role: "muted", width: 1 });
      if (long)
        scene.label([x, LINE], pretty(tenth / 10), {
          role: "muted",
          offset: [0, 30],
          anchor: "middle",
          size: "small",
        });
    }
    if (output.problem) return;
    const at = TENTH * (output.a + output.b);
    scene.arrow([0, A], [TENTH * output.a, A], { role: "a", width: 3 });
    scene.arrow([TENTH * output.a, B], [at, B], { role: "b", width: 3 });

    // From the sum on the line to its magnified part.
    const edge = { role: "ghost", width: 1, dashed: true } as const;
    scene.line([at, LINE], [MIDDLE - HALF, GLASS + 1.05], edge);
    scene.line([at, LINE], [MIDDLE + HALF, GLASS + 1.05], edge);
    scene.face(
      [
        [MIDDLE - HALF, GLASS - 1.75],
        [MIDDLE + HALF, GLASS - 1.75],
        [MIDDLE + HALF, GLASS + 1.05],
        [MIDDLE - HALF, GLASS + 1.05],
      ],
      { role: "muted", fill: 0.05 },
    );
    scene.line([MIDDLE - HALF, GLASS], [MIDDLE + HALF, GLASS], { role: "ink", width: 1.5 });
    const position = (ulps: number): number => MIDDLE + ULP * ulps;
    const inside = (ulps: number): boolean => Math.abs(ULP * ulps) < HALF - 0.05;
    for (const ulps of output.neighbour_at) {
      if (!inside(ulps)) continue;
      scene.line([position(ulps), GLASS - 0.16], [position(ulps), GLASS + 0.16], {
        role: "ink",
        width: 2,
      });
    }
    const found: Role = output.equal ? "hit" : "miss";
    // Exact values are above the line, stored ones on it.
    scene.line([position(output.decimal_at), GLASS], [position(output.decimal_at), GLASS + 0.75], {
      role: "normal",
      width: 1.5,
    });
    scene.dot([position(output.decimal_at), GLASS + 0.75], "normal", 5, true);
    const left = output.decimal_at <= output.exact_at;
    scene.label([position(output.decimal_at), GLASS + 0.75], `(a + b)/10`, {
      role: "normal",
      offset: [left ? -10 : 10, 4],
      anchor: left ? "end" : "start",
      size: "small",
    });
    scene.line([position(output.exact_at), GLASS], [position(output.exact_at), GLASS + 0.4], {
      role: "ray",
      width: 1.5,
      dashed: true,
    });
    scene.dot([position(output.exact_at), GLASS + 0.4], "ray", 5);
    scene.label([position(output.exact_at), GLASS + 0.4], "stored a + stored b", {
      role: "ray",
      offset: [left ? 10 : -10, 4],
      anchor: left ? "start" : "end",
      size: "small",
    });
    scene.dot([position(0), GLASS], found, 6);
    scene.label([position(0), GLASS], "computed sum", {
      role: found,
      offset: [0, 30],
      anchor: "middle",
      size: "small",
    });
    if (!output.equal && inside(output.nearest_at)) {
      scene.dot([position(output.nearest_at), GLASS], "normal", 6, true);
      scene.label([position(output.nearest_at), GLASS], "nearest to (a + b)/10", {
        role: "normal",
        offset: [0, 50],
        anchor: "middle",
        size: "small",
      });
    }
  },
  values: (input, output) => [
    {
      name: "a + b",
      meaning: "computed sum",
      value: text(output.sum, input.digits),
      role: output.equal ? "hit" : "miss",
    },
    {
      name: "nearest",
      meaning: "to (a + b)/10",
      value: text(output.nearest, input.digits),
      role: "normal",
    },
    { name: "ulp", meaning: "spacing of the numbers", value: output.spacing.toExponential(2) },
    {
      name: "a",
      meaning: "stored − decimal, in ulps of the sum",
      value: output.error_a,
      role: "a",
    },
    {
      name: "b",
      meaning: "stored − decimal, in ulps of the sum",
      value: output.error_b,
      role: "b",
    },
  ],
  describe(input, output) {
    const tenths = (n: number): string => (n === 1 ? "one tenth" : `${pretty(n)} tenths`);
    const said = `${tenths(output.a)} and ${tenths(output.b)}`;
    const type = input.digits < 53 ? "single" : "double";
    const meant = `the number nearest to ${tenths(output.a + output.b)}`;
    return output.equal
      ? `In ${type} precision ${said} give ${meant}.`
      : `In ${type} precision ${said} give a neighbour of ${meant}.`;
  },
});
