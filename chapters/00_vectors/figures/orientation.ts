// 17 × 17 points a millimetre apart, each with the side of the line that a formula computes.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  far: number;
  method: number;
}

interface Output {
  side: readonly number[];
  wrong: readonly number[];
  distance: number;
  wrong_expanded: number;
  wrong_by_differences: number;
  wrong_in_float: number;
}

const CELLS = 17;
const RAIL = -1.6;
const LAST = 42;
const PER_STEP = CELLS / LAST;
const METHODS = ["products first", "differences first", "differences first, float"] as const;

/** A distance in m or km. */
const said = (metres: number): string =>
  metres < 1000 ? `${pretty(metres, 3)} m` : `${pretty(metres / 1000, 3)} km`;

export default defineFigure<Input, Output>({
  title: "On which side of the line?",
  view: { kind: "2d", x: [-0.6, 17.6], y: [-3, 17.6] },
  aspect: 0.9,
  initial: { far: 24, method: 0 },
  handles: [
    {
      kind: "slide",
      field: "far",
      label: "distance from the origin: 2 to the power of this, in metres",
      role: "ray",
      at: (input): Vec2 => [PER_STEP * input.far, RAIL],
      along: (): Vec2 => [PER_STEP, 0],
      step: 1,
      limit: [0, LAST],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "Method",
      options: METHODS.map((label, value) => ({ value, label })),
    },
    { kind: "slider", field: "far", label: "far", min: 0, max: LAST, step: 1 },
  ],
  draw(scene, _input, output) {
    scene.line([0, RAIL], [CELLS, RAIL], { role: "muted", width: 1.5 });
    scene.label([0, RAIL], "near the origin", { role: "muted", offset: [0, 24], size: "small" });
    scene.label([CELLS, RAIL], "far away", {
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
      // Left is full, right is pale, on the line there is only the outline.
      scene.face(corners, {
        role,
        fill: side > 0 ? 0.75 : side < 0 ? 0.3 : 0,
        outline: side === 0,
      });
      if (output.wrong[i]) scene.dot([x + 0.5, y + 0.5], "miss", 3.5);
    }
    scene.line([0, 0], [CELLS, CELLS], { role: "ink", width: 1.5 });
    scene.label([0.6, CELLS - 1.3], "left", { role: "ink", offset: [4, 0] });
    scene.label([CELLS - 0.6, 0.9], "right", { role: "ink", offset: [-4, 0], anchor: "end" });
  },
  values: (_input, output) => [
    { name: "distance", meaning: "from the origin", value: said(output.distance), role: "ray" },
    ...(
      [
        [METHODS[0], output.wrong_expanded],
        [METHODS[1], output.wrong_by_differences],
        [METHODS[2], output.wrong_in_float],
      ] as const
    ).map(([name, value]) => ({
      name,
      meaning: "wrong, of 289",
      value,
      role: (value > 0 ? "miss" : "hit") as Role,
    })),
  ],
  describe: (_input, output) =>
    `At ${said(output.distance)} from the origin, of 289 points ${pretty(output.wrong_expanded)} are misclassified by products first, ` +
    `${pretty(output.wrong_by_differences)} by differences first and ${pretty(output.wrong_in_float)} by differences in single precision.`,
});
