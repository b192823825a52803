// Two nearly parallel arrows, and below them the errors of two formulas for their angle, for every
// power of ten.

import { defineFigure, type Role, type Vec2 } from "@contact/figure";

interface Input {
  u: Vec2;
  k: number;
  turned: number;
}

interface Output {
  k: number;
  v: Vec2;
  shared: number;
  angle: readonly number[];
  by_cosine: readonly number[];
  by_both: readonly number[];
  cosine_error: readonly number[];
  both_error: readonly number[];
  cosine_curve: readonly number[];
  both_curve: readonly number[];
}

const ORIGIN: Vec2 = [0, 0];
/** The chart: the position of k = 0 and an error of 1, and the distance to the next power of ten. */
const LEFT = -4.2;
const TOP = -2.8;
const RIGHTWARDS = 0.52;
const DOWNWARDS = 0.25;
const STEPS = 18;
const SUPER: Record<number, string> = { 0: "1", 4: "10⁻⁴", 8: "10⁻⁸", 12: "10⁻¹²", 16: "10⁻¹⁶" };
const NOWHERE = [-1, 0, 0] as const;
/** An error of 0 is drawn at the lower edge. */
const at = (k: number, error: number): Vec2 => [
  LEFT + RIGHTWARDS * k,
  TOP + DOWNWARDS * Math.max(-17, Math.min(0.8, Math.log10(error))),
];
const angle = (x = 0): string => x.toPrecision(9).replace("-", "−");
const off = (error = 0): string =>
  error < 0
    ? "the angle is 0"
    : error < 1e-15
      ? "off by less than 1e−15"
      : `off by ${error.toExponential(1).replace("-", "−")}`;

export default defineFigure<Input, Output>({
  title: "A small angle by two formulas",
  view: { kind: "2d", x: [-5.5, 5.3], y: [-8.4, 2.3] },
  aspect: 1.05,
  initial: { u: [1.5, 0], k: 5, turned: 0 },
  handles: [
    { kind: "point", field: "u", label: "the tip of u", role: "a", step: 0.1, limit: [-2, 2] },
    {
      kind: "slide",
      field: "k",
      label: "k, the power of ten",
      role: "ink",
      at: (_input, output): Vec2 => at(output.k, 1e-17),
      along: (): Vec2 => [RIGHTWARDS, 0],
      step: 1,
      limit: [0, STEPS - 1],
    },
  ],
  controls: [
    { kind: "slider", field: "k", label: "k", min: 0, max: STEPS - 1, step: 1, play: 8 },
    {
      kind: "choice",
      field: "turned",
      label: "the angle is",
      options: [
        { value: 0, label: "near 0" },
        { value: 1, label: "near π" },
      ],
    },
    { kind: "numbers", field: "u", label: "u", role: "a", step: 0.1 },
  ],
  draw(scene, input, output) {
    const faint = { role: "muted", width: 1 } as const;
    for (const [power, name] of Object.entries(SUPER)) {
      const n = Number(power);
      const error = 10 ** -n;
      scene.line(at(0, error), at(STEPS - 1, error), { role: "ghost", width: 1 });
      scene.label(at(0, error), name, {
        role: "muted",
        offset: [-6, 4],
        anchor: "end",
        size: "small",
      });
      scene.label(at(n, 1e-17), name, {
        role: "muted",
        offset: [0, 26],
        anchor: "middle",
        size: "small",
      });
    }
    scene.line(at(0, 1e-17), at(STEPS - 1, 1e-17), faint);
    scene.line(at(0, 1e-17), at(0, 1), faint);
    scene.label(at(0, 1), "relative error", { role: "muted", offset: [0, -24], size: "small" });
    scene.label(at(STEPS - 1, 1e-17), "angle", {
      role: "muted",
      offset: [4, -8],
      anchor: "end",
      size: "small",
    });
    scene.arrow(ORIGIN, input.u, { role: "a", width: 3 });
    scene.label(input.u, "u", { role: "a", offset: [8, 18] });
    if (output.problem) return;

    scene.arrow(ORIGIN, output.v, { role: "b", width: 3, dashed: true });
    scene.label(output.v, output.shared ? "v, stored as u" : "v", { role: "b", offset: [-4, -12] });
    scene.line(at(output.k, 1e-17), at(output.k, 1), { role: "muted", width: 1, dashed: true });
    // Of each label: at which k it is on its curve, and its offset from it.
    const positions: readonly (readonly [number, number, number])[] = input.turned
      ? [
          [4, 0, -8],
          [11, 8, 0],
          [3, 0, 20],
          [8, 0, -8],
        ]
      : [
          [4, 0, -8],
          [6, 8, 8],
          [6, 8, 8],
          [10, 0, -8],
        ];
    for (const type of [0, 1] as const) {
      const name = type ? "double" : "float";
      for (const [errors, role, way, [label, ...offset], anchor] of [
        [
          output.cosine_curve,
          "miss",
          "arccos",
          positions[type] ?? NOWHERE,
          type ? "start" : "middle",
        ],
        [
          output.both_curve,
          "hit",
          "both",
          positions[2 + type] ?? NOWHERE,
          type ? "middle" : "start",
        ],
      ] as const) {
        const curve: Vec2[] = [];
        for (let k = 0; k < STEPS; k++) {
          const error = errors[type * STEPS + k] ?? -1;
          if (error < 0) continue;
          curve.push(at(k, error));
          if (k === output.k) scene.dot(at(k, error), role, 5, !type);
          if (k === label)
            scene.label(at(k, error), `${way}, ${name}`, {
              role,
              offset,
              anchor,
              size: "small",
            });
        }
        if (curve.length > 1) scene.path(curve, { role, width: 2, dashed: !type });
      }
    }
  },
  values(_input, output) {
    const row = (name: string, type: number, role: Role) => {
      const cosine = role === "miss";
      const error = (cosine ? output.cosine_error : output.both_error)[type];
      return {
        name,
        meaning: `${type ? "double" : "float"}: ${off(error)}`,
        value: angle((cosine ? output.by_cosine : output.by_both)[type]),
        unit: "rad",
        role,
      };
    };
    return [
      { name: "θ", meaning: "as stored in double", value: angle(output.angle[1]), unit: "rad" },
      row("arccos", 1, "miss"),
      row("both", 1, "hit"),
      { name: "θ", meaning: "as stored in float", value: angle(output.angle[0]), unit: "rad" },
      row("arccos", 0, "miss"),
      row("both", 0, "hit"),
    ];
  },
  describe: (_input, output) =>
    `The angle is ${angle(output.angle[1])}. From the cosine, double precision is ${off(output.cosine_error[1])}; from both products, ${off(output.both_error[1])}.`,
});
