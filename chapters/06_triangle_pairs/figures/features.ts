// A tetrahedron moves down until it touches a body at rest: what touches is drawn green, and its
// kinds are listed.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec3,
  vectorAt,
} from "@contact/figure";

interface Input {
  position: Vec3;
  pose: number;
  tilt: number;
  turn: number;
  resting: number;
  time: number;
}

interface Output {
  vertices: readonly number[];
  triangles: readonly number[];
  edges: readonly number[];
  start: readonly number[];
  vertex: readonly number[];
  triangle: readonly number[];
  edge: readonly number[];
  apart: number;
  touches: number;
  t: number;
  arrived: number;
  kinds: readonly number[];
  point_face: number;
  edge_edge: number;
  vertex_touches: readonly number[];
  edge_touches: readonly number[];
  face_touches: readonly number[];
  points: number;
  point: readonly number[];
}

/** Room for each body in the C++'s lists. */
const VERTICES = 8;
const TRIANGLES = 12;
const EDGES = 12;
const GROUND = -0.75;
/** Dragged points move in tenths of this. */
const GRIP_STEP = 1.25;

const KINDS = [
  ["p2p", "point on point"],
  ["p2e", "point on edge"],
  ["p2f", "point on face"],
  ["e2e", "edge on edge"],
  ["e2f", "edge on face"],
  ["f2f", "face on face"],
] as const;

/** One of the bodies, as it is drawn; what touches is green. */
function body(scene: Scene, output: Output, which: number, role: Role): void {
  const at = (i = 0): Vec3 => vectorAt(output.vertex, VERTICES * which + i);
  for (let i = 0; i < (output.triangles[which] ?? 0); i++) {
    const n = TRIANGLES * which + i;
    const touches = output.arrived && output.face_touches[n];
    scene.face(
      [0, 1, 2].map((k) => at(output.triangle[3 * n + k])),
      { role: touches ? "hit" : role, fill: touches ? 0.45 : 0.13, outline: false, hides: true },
    );
  }
  for (let i = 0; i < (output.edges[which] ?? 0); i++) {
    const n = EDGES * which + i;
    const touches = output.arrived === 1 && output.edge_touches[n] === 1;
    scene.line(at(output.edge[2 * n]), at(output.edge[2 * n + 1]), {
      role: touches ? "hit" : role,
      width: touches ? 5 : 1.8,
      through: touches,
    });
  }
}

/** The tetrahedron where it starts. */
function ghost(scene: Scene, output: Output): void {
  for (let i = 0; i < 4; i++)
    for (let j = 0; j < i; j++)
      scene.line(vectorAt(output.start, i), vectorAt(output.start, j), {
        role: "muted",
        width: 1,
        dashed: true,
        through: true,
      });
}

const state = (
  label: string,
  resting: number,
  pose: number,
  position: Vec3,
  turn = 0,
  tilt = 0,
) => ({ label, fields: { resting, pose, position, turn, tilt, time: 1 } });

export default defineFigure<Input, Output>({
  title: "Which features touch first?",
  view: {
    kind: "3d",
    target: [0, 0, 0.95],
    azimuth: -58,
    elevation: 20,
    span: 4.6,
    ground: { half: 2, z: GROUND, step: 0.5 },
  },
  aspect: 0.95,
  initial: { position: [0.25, -0.125, 2], pose: 0, tilt: 0, turn: 20, resting: 0, time: 1 },
  handles: [
    {
      kind: "point",
      field: "position",
      label: "position of the upper body",
      role: "b",
      move: "level",
      step: GRIP_STEP,
      limit: [-2.5, 2.5],
    },
  ],
  controls: [
    {
      kind: "states",
      label: "Contact",
      options: [
        state("vertex on face", 0, 0, [0.25, -0.125, 2], 20),
        state("edge on edge", 1, 1, [0.125, 0.25, 2], 15),
        state("edge on face", 0, 1, [0.25, 0, 2], 30),
        state("face on face", 0, 2, [0.75, -0.25, 2], 10),
        state("vertex on vertex", 2, 0, [0, 0, 2], 20),
        state("vertex on edge", 1, 0, [0, 0.25, 2], 20),
      ],
    },
    {
      kind: "choice",
      field: "resting",
      label: "Below",
      options: [
        { value: 0, label: "a box" },
        { value: 1, label: "a roof" },
        { value: 2, label: "a tetrahedron" },
      ],
    },
    {
      kind: "choice",
      field: "pose",
      label: "Downwards",
      options: [
        { value: 0, label: "a vertex" },
        { value: 1, label: "an edge" },
        { value: 2, label: "a face" },
      ],
    },
    { kind: "slider", field: "turn", label: "turn", min: -180, max: 180, step: 5, unit: "°" },
    { kind: "slider", field: "tilt", label: "tilt", min: -90, max: 90, step: 5, unit: "°" },
    { kind: "slider", field: "time", label: "t", min: 0, max: 1, step: 0.01, play: 3 },
    { kind: "numbers", field: "position", label: "position", role: "b", step: 0.125 },
  ],
  draw(scene, { position }, output) {
    if (output.problem) {
      scene.dot(position, "b");
      return;
    }
    body(scene, output, 1, "surface");
    body(scene, output, 0, "b");
    ghost(scene, output);
    const [, , fallen] = vectorAt(output.vertex, 0).map((x, k) => x - (output.start[k] ?? 0));
    scene.line(position, [position[0], position[1], position[2] + 0.6 * (fallen ?? 0)], {
      role: "b",
      width: 1.5,
      arrow: true,
      through: true,
    });
    if (!output.arrived) return;
    for (let i = 0; i < output.points; i++) scene.dot(vectorAt(output.point, i), "hit", 5.5);
  },
  values: (_input, output) => [
    ...KINDS.map(([name, meaning], i): Value => {
      const count = output.kinds[i] ?? 0;
      return { name, meaning, value: count ? `✓ ${count}` : "–", role: count ? "hit" : "muted" };
    }),
    { name: "pairs", meaning: "point and face, with borders", value: output.point_face },
    { name: "pairs", meaning: "edge and edge, with ends", value: output.edge_edge },
    { name: "t", meaning: "of the first contact", value: output.touches ? output.t : "none" },
  ],
  describe(_input, output) {
    if (!output.touches) return "The body passes the other one.";
    const some = KINDS.filter((_, i) => output.kinds[i]).map(([, meaning]) => meaning);
    if (!output.apart) return `The bodies meet already at the start: ${some.join(", ")}.`;
    const pairs = `${output.point_face} of a point and a face, ${output.edge_edge} of two edges`;
    return `At t = ${pretty(output.t, 3)} they touch: ${some.join(", ")}. Pairs that touch, borders included: ${pairs}.`;
  },
});
