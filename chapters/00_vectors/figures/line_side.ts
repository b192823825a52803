// 17 × 17 neighbouring points round the line y = x, each with the side that a formula gives it.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  zoom: number;
  method: number;
}

interface Output {
  side: readonly number[];
  wrong: readonly number[];
  spacing: number;
  wrong_expanded: number;
  wrong_by_differences: number;
  wrong_exactly: number;
}

const CELLS = 17;
const RAIL = -1.6;
const PER_STEP = CELLS / 53;
const METHODS = ["products first", "differences first", "without rounding"] as const;

export default defineFigure<Input, Output>({
  title: "On which side of the line?",
  view: { kind: "2d", x: [-0.6, 17.6], y: [-3, 17.6] },
  aspect: 0.9,
  initial: { zoom: 50, method: 0 },
  handles: [
    {
      kind: "slide",
      field: "zoom",
      label: "zoom: the points are 2 to the power of minus this apart",
      role: "ray",
      at: (input): Vec2 => [PER_STEP * input.zoom, RAIL],
      along: (): Vec2 => [PER_STEP, 0],
      step: 1,
      limit: [30, 53],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "Method",
      options: METHODS.map((label, value) => ({ value, label })),
    },
    { kind: "slider", field: "zoom", label: "zoom", min: 30, max: 53, step: 1 },
  ],
  draw(scene, _input, output) {
    scene.line([0, RAIL], [CELLS, RAIL], { role: "muted", width: 1.5 });
    scene.label([0, RAIL], "far", { role: "muted", offset: [0, 24], size: "small" });
    scene.label([CELLS, RAIL], "every double", {
      role: "muted",
      offset: [0, 24],
      anchor: "end",
      size: "small",
    });
    if (output.problem) return;
    for (const [i, side] of output.side.entries()) {
      const x = i % CELLS;
      const y = Math.floor(i / CELLS);
      const corners: Vec2[] = [
        [x + 0.06, y + 0.06],
        [x + 0.94, y + 0.06],
        [x + 0.94, y + 0.94],
        [x + 0.06, y + 0.94],
      ];
      const role: Role = side > 0 ? "a" : side < 0 ? "b" : "ghost";
      // Left is full, right is pale, and on the line there is nothing but the frame.
      scene.face(corners, { role, fill: side > 0 ? 0.75 : side < 0 ? 0.3 : 0, outline: side === 0 });
      if (output.wrong[i]) scene.dot([x + 0.5, y + 0.5], "miss", 3.5);
    }
    scene.line([0, 0], [CELLS, CELLS], { role: "ink", width: 1.5 });
    scene.label([0.6, CELLS - 1.3], "left", { role: "ink", offset: [4, 0] });
    scene.label([CELLS - 0.6, 0.9], "right", { role: "ink", offset: [-4, 0], anchor: "end" });
  },
  values: (_input, output) => [
    { name: "spacing", meaning: "from point to point", value: output.spacing.toExponential(2) },
    ...(
      [
        [METHODS[0], output.wrong_expanded],
        [METHODS[1], output.wrong_by_differences],
        [METHODS[2], output.wrong_exactly],
      ] as const
    ).map(([name, value]) => ({
      name,
      meaning: "wrong, of 289",
      value,
      role: (value > 0 ? "miss" : "hit") as Role,
    })),
  ],
  describe: (_input, output) =>
    `Of 289 points ${pretty(output.wrong_expanded)} are put on the wrong side by products first, ` +
    `${pretty(output.wrong_by_differences)} by differences first and ${pretty(output.wrong_exactly)} without rounding.`,
});
