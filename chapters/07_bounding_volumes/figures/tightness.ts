// A body that is turned, and a volume around it. Each bar is a volume: the green part is as large as
// the hull, and the red part is empty.

import {
  defineFigure,
  type Role,
  type Scene,
  type Value,
  type Vec3,
  vectorAt,
} from "@contact/figure";

interface Input {
  nose: Vec3;
  roll: number;
  shape: number;
  kind: number;
}

interface Output {
  triangles: number;
  vertex: readonly number[];
  triangle: readonly number[];
  hull_share: number;
  ratio: readonly number[];
  least: readonly number[];
  greatest: readonly number[];
  lines: number;
  line: readonly number[];
  centre: Vec3;
  radius: number;
}

const KINDS = [
  "grown sphere",
  "smallest sphere",
  "AABB",
  "box’s AABB",
  "object’s box",
  "principal axes",
  "smallest box",
  "14-DOP",
  "18-DOP",
  "26-DOP",
  "hull",
] as const;
const HULL = KINDS.length - 1;
const SHAPES = ["ball", "rod", "plate", "star", "knot"];
/** Cells of a bar. */
const CELLS = 40;

const times = (ratio = 0): string => ratio.toFixed(ratio < 9.995 ? 2 : ratio < 99.95 ? 1 : 0);

/** A volume as a bar: what the hull fills of it, and the rest. */
function bar(ratio = 1): Role[] {
  const filled = Math.max(1, Math.round(CELLS / ratio));
  return Array.from({ length: CELLS }, (_, i) => (i < filled ? "hit" : "miss"));
}

/** Faces, and each edge once: of its two triangles in the one that has it from the lower number. */
function body(scene: Scene, output: Output): void {
  for (let i = 0; i < output.triangles; i++) {
    const named = [0, 1, 2].map((k) => output.triangle[3 * i + k] ?? 0);
    const at = named.map((vertex) => vectorAt(output.vertex, vertex));
    scene.face(at, { role: "surface", fill: 0.3, outline: false });
    for (const [k, from] of at.entries())
      if ((named[k] ?? 0) < (named[(k + 1) % 3] ?? 0))
        scene.line(from, at[(k + 1) % 3] ?? from, { role: "surface", width: 0.5, through: true });
  }
}

export default defineFigure<Input, Output>({
  title: "How much of a volume is empty?",
  view: {
    kind: "3d",
    target: [0, 0, -1.2],
    azimuth: -62,
    elevation: 18,
    span: 5.2,
    projection: "orthographic",
  },
  aspect: 0.85,
  initial: { nose: [1.25, -0.75, 1], roll: 20, shape: 1, kind: 2 },
  handles: [
    {
      kind: "point",
      field: "nose",
      label: "direction of the body’s x axis",
      role: "ray",
      limit: [-2, 2],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "shape",
      label: "Body",
      options: SHAPES.map((label, value) => ({ value, label })),
    },
    {
      kind: "choice",
      field: "kind",
      label: "Volume",
      options: KINDS.map((label, value) => ({ value, label })),
    },
    { kind: "slider", field: "roll", label: "turn", min: 0, max: 360, step: 5, unit: "°", play: 8 },
    { kind: "numbers", field: "nose", label: "x axis", role: "ray" },
  ],
  draw(scene, { nose }, output) {
    scene.arrow([0, 0, 0], nose, { role: "ray", width: 1.5, through: true });
    if (output.problem) return;
    body(scene, output);
    if (output.radius > 0)
      scene.ball(output.centre, output.radius, { role: "b", fill: 0.12, outline: true });
    for (let i = 0; i < output.lines; i++)
      scene.line(vectorAt(output.line, 2 * i), vectorAt(output.line, 2 * i + 1), {
        role: "b",
        width: 1.5,
        through: true,
      });
    scene.strips(KINDS.slice(0, HULL).map((name, i) => ({ name, cells: bar(output.ratio[i]) })));
  },
  values: (input, output) => [
    ...KINDS.slice(0, HULL).map((name, i): Value => {
      const [least, greatest] = [times(output.least[i]), times(output.greatest[i])];
      return {
        name,
        meaning: least === greatest ? "the same when turned" : `turned: ${least} to ${greatest}`,
        value: `${times(output.ratio[i])}\u00a0×`,
        role: i === input.kind ? "b" : "ink",
      };
    }),
    {
      name: "body",
      meaning: "volume, against the hull’s",
      value: `${output.hull_share.toFixed(2)}\u00a0×`,
      role: "surface",
    },
  ],
  describe({ kind, shape }, output) {
    const name = KINDS[kind] ?? "hull";
    const now = `The chosen volume (${name}) around the ${SHAPES[shape] ?? "ball"} is ${times(output.ratio[kind])} times as large as its hull`;
    const [least, greatest] = [times(output.least[kind]), times(output.greatest[kind])];
    if (least === greatest) return `${now}, however it is turned.`;
    return `${now}; in 24 random orientations it is ${least} to ${greatest} times as large.`;
  },
});
