// Rays aimed at the edge that two triangles share, in float. A ray that hits neither triangle goes
// through a surface without a hole.

import { along, defineFigure, type Role, type Vec3, vectorAt } from "@contact/figure";

interface Input {
  origin: Vec3;
  a: Vec3;
  b: Vec3;
  c: Vec3;
  d: Vec3;
}

interface Output {
  opposite: number;
  targets: readonly number[];
  by_edges: readonly number[];
  by_dropping: readonly number[];
  by_moller_trumbore: readonly number[];
  by_watertight: readonly number[];
  by_exact: readonly number[];
  leaks: readonly number[];
}

const METHODS = [
  ["edge tests", "by_edges"],
  ["dropping", "by_dropping"],
  ["Möller–Trumbore", "by_moller_trumbore"],
  ["watertight", "by_watertight"],
  ["exact", "by_exact"],
] as const;
const TAKEN: (Role | undefined)[] = [undefined, "b", "c", "surface"];

export default defineFigure<Input, Output>({
  title: "Rays at the edge of two triangles",
  view: {
    kind: "3d",
    target: [0.1, -0.9, 0.1],
    azimuth: -28,
    elevation: 40,
    span: 6.2,
    ground: { half: 3, z: -1.3, step: 0.5 },
  },
  aspect: 0.98,
  initial: {
    origin: [0.52, -3.17, 1.95],
    a: [-1.92, 0.04, 0.51],
    b: [1.86, 0.06, 0.66],
    c: [0.29, 0.98, 1.57],
    d: [0.32, -0.28, -0.81],
  },
  handles: [
    { kind: "point", field: "origin", label: "o, start of the rays", role: "ray", step: 0.01 },
    { kind: "point", field: "a", label: "a, end of the shared edge", role: "surface", step: 0.01 },
    { kind: "point", field: "b", label: "b, end of the shared edge", role: "surface", step: 0.01 },
    { kind: "point", field: "c", label: "c, vertex of the first triangle", role: "b", step: 0.01 },
    { kind: "point", field: "d", label: "d, vertex of the second triangle", role: "c", step: 0.01 },
  ],
  controls: [
    { kind: "numbers", field: "origin", label: "o", role: "ray", step: 0.01 },
    { kind: "numbers", field: "a", label: "a", role: "surface", step: 0.01 },
    { kind: "numbers", field: "b", label: "b", role: "surface", step: 0.01 },
    { kind: "numbers", field: "c", label: "c", role: "b", step: 0.01 },
    { kind: "numbers", field: "d", label: "d", role: "c", step: 0.01 },
  ],
  draw(scene, input, output) {
    const { origin, a, b, c, d } = input;
    scene.face([a, b, c], { role: "b", fill: 0.2, hides: true });
    scene.face([b, a, d], { role: "c", fill: 0.2, hides: true });
    scene.label(origin, "o", { role: "ray", offset: [0, -18], anchor: "middle" });
    scene.label(a, "a", { role: "surface", offset: [-14, -6], anchor: "end" });
    scene.label(b, "b", { role: "surface", offset: [14, -6] });
    scene.label(c, "c", { role: "b", offset: [0, -18], anchor: "middle" });
    scene.label(d, "d", { role: "c", offset: [14, 14] });
    if (output.problem) return;
    for (const [i, taken] of output.by_moller_trumbore.entries()) {
      const target = vectorAt(output.targets, i);
      const lost = taken === 0 && output.by_exact[i] !== 0;
      scene.line(origin, target, { role: lost ? "miss" : "ray", width: lost ? 1.2 : 0.5 });
      if (lost) scene.line(target, along(origin, target, 1.35), { role: "miss", width: 1.2 });
    }
    scene.line(a, b, { role: "surface", width: 2.5, through: true });
    scene.strips(
      METHODS.map(([name, field]) => ({
        name,
        cells: output[field].map((taken, i) =>
          output.by_exact[i] === 0 && taken === 0 ? "ghost" : TAKEN[taken],
        ),
      })),
    );
  },
  values: (_input, output) =>
    METHODS.map(([name], i) => ({
      name,
      meaning: "rays lost, of 64",
      value: output.leaks[i] ?? 0,
      role: ((output.leaks[i] ?? 0) > 0 ? "miss" : "hit") as Role,
    })),
  describe(_input, output) {
    if (!output.opposite)
      return "Seen from o both triangles are on one side of the edge, so a ray may rightly pass beside it.";
    const [edges = 0, dropping = 0, plain = 0, watertight = 0] = output.leaks;
    return `Of 64 rays at the shared edge in float, edge tests lose ${edges}, dropping loses ${dropping}, Möller–Trumbore ${plain} (drawn through) and the watertight test ${watertight}.`;
  },
});
