// Two meshes, one of which is dragged: the curve in which their surfaces meet, and what is counted.

import { defineFigure, type Role, type Scene, type Vec3, vectorAt } from "@contact/figure";

interface Input {
  shift: Vec3;
  meshes: number;
}

interface Output {
  triangles: readonly number[];
  vertex: readonly number[];
  triangle: readonly number[];
  pairs: number;
  boxes: number;
  tested: number;
  meet: number;
  in_one_plane: number;
  segments: number;
  segment: readonly number[];
  points: number;
  contacts: number;
  contact: readonly number[];
  of_kind: readonly number[];
}

/** Room for each mesh in the C++'s lists. */
const VERTICES = 160;
const TRIANGLES = 300;
const KINDS = ["p2p", "p2e", "p2f", "e2e", "e2f", "f2f"];
/** Dragged points move in tenths of this. */
const GRIP_STEP = 1.25;

const count = (n: number): string => n.toLocaleString("en-US");

/** Faces, and each edge once: of its two triangles in the one that has it from the lower number. */
function mesh(scene: Scene, output: Output, which: number, role: Role, line: Role): void {
  for (let i = 0; i < (output.triangles[which] ?? 0); i++) {
    const named = [0, 1, 2].map((k) => output.triangle[3 * (TRIANGLES * which + i) + k] ?? 0);
    const at = named.map((vertex) => vectorAt(output.vertex, VERTICES * which + vertex));
    scene.face(at, { role, fill: 0.16, outline: false });
    for (const [k, from] of at.entries())
      if ((named[k] ?? 0) < (named[(k + 1) % 3] ?? 0))
        scene.line(from, at[(k + 1) % 3] ?? from, { role: line, width: 0.5, through: true });
  }
}

function kinds(output: Output): string {
  const some = KINDS.map((name, i) => [name, output.of_kind[i] ?? 0] as const);
  const found = some.filter(([, n]) => n > 0).map(([name, n]) => `${name} ${count(n)}`);
  return found.join(", ") || "none";
}

export default defineFigure<Input, Output>({
  title: "Two meshes that meet",
  view: {
    kind: "3d",
    target: [0.3, 0, 0.1],
    azimuth: -62,
    elevation: 24,
    span: 4.4,
    ground: { half: 2.5, z: -1.5, step: 0.5 },
  },
  aspect: 1.1,
  initial: { shift: [0.5, -0.25, 0.5], meshes: 0 },
  handles: [
    {
      kind: "point",
      field: "shift",
      label: "position of the moving mesh",
      role: "b",
      move: "vertical",
      step: GRIP_STEP,
      limit: [-2.5, 2.5],
    },
  ],
  controls: [
    {
      kind: "states",
      label: "Meshes",
      options: [
        { label: "two tori", fields: { meshes: 0, shift: [0.5, -0.25, 0.5] } },
        { label: "crossing boxes", fields: { meshes: 1, shift: [0.75, -0.25, 0.5] } },
        { label: "a box on a box", fields: { meshes: 2, shift: [0.5, 0, 0.875] } },
        { label: "star and ball", fields: { meshes: 3, shift: [1, -0.25, 0.25] } },
      ],
    },
    { kind: "numbers", field: "shift", label: "shift", role: "b", step: 0.125 },
  ],
  draw(scene, { shift }, output) {
    scene.drop(shift, -1.5, "b");
    if (output.problem) return;
    mesh(scene, output, 0, "surface", "muted");
    mesh(scene, output, 1, "b", "b");
    for (let i = 0; 6 * i < output.segment.length && i < output.segments; i++)
      scene.line(vectorAt(output.segment, 2 * i), vectorAt(output.segment, 2 * i + 1), {
        role: "hit",
        width: output.in_one_plane ? 1.2 : 2.5,
        through: true,
      });
    const radius = output.contacts > 40 ? 2.5 : 4.5;
    for (let i = 0; 3 * i < output.contact.length && i < output.contacts; i++)
      scene.dot(vectorAt(output.contact, i), "hit", radius);
  },
  values: (_input, output) => [
    { name: "pairs", meaning: "each with each", value: count(output.pairs), role: "miss" },
    { name: "boxes", meaning: "compared, by two trees", value: count(output.boxes) },
    { name: "triangles", meaning: "pairs tested, by two trees", value: count(output.tested) },
    { name: "meet", meaning: "pairs of triangles", value: count(output.meet), role: "hit" },
    { name: "points", meaning: "of all these pairs", value: count(output.points), role: "miss" },
    { name: "contacts", meaning: "each once", value: count(output.contacts), role: "hit" },
    { name: "kinds", meaning: "of these contacts", value: kinds(output) },
  ],
  describe(_input, output) {
    const tests = `Of ${count(output.pairs)} pairs of triangles, two trees leave ${count(output.tested)} to test`;
    if (!output.meet) return `${tests}, and none meets.`;
    const flat = output.in_one_plane ? `, ${count(output.in_one_plane)} of them in one plane` : "";
    return `${tests}; ${count(output.meet)} meet${flat}. These have ${count(output.points)} points, which are ${count(output.contacts)} contacts.`;
  },
});
