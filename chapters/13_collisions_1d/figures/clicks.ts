// The velocities of two blocks as one point: a collision with the wall reflects it in the horizontal
// axis, a collision of the blocks in a line whose slope depends on the masses.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  ratio: number;
  step: number;
}

interface Output {
  clicks: number;
  x: readonly number[];
  y: readonly number[];
  large: number;
  small: number;
  done: number;
  slope_x: number;
  slope_y: number;
}

const R = 3;
const SCALE = -4.4;
const position = (ratio: number): number => -4 + 0.08 * ratio;

export default defineFigure<Input, Output>({
  title: "Reflections on a circle",
  view: { kind: "2d", x: [-5, 5], y: [-5.2, 3.8] },
  aspect: 1.1,
  initial: { ratio: 16, step: 32 },
  handles: [
    {
      kind: "slide",
      field: "ratio",
      label: "M/m, mass ratio of the blocks",
      role: "ray",
      at: (input): Vec2 => [position(input.ratio), SCALE],
      along: (): Vec2 => [0.08, 0],
      step: 1,
      limit: [1, 100],
    },
  ],
  controls: [
    { kind: "numbers", field: "ratio", label: "M/m", role: "ray", step: 0.5 },
    { kind: "slider", field: "step", label: "collisions", min: 0, max: 32, step: 1, play: 6 },
  ],
  draw(scene, _input, output) {
    scene.line([position(0), SCALE], [position(100), SCALE], { role: "muted", width: 2 });
    for (const ratio of [1, 25, 50, 75, 100]) {
      scene.line([position(ratio), SCALE - 0.1], [position(ratio), SCALE + 0.1], {
        role: "muted",
        width: 1,
      });
      scene.label([position(ratio), SCALE], pretty(ratio), {
        role: "muted",
        offset: [0, 20],
        anchor: "middle",
        size: "small",
      });
    }
    const rim = Array.from({ length: 97 }, (_, i): Vec2 => {
      const angle = (i * Math.PI) / 48;
      return [R * Math.cos(angle), R * Math.sin(angle)];
    });
    scene.path(rim, { role: "muted", width: 1 });
    scene.arrow([-3.6, 0], [3.7, 0], { role: "muted", width: 1 });
    scene.arrow([0, -3.4], [0, 3.5], { role: "muted", width: 1 });
    scene.label([3.7, 0], "√M V", { role: "muted", offset: [0, -8], anchor: "start" });
    scene.label([0, 3.5], "√m v", { role: "muted", offset: [10, 6] });
    if (output.problem) return;
    const end: Vec2 = [-R * output.slope_x, -R * output.slope_y];
    scene.face([[0, 0], [-R, 0], end], { role: "hit", fill: 0.25, outline: false });
    scene.line([-end[0], -end[1]], end, { role: "b", width: 1.5, dashed: true });
    scene.label([-end[0], -end[1]], "V = v", { role: "b", offset: [10, 0] });
    scene.label([-R, 0], "all separate", {
      role: "hit",
      offset: [-4, -10],
      anchor: "middle",
      size: "small",
    });
    const at = (i: number): Vec2 => [R * (output.x[i] ?? 0), R * (output.y[i] ?? 0)];
    for (let i = 0; i < output.done; ++i) {
      scene.line(at(i), at(i + 1), { role: i % 2 === 0 ? "ray" : "a", width: 2 });
    }
    for (let i = 0; i <= output.done; ++i) scene.dot(at(i), "ink", 3);
    scene.dot(at(output.done), output.done === output.clicks ? "hit" : "ray", 6);
  },
  values: (_input, output) => [
    { name: "n", meaning: "collisions in all", value: output.clicks },
    { name: "k", meaning: "collisions so far", value: output.done },
    { name: "V", meaning: "large block, relative to its initial velocity", value: output.large },
    { name: "v", meaning: "small block", value: output.small },
  ],
  describe(input, output) {
    return `With a mass ratio of ${pretty(input.ratio)} there are ${pretty(output.clicks)} collisions.`;
  },
});
