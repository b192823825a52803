// Two triangles in space: the line of both planes, the interval of each triangle on it, and the
// answers of several methods, also for the first triangle moved by a few ulps.

import {
  defineFigure,
  floatOrDouble,
  type Role,
  type Scene,
  type Value,
  type Vec3,
  vectorAt,
} from "@contact/figure";

interface Input {
  u0: Vec3;
  u1: Vec3;
  u2: Vec3;
  v0: Vec3;
  v1: Vec3;
  v2: Vec3;
  single: number;
  divided: number;
}

interface Output {
  d_of_u: Vec3;
  d_of_v: Vec3;
  side_of_u: Vec3;
  side_of_v: Vec3;
  ends_of_u: number;
  ends_of_v: number;
  on_line_u: readonly number[];
  on_line_v: readonly number[];
  crossing_planes: number;
  line_at: Vec3;
  line_along: Vec3;
  decided_in: number;
  says: readonly number[];
  wrong: readonly number[];
  common: number;
  points: number;
  point: readonly number[];
  moved_says: readonly number[];
  moved_wrong: readonly number[];
  moved_wrong_in_all: readonly number[];
}

const METHODS = ["steps", "intervals", "edges", "axes", "orientations", "exact"] as const;
const MEANINGS = [
  "",
  "|d| < 10⁻⁶ counts as 0",
  "each against the other triangle",
  "separating, computed",
  "rounded",
  "the book’s triangles_meet",
];
const COMMON = ["nothing", "a point", "a segment", "an area"];
const ULPS = 12;
const SHIFTS = 2 * ULPS + 1;
/** Half of the line that is drawn. */
const FAR = 2.6;

/** Dragged points move in tenths of this, in eighths of a metre, which are stored without rounding. */
const GRIP_STEP = 1.25;

const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sign = (side: number | undefined): string => (side ? (side > 0 ? "+" : "−") : "0");
const answer = (says: number | undefined): string => (says ? "meet" : "apart");

function reason(decided: number): string {
  if (decided === 0) return "all d are 0: no answer";
  return decided === 2 ? "rejected in step 2" : `decided in step ${decided}`;
}

/** The part of the line that one triangle has. */
function interval(scene: Scene, count: number, ends: readonly number[], role: Role, wide: boolean) {
  const [from, to] = [vectorAt(ends, 0), vectorAt(ends, 1)];
  if (count === 2) scene.line(from, to, { role, width: wide ? 8 : 3.5, through: true });
  for (let i = 0; i < count; i++) scene.dot(vectorAt(ends, i), role, wide ? 6 : 4.5, wide);
}

const point = (field: keyof Input, label: string, role: Role) =>
  ({
    kind: "point",
    field,
    label,
    role,
    move: "vertical",
    step: GRIP_STEP,
    limit: [-3.75, 3.75],
  }) as const;
const numbers = (field: keyof Input, label: string, role: Role) =>
  ({ kind: "numbers", field, label, role, step: 0.125 }) as const;

/** T2 vertical, seen from the front, in the plane y = 0. */
const FRONT = { v0: [1.5, 0, -1], v1: [0, 0, 1.5], v2: [-1.5, 0, -1] } as const;
const CROSSING = {
  u0: [-0.75, -0.5, 1],
  u1: [1, -0.625, 0.5],
  u2: [0.25, 0.75, -1.25],
  v0: [1.5, 0.25, -0.75],
  v1: [-0.25, -0.25, 1.5],
  v2: [-1.5, 0.25, -1],
} as const;

