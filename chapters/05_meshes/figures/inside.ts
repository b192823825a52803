// A point and a concave mesh. The ray of the chosen method numbers what it crosses; a red dot is a
// point of the section at which this method is wrong.

import {
  along,
  defineFigure,
  pretty,
  type Role,
  type Value,
  type Vec3,
  vectorAt,
} from "@contact/figure";

interface Input {
  p: Vec3;
  direction: Vec3;
  method: number;
  divided: number;
}

interface Output {
  vertex: readonly number[];
  triangle: readonly number[];
  edge: readonly number[];
  flat: readonly number[];
  where: number;
  says: readonly number[];
  wrong: readonly number[];
  decided_by: readonly number[];
  hits: number;
  at: readonly number[];
  step: readonly number[];
  share: readonly number[];
  missed: readonly number[];
  missed_points: number;
}

const METHODS = ["parity", "parity in float", "solid angles", "angles in float", "exact"] as const;
const WHERE = ["outside", "on the surface", "inside"];
const GROUND = -2;
/** The section of the C++. */
const COLUMNS = 31;
const FIRST_X = -3.75;
const FIRST_Z = -2.375;
const FAR = 40;

/** Dragged points move in tenths of this, in eighths of a metre, which are stored without rounding. */
const GRIP_STEP = 1.25;

const count = (n: number): string => n.toLocaleString("en-US");
const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** Numbers the hits, or signs them; those at the same position share a label. */
function labels(output: Output): { at: Vec3; text: string }[] {
  const positions: { at: Vec3; names: string[] }[] = [];
  for (let i = 0; i < output.hits; i++) {
    const at = vectorAt(output.at, i);
    const step = output.step[i] ?? 0;
    const name = step ? (step > 0 ? "+1" : "−1") : String(i + 1);
    const last = positions.at(-1);
    if (last && Math.hypot(...last.at.map((x, k) => x - (at[k] ?? 0))) < 1e-6)
      last.names.push(name);
    else positions.push({ at, names: [name] });
  }
  return positions.map(({ at, names }) => ({
    at,
    text: names.length > 2 ? `${names[0]}–${names.at(-1)}` : names.join(", "),
  }));
}

function reason(i: number, output: Output): string {
  const by = output.decided_by[i] ?? 0;
  const wrong = output.wrong[i] ? ", wrong" : "";
  if (i < 2) return `counts ${by}${wrong}`;
  if (i < 4) return `sum ${pretty(Math.round(by * 1e6) / 1e6)}${wrong}`;
  return `winding number ${pretty(by)}`;
}

