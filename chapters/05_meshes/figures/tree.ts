// A ray through a torus of 2,304 triangles and its tree of boxes: which boxes the ray is compared
// with, level by level, and which triangles.

import {
  along,
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Vec3,
  vectorAt,
} from "@contact/figure";

interface Input {
  origin: Vec3;
  through: Vec3;
  query: number;
  level: number;
}

interface Output {
  surface: readonly number[];
  levels: number;
  boxes_here: number;
  box_low: readonly number[];
  box_high: readonly number[];
  box_state: readonly number[];
  boxes: number;
  boxes_met: number;
  tested: number;
  triangle: readonly number[];
  triangle_hit: readonly number[];
  boxes_in_all: number;
  triangles_in_all: number;
  loop: number;
  wide_boxes: number;
  wide_triangles: number;
  hits: number;
  at: readonly number[];
  t: readonly number[];
  same: number;
}

const GROUND = -1.1;
/** The surface is drawn coarser than it is: these quadrilaterals around the ring and the tube. */
const RING = 24;
const TUBE = 8;
const QUERIES = ["first", "any", "all"];
interface Style {
  readonly role: Role;
  readonly width: number;
  readonly dashed: boolean;
}
const OPENED: Style = { role: "a", width: 2, dashed: false };
/** How a box is drawn that the ray misses, that is opened, and that is behind the first hit. */
const STATES: readonly Style[] = [
  { role: "muted", width: 1, dashed: true },
  OPENED,
  { role: "b", width: 2.5, dashed: true },
];

const count = (n: number): string => n.toLocaleString("en-US");

function box(scene: Scene, low: Vec3, high: Vec3, style: Style): void {
  const corner = (i: number): Vec3 => [
    i & 1 ? high[0] : low[0],
    i & 2 ? high[1] : low[1],
    i & 4 ? high[2] : low[2],
  ];
  for (let i = 0; i < 8; i++)
    for (const bit of [1, 2, 4])
      if (!(i & bit)) scene.line(corner(i), corner(i | bit), { ...style, through: true });
}

export default defineFigure<Input, Output>({
  title: "A ray and a tree of boxes",
  view: {
    kind: "3d",
    target: [-0.35, -0.35, 0],
    azimuth: -64,
    elevation: 28,
    span: 6,
    ground: { half: 3, z: GROUND, step: 0.5 },
  },
  aspect: 1.15,
  initial: { origin: [-2, -2, 0.75], through: [-0.2, -0.25, 0.1], query: 0, level: 4 },
  handles: [
    {
      kind: "point",
      field: "through",
      label: "q, a point on the ray",
      role: "ray",
      limit: [-4, 4],
    },
    { kind: "point", field: "origin", label: "o, start of the ray", role: "ray", limit: [-4, 4] },
  ],
  controls: [
    {
      kind: "choice",
      field: "query",
      label: "Hits",
      options: [
        { value: 0, label: "the first" },
        { value: 1, label: "any" },
        { value: 2, label: "all" },
      ],
    },
    { kind: "slider", field: "level", label: "level", min: 0, max: 16, step: 1, play: 8 },
    { kind: "numbers", field: "origin", label: "o", role: "ray" },
    { kind: "numbers", field: "through", label: "q", role: "ray" },
  ],
  draw(scene, input, output) {
    const { origin, through } = input;
    const far = along(
      origin,
      through,
      40 / Math.hypot(...through.map((x, k) => x - (origin[k] ?? 0))),
    );
    scene.label(origin, "o", { role: "ray", offset: [0, -18], anchor: "middle" });
    scene.label(through, "q", { role: "ray", offset: [0, 27], anchor: "middle" });
    scene.drop(origin, GROUND);
    if (output.problem) return;
    const at = (ring: number, tube: number): Vec3 =>
      vectorAt(output.surface, (ring % RING) * TUBE + (tube % TUBE));
    for (let i = 0; i < RING; i++)
      for (let j = 0; j < TUBE; j++)
        scene.face([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], {
          role: "ghost",
          fill: 0.25,
          outline: true,
          hides: true,
        });
    for (let i = 0; i < output.boxes_here; i++) {
      const style = STATES[output.box_state[i] ?? 1] ?? OPENED;
      box(scene, vectorAt(output.box_low, i), vectorAt(output.box_high, i), style);
    }
    for (let i = 0; 9 * i < output.triangle.length && i < output.tested; i++) {
      const hit = output.triangle_hit[i] === 1;
      scene.face(
        [0, 1, 2].map((k) => vectorAt(output.triangle, 3 * i + k)),
        {
          role: hit ? "hit" : "miss",
          fill: hit ? 0.9 : 0.5,
        },
      );
    }
    const first: Vec3 | undefined = output.hits ? vectorAt(output.at, 0) : undefined;
    const through_all = input.query === 2 || !first;
    scene.line(origin, through_all ? far : first, { role: "ray", width: 3, arrow: !first });
    if (first && !through_all) scene.line(first, far, { role: "ray", width: 1, dashed: true });
    for (let i = 0; i < output.hits; i++) {
      const point = vectorAt(output.at, i);
      scene.dot(point, "hit", 5);
      scene.label(point, `t = ${pretty(output.t[i] ?? 0, 3)}`, {
        role: "hit",
        offset: [10, -8 + 17 * (i % 2)],
      });
    }
  },
  values: (input, output) => [
    {
      name: "boxes",
      meaning: `compared, of ${count(output.boxes_in_all)}`,
      value: count(output.boxes),
      role: "a",
    },
    {
      name: "triangles",
      meaning: `tested, of ${count(output.triangles_in_all)}`,
      value: count(output.tested),
      role: "hit",
    },
    {
      name: "loop",
      meaning: `tests without a tree (${QUERIES[input.query] ?? "first"})`,
      value: count(output.loop),
      role: "miss",
    },
    {
      name: "level",
      meaning: `boxes compared on ${Math.round(input.level)} of ${output.levels}`,
      value: count(output.boxes_here),
      role: "a",
    },
    {
      name: "MeshTree",
      meaning: "its boxes and triangles",
      value: `${count(output.wide_boxes)}, ${count(output.wide_triangles)}`,
    },
    {
      name: "t",
      meaning: input.query === 1 ? "of the hit found" : "of the first hit",
      value: output.hits ? (output.t[0] ?? 0) : "no hit",
      role: output.hits ? "hit" : "ink",
    },
    {
      name: "same",
      meaning: "answer as by the loop",
      value: output.same ? "yes" : "no",
      role: output.same ? "ink" : "miss",
    },
  ],
  describe(input, output) {
    const t = pretty(output.t[0] ?? 0);
    const found = output.hits
      ? input.query === 2
        ? `The ray hits the mesh ${output.hits} times, first at t = ${t}`
        : `The ray hits the mesh at t = ${t}`
      : "The ray misses the mesh";
    return `${found}. It is compared with ${count(output.boxes)} boxes and ${count(output.tested)} triangles; a loop tests ${count(output.loop)} triangles. Solid boxes are opened, thin dashed ones missed, thick dashed ones behind a hit.`;
  },
});
