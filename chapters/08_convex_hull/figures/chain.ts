// The monotone chain of eight points. Each step is one orientation test: green keeps the middle
// point, red removes it. The test may be rounded, on points that are nearly collinear.

import { defineFigure, type Vec2 } from "@contact/figure";

interface Input {
  p0: Vec2;
  p1: Vec2;
  p2: Vec2;
  p3: Vec2;
  p4: Vec2;
  p5: Vec2;
  p6: Vec2;
  p7: Vec2;
  step: number;
  method: number;
  flat: number;
}

interface Output {
  steps: number;
  corners: number;
  hull: readonly number[];
  length: number;
  chain: readonly number[];
  asked: readonly number[];
  orientation: number;
  true_vertices: number;
  true_hull: readonly number[];
  found: number;
  lost: readonly number[];
  wrong_turns: number;
  position: readonly number[];
}

const NAMES = ["p0", "p1", "p2", "p3", "p4", "p5", "p6", "p7"] as const;
const all = (input: Input): Vec2[] => NAMES.map((name) => input[name]);

/** Whether the right hull is drawn as well, dashed. */
const rightShown = (output: Output): boolean =>
  output.found < output.true_vertices || output.wrong_turns > 0;

export default defineFigure<Input, Output>({
  title: "A chain of left turns",
  view: { kind: "2d", x: [-5, 5], y: [-3.6, 3.6], grid: 1 },
  aspect: 1.3,
  initial: {
    p0: [-4, -1],
    p1: [-3, 2],
    p2: [-2, -2.5],
    p3: [-1, 0.5],
    p4: [1, -1],
    p5: [2, 3],
    p6: [3, -2],
    p7: [4, 1],
    step: 4,
    method: 0,
    flat: 0,
  },
  handles: NAMES.map((field, i) => ({
    kind: "point" as const,
    field,
    label: `point ${i}`,
    role: "ray" as const,
    step: 0.5,
    limit: [-4.5, 4.5] as const,
  })),
  controls: [
    {
      kind: "slider",
      field: "step",
      label: "tests",
      min: 0,
      max: 24,
      step: 1,
      play: 10,
    },
    {
      kind: "choice",
      field: "method",
      label: "Decided by",
      options: [
        { value: 0, label: "exact orientation" },
        { value: 1, label: "orientation in float" },
        { value: 2, label: "orientation in double" },
        { value: 3, label: "an epsilon of 1e-6" },
        { value: 4, label: "sorting by angle" },
      ],
    },
    { kind: "slider", field: "flat", label: "k, heights × 10⁻ᵏ", min: 0, max: 16, step: 1 },
    ...NAMES.map((field, i) => ({
      kind: "numbers" as const,
      field,
      label: `p_${i}`,
      role: "ray" as const,
      step: 0.5,
    })),
  ],
  draw(scene, input, output) {
    const points: Vec2[] = output.problem
      ? all(input)
      : NAMES.map((_, i) => [output.position[2 * i] ?? 0, output.position[2 * i + 1] ?? 0]);
    for (const [i, p] of points.entries())
      scene.label(p, String(i), { role: "ink", offset: [9, -9], size: "small" });
    if (output.problem) return;
    const at = (i: number | undefined): Vec2 => points[i ?? 0] ?? [0, 0];
    const hull = output.hull.slice(0, output.corners).map(at);
    if (hull.length > 2) scene.face(hull, { role: "surface", fill: 0.08, outline: false });
    if (rightShown(output)) {
      const right = output.true_hull.slice(0, output.true_vertices).map(at);
      scene.path([...right, ...right.slice(0, 1)], { role: "normal", width: 1.5, dashed: true });
      for (const [i, p] of points.entries()) {
        if (!output.lost[i]) continue;
        scene.dot(p, "miss", 8, true);
        scene.label(p, "lost", { role: "miss", offset: [10, 18], size: "small" });
      }
    }
    const chain = output.chain.slice(0, output.length).map(at);
    if (chain.length > 1) scene.path(chain, { role: "surface", width: 3 });
    const [i = -1, j = -1, k = -1] = output.asked;
    if (i >= 0 && input.step < output.steps) {
      const role = output.orientation > 0 ? "hit" : "miss";
      scene.path([at(i), at(j), at(k)], { role, width: 2, dashed: true, arrow: true });
      scene.dot(at(j), role, 6, output.orientation <= 0);
      scene.label(at(j), output.orientation > 0 ? "left: stays" : "removed", {
        role,
        offset: [10, 18],
      });
    }
  },
  values: (input, output) => [
    {
      name: "found",
      meaning: `of the vertices of the hull${rightShown(output) ? " (dashed)" : ""}, after all tests`,
      value: `${output.found} of ${output.true_vertices}${output.corners > output.found ? `, ${output.corners - output.found} more` : ""}`,
      role:
        output.found < output.true_vertices || output.corners > output.found ? "miss" : "surface",
    },
    {
      name: "wrong tests",
      meaning: "of all tests",
      value: output.wrong_turns,
      role: output.wrong_turns ? "miss" : "ink",
    },
    {
      name: "tests",
      meaning: "so far, of all",
      value: `${Math.min(input.step, output.steps)} of ${output.steps}`,
    },
    {
      name: "orientation",
      meaning: "of the last three",
      value:
        output.asked[0] === -1
          ? "–"
          : output.orientation > 0
            ? "left"
            : output.orientation < 0
              ? "right"
              : "none",
      role: output.orientation > 0 ? "hit" : "miss",
    },
  ],
  describe: (input, output) =>
    `${Math.min(input.step, output.steps)} of ${output.steps} orientation tests have been made. After all tests, the chain has ${output.found} of the ${output.true_vertices} vertices of the hull.`,
});
