// Positions of two balls near a wall over time. Lines: by events; dots: by a program in steps.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  inner: number;
  outer: number;
  ratio: number;
  e: number;
  step: number;
}

interface Output {
  time: readonly number[];
  inner_at: readonly number[];
  outer_at: readonly number[];
  sample_time: readonly number[];
  sample_inner: readonly number[];
  sample_outer: readonly number[];
  hits: number;
  stepped_hits: number;
  last_time: number;
  endless: number;
  border: number;
}

const LAST = 6;
const TOP = 2.6;
const low = (x: number): number => Math.max(-0.35, Math.min(TOP, x));

export default defineFigure<Input, Output>({
  title: "Squeezed against the wall",
  view: { kind: "2d", x: [-0.55, 6.4], y: [-0.75, 2.85] },
  aspect: 1.6,
  initial: { inner: 0.8, outer: 1.8, ratio: 1, e: 0.5, step: 0.1 },
  handles: [
    {
      kind: "slide",
      field: "inner",
      label: "position of the inner ball, m",
      role: "a",
      at: (input): Vec2 => [0, input.inner],
      along: (): Vec2 => [0, 1],
      step: 0.05,
      limit: [0.2, 1.2],
    },
    {
      kind: "slide",
      field: "outer",
      label: "position of the outer ball, m",
      role: "b",
      at: (input): Vec2 => [0, input.outer],
      along: (): Vec2 => [0, 1],
      step: 0.05,
      limit: [1.3, 2.4],
    },
  ],
  controls: [
    { kind: "slider", field: "e", label: "e", min: 0, max: 1, step: 0.01 },
    { kind: "slider", field: "ratio", label: "M/m", min: 0.5, max: 30, step: 0.5 },
    { kind: "slider", field: "step", label: "Δt", min: 0.05, max: 0.5, step: 0.05, unit: "s" },
  ],
  draw(scene, _input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.line([0, 0], [LAST + 0.2, 0], { role: "surface", width: 3 });
    scene.arrow([0, 0], [0, TOP + 0.15], axis);
    scene.label([0, TOP + 0.15], "distance from the wall, m", { role: "muted", offset: [8, 6] });
    scene.label([LAST + 0.2, 0], "t, s", { role: "muted", offset: [0, 36], anchor: "end" });
    for (const t of [1, 2, 3, 4, 5, 6]) {
      scene.label([t, 0], pretty(t), {
        role: "muted",
        offset: [0, 19],
        anchor: "middle",
        size: "small",
      });
    }
    if (output.problem) return;
    const line = (positions: readonly number[]): Vec2[] =>
      output.time.map((t, i): Vec2 => [t, low(positions[i] ?? 0)]);
    scene.path(line(output.inner_at), { role: "a", width: 2.2 });
    scene.path(line(output.outer_at), { role: "b", width: 2.2 });
    for (const [i, t] of output.sample_time.entries()) {
      scene.dot([t, low(output.sample_inner[i] ?? 0)], "a", 1.8);
      scene.dot([t, low(output.sample_outer[i] ?? 0)], "b", 1.8);
    }
    if (output.last_time < LAST) {
      scene.line([output.last_time, -0.2], [output.last_time, 1.2], {
        role: "hit",
        width: 1.5,
        dashed: true,
      });
      scene.label([output.last_time, 1.2], `${pretty(output.hits)} collisions and more`, {
        role: "hit",
        offset: [0, -8],
        anchor: "middle",
        size: "small",
      });
    }
  },
  values: (_input, output) => [
    { name: "n", meaning: "collisions computed", value: output.hits, role: "hit" },
    { name: "n_steps", meaning: "collisions of the program in steps", value: output.stepped_hits },
    {
      name: "t_last",
      meaning: "time of the last one computed",
      value: output.last_time,
      unit: "s",
    },
    { name: "M/m", meaning: "infinitely many from this ratio on", value: output.border },
  ],
  describe(_input, output) {
    if (output.endless) {
      return `There are infinitely many collisions: ${pretty(output.hits, 3)} were computed, until ${pretty(output.last_time, 4)} s.`;
    }
    return `There are finitely many collisions: ${pretty(output.hits, 3)} in the first ${LAST} s; the program in steps counts ${pretty(output.stepped_hits, 3)}.`;
  },
});
