// A body falls towards a plate. Each outline is a test for contact at the end of a step.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  height: number;
  speed: number;
  angular_velocity: number;
  step: number;
  thick: number;
  gravity: number;
  shape: number;
}

interface Output {
  y: readonly number[];
  sine: readonly number[];
  cosine: readonly number[];
  count: number;
  seen: number;
  passes: number;
  closing: number;
  plain: number;
  moved: number;
  room: number;
  longest: number;
  proven: number;
}

const RADIUS = 0.1;
const LENGTH = 0.5;
const CORNERS = [
  [1, 1],
  [-1, 1],
  [-1, -1],
  [1, -1],
] as const;

export default defineFigure<Input, Output>({
  title: "Between two steps",
  view: { kind: "2d", x: [-1.9, 1.9], y: [-1.5, 2.3] },
  aspect: 1.2,
  initial: {
    height: 1.6,
    speed: 20,
    angular_velocity: 0,
    step: 0.025,
    thick: 0.1,
    gravity: 0,
    shape: 0,
  },
  handles: [
    {
      kind: "slide",
      field: "height",
      label: "initial height, m",
      role: "ball",
      at: (input): Vec2 => [0, input.height],
      along: (): Vec2 => [0, 1],
      step: 0.01,
      limit: [1, 2],
    },
  ],
  controls: [
    { kind: "slider", field: "speed", label: "v", min: 0, max: 60, step: 0.5, unit: "m/s" },
    {
      kind: "slider",
      field: "angular_velocity",
      label: "ω",
      min: -60,
      max: 60,
      step: 1,
      unit: "rad/s",
    },
    { kind: "slider", field: "step", label: "h", min: 0.0045, max: 0.1, step: 0.0005, unit: "s" },
    { kind: "slider", field: "thick", label: "plate", min: 0.01, max: 0.5, step: 0.01, unit: "m" },
    {
      kind: "choice",
      field: "gravity",
      label: "gravity",
      options: [
        { value: 0, label: "none" },
        { value: 9.81, label: "9.81 m/s²" },
      ],
    },
    {
      kind: "choice",
      field: "shape",
      label: "body",
      options: [
        { value: 0, label: "a ball" },
        { value: 1, label: "a rod" },
      ],
    },
  ],
  draw(scene, input, output) {
    const half = input.thick / 2;
    scene.face(
      [
        [-1.8, -half],
        [1.8, -half],
        [1.8, half],
        [-1.8, half],
      ],
      { role: "surface", fill: 0.5, outline: true },
    );
    if (output.problem) return;
    for (let k = output.count - 1; k >= 0; --k) {
      const y = output.y[k] ?? 0;
      if (y < -1.4) continue;
      const role = k === output.seen ? "hit" : output.passes && y < 0 ? "miss" : "ball";
      const style = {
        role,
        fill: k === 0 || k === output.seen ? 0.5 : 0.12,
        outline: true,
      } as const;
      if (input.shape === 0) {
        scene.ball([0, y], RADIUS, style);
        continue;
      }
      const s = output.sine[k] ?? 0;
      const c = output.cosine[k] ?? 1;
      scene.face(
        CORNERS.map(
          ([a, b]): Vec2 => [a * LENGTH * c - b * RADIUS * s, y + a * LENGTH * s + b * RADIUS * c],
        ),
        style,
      );
    }
    const words = output.passes
      ? "no test has detected it"
      : output.proven
        ? "proven: nothing passes"
        : "not proven";
    scene.label([-1.8, -1.2], words, {
      role: output.passes ? "miss" : output.proven ? "hit" : "muted",
    });
  },
  values: (_input, output) => [
    {
      name: "u",
      meaning: "surface points never approach faster, by energy",
      value: output.closing,
      unit: "m/s",
    },
    {
      name: "v + ω r + g t",
      meaning: "speed of this body if nothing hits it",
      value: output.plain,
      unit: "m/s",
    },
    {
      name: "u h",
      meaning: "approach in a step, at most",
      value: output.moved,
      unit: "m",
      role: "ball",
    },
    {
      name: "2 R",
      meaning: "twice the sum of the thicknesses",
      value: output.room,
      unit: "m",
      role: "surface",
    },
    { name: "h_max", meaning: "proven up to this step", value: output.longest, unit: "s" },
  ],
  describe(_input, output) {
    const sides = `${pretty(output.moved, 3)} m in a step, against ${pretty(output.room, 3)} m`;
    if (output.passes) return `The body comes out below, and no test has detected it: ${sides}.`;
    return output.proven
      ? `Nothing can pass undetected: ${sides}.`
      : `Not proven that nothing passes: ${sides}. This body is detected all the same.`;
  },
});