export default defineFigure<Input, Output>({
  title: "Do two triangles meet?",
  view: {
    kind: "3d",
    target: [0, 0, -0.6],
    azimuth: -66,
    elevation: 16,
    span: 4.4,
    ground: { half: 2.5, z: -1.5, step: 0.5 },
  },
  aspect: 0.82,
  initial: { ...CROSSING, single: 0, divided: 1 },
  handles: [
    point("v0", "v0, vertex of T2", "b"),
    point("v1", "v1, vertex of T2", "b"),
    point("v2", "v2, vertex of T2", "b"),
    point("u0", "u0, vertex of T1", "a"),
    point("u1", "u1, vertex of T1", "a"),
    point("u2", "u2, vertex of T1", "a"),
  ],
  controls: [
    {
      kind: "states",
      label: "Triangles",
      options: [
        { label: "crossing", fields: CROSSING },
        {
          label: "apart by a plane",
          fields: {
            ...FRONT,
            u0: [-0.75, -0.75, 1],
            u1: [1, -0.625, 1.25],
            u2: [0.125, -0.375, 0.125],
          },
        },
        {
          label: "apart on the line",
          fields: { ...FRONT, u0: [1, -0.75, 0.75], u1: [1.5, 0.75, -0.25], u2: [1.75, -0.25, 1] },
        },
        {
          label: "a vertex touches",
          fields: { ...FRONT, u0: [-0.75, -0.75, 1], u1: [1, -0.625, 1.25], u2: [0.125, 0, 0.25] },
        },
        {
          label: "one ulp apart",
          fields: {
            ...FRONT,
            u0: [-0.75, -0.75, 1],
            u1: [1, -0.625, 1.25],
            u2: [0.125, -(2 ** -52), 0.25],
          },
        },
        {
          label: "edge on edge",
          fields: {
            ...FRONT,
            u0: [0.5, -0.75, 0.75],
            u1: [1, 0.75, -0.25],
            u2: [1.75, -0.25, 0.75],
          },
        },
        {
          label: "in one plane",
          fields: { ...FRONT, u0: [-1.25, 0, 0.75], u1: [0.5, 0, -0.5], u2: [1.25, 0, 1] },
        },
        {
          label: "one inside the other",
          fields: { ...FRONT, u0: [-0.5, 0, -0.5], u1: [0.625, 0, -0.625], u2: [0, 0, 0.5] },
        },
      ],
    },
    floatOrDouble,
    {
      kind: "choice",
      field: "divided",
      label: "Coordinates",
      options: [
        { value: 1, label: "as they are" },
        { value: 10, label: "divided by 10" },
        { value: 1000, label: "divided by 1,000" },
      ],
    },
    numbers("u0", "u_0", "a"),
    numbers("u1", "u_1", "a"),
    numbers("u2", "u_2", "a"),
    numbers("v0", "v_0", "b"),
    numbers("v1", "v_1", "b"),
    numbers("v2", "v_2", "b"),
  ],
  draw(scene, input, output) {
    const { u0, u1, u2, v0, v1, v2 } = input;
    scene.face([v0, v1, v2], { role: "b", fill: 0.18, hides: true });
    scene.face([u0, u1, u2], { role: "a", fill: 0.22, hides: true });
    const middle = [u0, v0].map(([, , z], i) => (z + (i ? v1 : u1)[2] + (i ? v2 : u2)[2]) / 3);
    const signs = output.problem ? [] : [...output.side_of_u, ...output.side_of_v];
    for (const [i, at] of [u0, u1, u2, v0, v1, v2].entries()) {
      const name = `${i < 3 ? "u" : "v"}_${i % 3}`;
      scene.label(at, signs.length ? `${name} ${sign(signs[i])}` : name, {
        role: i < 3 ? "a" : "b",
        offset: [0, at[2] > (middle[i < 3 ? 0 : 1] ?? 0) ? -17 : 27],
        anchor: "middle",
      });
    }
    if (output.problem) return;
    for (let i = 0; i < 3; i++) {
      const [a, b] = [[v0, v1, v2][i] ?? v0, [v0, v1, v2][(i + 1) % 3] ?? v0];
      const [c, d] = [[u0, u1, u2][i] ?? u0, [u0, u1, u2][(i + 1) % 3] ?? u0];
      scene.line(a, b, { role: "b", width: 2 }).line(c, d, { role: "a", width: 2 });
    }
    if (output.crossing_planes) {
      const by = output.line_along.map((x) => FAR * x) as unknown as Vec3;
      const back = by.map((x) => -x) as unknown as Vec3;
      scene.line(add(output.line_at, back), add(output.line_at, by), {
        role: "muted",
        width: 1.2,
        dashed: true,
        through: true,
      });
    }
    interval(scene, output.ends_of_u, output.on_line_u, "a", true);
    interval(scene, output.ends_of_v, output.on_line_v, "b", false);
    const common = Array.from({ length: output.points }, (_, i) => vectorAt(output.point, i));
    if (output.common === 3) scene.face(common, { role: "hit", fill: 0.45 });
    for (const at of common) scene.dot(at, "hit", 4);
    for (let i = 0; i < output.ends_of_u && output.ends_of_u === 2; i++)
      scene.label(vectorAt(output.on_line_u, i), i ? "q" : "p", { role: "a", offset: [9, 17] });
    scene.strips(
      METHODS.map((name, m) => ({
        name,
        cells: Array.from({ length: SHIFTS }, (_, k) => {
          const says = output.moved_says[SHIFTS * m + k];
          return output.moved_wrong[SHIFTS * m + k] ? "miss" : says ? "hit" : "ghost";
        }),
      })),
    );
  },
  values: (_input, output) => [
    ...METHODS.map(
      (name, m): Value => ({
        name,
        meaning: m ? (MEANINGS[m] ?? "") : reason(output.decided_in),
        value: `${answer(output.says[m])}${output.wrong[m] ? ", wrong" : ""}`,
        role: output.wrong[m] ? "miss" : "hit",
      }),
    ),
    { name: "common", meaning: "points of both", value: COMMON[output.common] ?? "" },
    { name: "d_i", meaning: "of the u", value: output.d_of_u, role: "a" },
    { name: "d_i", meaning: "of the v", value: output.d_of_v, role: "b" },
  ],
  describe(_input, output) {
    const wrong = METHODS.filter((_, m) => output.wrong[m]);
    const meet = output.says[5]
      ? `The triangles have ${COMMON[output.common]} in common`
      : "The triangles are apart";
    const others = wrong.length ? `Wrong here: ${wrong.join(", ")}.` : "Every method says so.";
    const near = METHODS.map((name, m) => [name, output.moved_wrong_in_all[m] ?? 0] as const)
      .filter(([, count]) => count > 0)
      .map(([name, count]) => `${name} ${count}`);
    const red = near.length ? ` Red, because wrong: ${near.join(", ")} of ${SHIFTS}.` : "";
    return `${meet}. ${others} Rows: the answers with T₁ moved along y by −${ULPS} to ${ULPS} ulps.${red}`;
  },
});
