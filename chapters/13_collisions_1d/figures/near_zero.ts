// A velocity near zero, enlarged: the exact value and that in single precision.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  zoom: number;
  position: number;
  e: number;
}

interface Output {
  mass: readonly number[];
  exact: readonly number[];
  rounded: readonly number[];
  bound: number;
  m_1: number;
  v_exact: number;
  v_rounded: number;
  relative: number;
  absolute: number;
  read_x: number;
  read_y: number;
}

const WIDE = 4.6;
const HIGH = 6;
const SCALE = -4.3;
const clip = (y: number): number => Math.max(-3.4, Math.min(3.4, y * HIGH));
const zoomAt = (zoom: number): number => -4.6 + (zoom - 2) * (9.2 / 21);

export default defineFigure<Input, Output>({
  title: "A velocity near zero",
  view: { kind: "2d", x: [-5.6, 5.6], y: [-5.2, 4.1] },
  aspect: 1.25,
  initial: { zoom: 19, position: 0.4, e: 0.3 },
  handles: [
    {
      kind: "slide",
      field: "zoom",
      label: "magnification, as a power of two",
      role: "ray",
      at: (input): Vec2 => [zoomAt(input.zoom), SCALE],
      along: (): Vec2 => [9.2 / 21, 0],
      step: 1,
      limit: [2, 23],
    },
    {
      kind: "slide",
      field: "position",
      label: "the mass m₁ of the reading",
      role: "hit",
      at: (input): Vec2 => [input.position * WIDE, 0],
      along: (): Vec2 => [WIDE, 0],
      step: 0.05,
      limit: [-1, 1],
    },
  ],
  controls: [{ kind: "slider", field: "e", label: "e", min: 0.1, max: 0.9, step: 0.1 }],
  draw(scene, _input, output) {
    scene.line([zoomAt(2), SCALE], [zoomAt(23), SCALE], { role: "muted", width: 2 });
    for (const zoom of [2, 9, 16, 23]) {
      scene.line([zoomAt(zoom), SCALE - 0.1], [zoomAt(zoom), SCALE + 0.1], {
        role: "muted",
        width: 1,
      });
      scene.label([zoomAt(zoom), SCALE], `2^${zoom}`, {
        role: "muted",
        offset: [0, 20],
        anchor: "middle",
        size: "small",
      });
    }
    scene.arrow([-5, 0], [5.2, 0], { role: "muted", width: 1 });
    scene.arrow([0, -3.5], [0, 3.8], { role: "muted", width: 1 });
    scene.label([5.2, 0], "m_1", { role: "muted", offset: [0, 18], anchor: "end" });
    scene.label([0, 3.8], "v_1′", { role: "muted", offset: [10, 4] });
    if (output.problem) return;

    const last = output.mass.length - 1;
    const edge = (i: number, side: number): Vec2 => [
      (output.mass[i] ?? 0) * WIDE,
      clip((output.exact[i] ?? 0) + side * output.bound),
    ];
    scene.face([edge(0, -1), edge(last, -1), edge(last, 1), edge(0, 1)], {
      role: "b",
      fill: 0.12,
      outline: false,
    });
    scene.path(
      output.mass.map((m, i): Vec2 => [m * WIDE, clip(output.exact[i] ?? 0)]),
      { role: "b", width: 1.5 },
    );
    for (const [i, m] of output.mass.entries()) {
      scene.dot([m * WIDE, clip(output.rounded[i] ?? 0)], "ray", 3);
    }
    scene.dot([output.read_x * WIDE, clip(output.read_y)], "hit", 6, true);
  },
  values: (_input, output) => [
    { name: "v_1′", meaning: "without rounding", value: output.v_exact, unit: "m/s", role: "b" },
    { name: "v_1′", meaning: "in float", value: output.v_rounded, unit: "m/s", role: "ray" },
    { name: "relative", meaning: "error, of v₁′ itself", value: output.relative, role: "miss" },
    {
      name: "absolute",
      meaning: "error, of u (|v₁| + |v₂|); 8 at most",
      value: output.absolute,
      role: "hit",
    },
  ],
  describe(_input, output) {
    return `The velocity is ${pretty(output.v_exact, 3)} m/s; the error of single precision is ${pretty(output.relative, 2)} of that, and ${pretty(output.absolute, 2)} u (|v₁| + |v₂|).`;
  },
});