export default defineFigure<Input, Output>({
  title: "Is the point inside the mesh?",
  view: {
    kind: "3d",
    target: [0, 0, -0.1],
    azimuth: -72,
    elevation: 17,
    span: 7.4,
    ground: { half: 4, z: GROUND, step: 1 },
  },
  aspect: 1.2,
  initial: { p: [-2, 0.25, 0.25], direction: [1.5, 0, 0], method: 0, divided: 1 },
  handles: [
    {
      kind: "point",
      field: "direction",
      from: "p",
      label: "direction of the ray",
      role: "ray",
      move: "vertical",
      step: GRIP_STEP,
      limit: [-4, 4],
    },
    {
      kind: "point",
      field: "p",
      label: "p, the point",
      role: "ray",
      move: "vertical",
      step: GRIP_STEP,
      limit: [-3.75, 3.75],
    },
  ],
  controls: [
    {
      kind: "states",
      label: "The ray meets",
      options: [
        { label: "an edge", fields: { p: [-2, 0.25, 0], direction: [1, 0, 0.75], method: 0 } },
        {
          label: "a vertex",
          fields: { p: [-2, 0, 0.5], direction: [0, -0.5, 0.625], method: 0 },
        },
        { label: "a face’s plane", fields: { p: [0, 0.25, 0], direction: [1, 0, 0], method: 0 } },
        { label: "a diagonal", fields: { p: [0, 0, 0.5], direction: [1, 0, 0], method: 0 } },
      ],
    },
    {
      kind: "choice",
      field: "method",
      label: "Method",
      options: [
        { value: 0, label: "parity, in double" },
        { value: 1, label: "parity, in float" },
        { value: 2, label: "solid angles, in double" },
        { value: 3, label: "solid angles, in float" },
        { value: 4, label: "exact: the book’s" },
      ],
    },
    {
      kind: "choice",
      field: "divided",
      label: "Coordinates",
      options: [
        { value: 1, label: "as they are" },
        { value: 10, label: "divided by 10" },
      ],
    },
    { kind: "numbers", field: "p", label: "p", role: "ray", step: 0.125 },
    { kind: "numbers", field: "direction", label: "D", role: "ray", step: 0.125 },
  ],
  draw(scene, input, output) {
    const { p, direction, method } = input;
    scene.drop(p, GROUND);
    if (output.problem) {
      scene.label(p, "p", { role: "ray", offset: [0, -18], anchor: "middle" });
      return;
    }
    const corner = (i = 0): Vec3 => vectorAt(output.vertex, i);
    const angles = method === 2 || method === 3;
    for (let i = 0; 3 * i < output.triangle.length; i++) {
      const corners = [0, 1, 2].map((k) => corner(output.triangle[3 * i + k]));
      const share = angles ? (output.share[i] ?? 0) : 0;
      scene.face(corners, {
        role: share > 0 ? "a" : share < 0 ? "b" : "surface",
        fill: angles ? Math.min(0.6, 0.04 + 3 * Math.abs(share)) : 0.09,
        outline: share < 0,
        dashed: share < 0,
        hides: true,
      });
    }
    for (const [i, flat] of output.flat.entries())
      scene.line(corner(output.edge[2 * i]), corner(output.edge[2 * i + 1]), {
        role: "surface",
        width: flat ? 0.5 : 1.6,
        through: flat === 1,
      });
    for (const [cell, missed] of output.missed.entries()) {
      if (!missed) continue;
      const x = FIRST_X + 0.25 * (cell % COLUMNS);
      const z = FIRST_Z + 0.125 * Math.floor(cell / COLUMNS);
      scene.dot([x, p[1], z], "miss", 2);
    }

    if (!angles) {
      const ray: Vec3 = method === 4 ? [0, 0, 1] : direction;
      const length = Math.hypot(...ray);
      scene.line(p, along(p, add(p, ray), FAR / length), { role: "ray", width: 2.5, arrow: true });
      for (const { at, text } of labels(output)) {
        scene.dot(at, "ray", 5);
        scene.label(at, text, { role: "ray", offset: [8, -10] });
      }
    }
    if (method >= 2)
      scene.line(p, add(p, direction), { role: "ray", width: 1, dashed: true, through: true });
    const wrong = output.wrong[method] === 1;
    const said = output.says[method] ?? 0;
    scene.dot(p, wrong ? "miss" : said ? "hit" : "ray", 5);
    scene.label(p, `${WHERE[said]}${wrong ? ", wrong" : ""}`, {
      role: wrong ? "miss" : said ? "hit" : "ray",
      offset: [0, 28],
      anchor: "middle",
    });
  },
  values: (_input, output) => [
    ...METHODS.map(
      (name, i): Value => ({
        name,
        meaning: reason(i, output),
        value: WHERE[output.says[i] ?? 0] ?? "",
        role: (output.wrong[i] ? "miss" : "hit") as Role,
      }),
    ),
    {
      name: "red",
      meaning: "points decided wrongly",
      value: count(output.missed_points),
      role: output.missed_points ? "miss" : "ink",
    },
  ],
  describe(input, output) {
    const { method, p } = input;
    const wrong = METHODS.filter((_, i) => output.wrong[i]);
    const others = wrong.length ? `Wrong here: ${wrong.join(", ")}.` : "Every method says so.";
    const seen =
      method === 2 || method === 3
        ? " Triangles seen from behind count as positive, those seen from the front as negative."
        : "";
    return `p is ${WHERE[output.where]}. ${others} Of ${count(output.missed.length)} other points in the section y = ${pretty(p[1])} m, the chosen method is wrong at ${count(output.missed_points)}.${seen}`;
  },
});
