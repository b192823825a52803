// A table of close cases: five neighbouring mass ratios, and the counts of four methods.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  n: number;
}

interface Output {
  ratio: readonly number[];
  right: readonly number[];
  by_formula: readonly number[];
  by_textbook: readonly number[];
  by_book: readonly number[];
  wrong: readonly number[];
  asked: number;
}

const ROWS = [3, 1.9, 0.8, -0.3] as const;
const SCALE = -1.9;
const column = (i: number): number => 1 + 1.9 * (i - 2);
const position = (n: number): number => -5 + n / 500;

export default defineFigure<Input, Output>({
  title: "Close cases",
  view: { kind: "2d", x: [-6.2, 6.2], y: [-3, 5] },
  aspect: 1.4,
  initial: { n: 314 },
  handles: [
    {
      kind: "slide",
      field: "n",
      label: "n: n steps of θ are nearly π",
      role: "ray",
      at: (input): Vec2 => [position(input.n), SCALE],
      along: (): Vec2 => [1 / 500, 0],
      step: 1,
      limit: [5, 5000],
    },
  ],
  controls: [{ kind: "numbers", field: "n", label: "n", role: "ray", step: 1 }],
  draw(scene, _input, output) {
    scene.line([position(0), SCALE], [position(5000), SCALE], { role: "muted", width: 2 });
    for (const n of [5, 1000, 2000, 3000, 4000, 5000]) {
      scene.line([position(n), SCALE - 0.1], [position(n), SCALE + 0.1], {
        role: "muted",
        width: 1,
      });
      scene.label([position(n), SCALE], pretty(n), {
        role: "muted",
        offset: [0, 20],
        anchor: "middle",
        size: "small",
      });
    }
    if (output.problem) return;
    for (let i = 0; i < 5; ++i) {
      scene.label(
        [column(i), 4],
        i === 2 ? "nearest" : `${i < 2 ? "−" : "+"}${Math.abs(i - 2)} ulp`,
        {
          role: "muted",
          anchor: "middle",
          size: "small",
        },
      );
    }
    const rows = [
      ["certain", output.right],
      ["formula", output.by_formula],
      ["textbook", output.by_textbook],
      ["book", output.by_book],
    ] as const;
    for (const [row, [name, counts]] of rows.entries()) {
      const y = ROWS[row] ?? 0;
      scene.label([-6, y], name, { role: "ink", offset: [0, 4] });
      for (const [i, count] of counts.entries()) {
        const good = count === output.right[i];
        const role = row === 0 ? "normal" : good ? "hit" : "miss";
        const x = column(i);
        scene.face(
          [
            [x - 0.85, y - 0.42],
            [x + 0.85, y - 0.42],
            [x + 0.85, y + 0.42],
            [x - 0.85, y + 0.42],
          ],
          { role, fill: good ? 0.12 : 0.3, dashed: !good },
        );
        scene.label([x, y], `${good ? "" : "✗ "}${pretty(count)}`, {
          role,
          offset: [0, 4],
          anchor: "middle",
          size: "small",
        });
      }
    }
  },
  values: (_input, output) => [
    { name: "R", meaning: "M/m, nearest to cot²(π/n)", value: output.ratio[2] ?? 0 },
    {
      name: "formula",
      meaning: `wrong of ${output.asked}, from n on`,
      value: output.wrong[0] ?? 0,
      role: "miss",
    },
    { name: "textbook", meaning: "wrong of as many", value: output.wrong[1] ?? 0, role: "miss" },
    {
      name: "book",
      meaning: "in double, wrong of as many",
      value: output.wrong[2] ?? 0,
      role: "miss",
    },
  ],
  describe(input, output) {
    const wrong = [output.by_formula, output.by_textbook, output.by_book]
      .map((counts) => counts.filter((count, i) => count !== output.right[i]).length)
      .reduce((sum, count) => sum + count, 0);
    return `At ${pretty(input.n)} steps the three methods that round miscount ${wrong} of these 15 times.`;
  },
});
