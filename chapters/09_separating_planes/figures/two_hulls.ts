// Two convex bodies in the plane with the proof of how they lie to each other, and a dashed line of
// the reader's own. Vertices on its wrong side are red.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  a: Vec2;
  b: Vec2;
  turn_a: Vec2;
  turn_b: Vec2;
  p: Vec2;
  q: Vec2;
  radius: number;
  shown: number;
}

interface Output {
  a0: Vec2;
  a1: Vec2;
  a2: Vec2;
  a3: Vec2;
  a4: Vec2;
  b0: Vec2;
  b1: Vec2;
  b2: Vec2;
  b3: Vec2;
  state: number;
  checked: number;
  gap: number;
  between: readonly number[];
  end_of_a: readonly number[];
  end_of_b: readonly number[];
  support_a: Vec2;
  support_b: Vec2;
  common: Vec2;
  wrong: number;
  on_line: number;
  wrong_a: readonly number[];
  wrong_b: readonly number[];
}

const STATES = ["disjoint", "touching", "overlapping"] as const;
const [DISJOINT, TOUCHING, OVERLAPPING] = [0, 1, 2];
/** Dragged points move in tenths of this, in sixteenths of a metre. */
const GRIP_STEP = 0.625;
/** Segments of the rounding of a vertex. */
const ARC = 24;

const vertices = (count: number): string => `${count} ${count === 1 ? "vertex" : "vertices"}`;
const plus = (v: Vec2, w: Vec2): Vec2 => [v[0] + w[0], v[1] + w[1]];
const outline_a = ({ a }: Input, { a0, a1, a2, a3, a4 }: Output): Vec2[] =>
  [a0, a1, a2, a3, a4].map((v) => plus(a, v));
const outline_b = ({ b }: Input, { b0, b1, b2, b3 }: Output): Vec2[] =>
  [b0, b1, b2, b3].map((v) => plus(b, v));

/** The polygon with a disc of the radius around each point, counter-clockwise. */
function rounded(polygon: readonly Vec2[], radius: number): Vec2[] {
  if (!(radius > 0)) return [...polygon];
  return polygon.flatMap((v, i) => {
    const before = polygon[(i + polygon.length - 1) % polygon.length] ?? v;
    const after = polygon[(i + 1) % polygon.length] ?? v;
    const from = Math.atan2(before[0] - v[0], v[1] - before[1]);
    const to = Math.atan2(v[0] - after[0], after[1] - v[1]);
    const by = (to - from + 2 * Math.PI) % (2 * Math.PI);
    return Array.from({ length: ARC + 1 }, (_, k): Vec2 => {
      const angle = from + (by * k) / ARC;
      return plus(v, [radius * Math.cos(angle), radius * Math.sin(angle)]);
    });
  });
}

function body(scene: Scene, polygon: readonly Vec2[], radius: number, role: Role): void {
  const outline = rounded(polygon, radius);
  scene.face(outline, { role, fill: 0.3, outline: false });
  scene.path([...outline, ...outline.slice(0, 1)], { role, width: 2 });
  if (radius > 0)
    scene.path([...polygon, ...polygon.slice(0, 1)], { role, width: 1, dashed: true });
}

function line(scene: Scene, ends: readonly number[], role: Role, width: number): void {
  const [x1 = 0, y1 = 0, x2 = 0, y2 = 0] = ends;
  scene.line([x1, y1], [x2, y2], { role, width });
}

function proof(scene: Scene, output: Output): void {
  if (output.state !== OVERLAPPING) {
    if (output.state === DISJOINT) {
      line(scene, output.end_of_a, "a", 1);
      line(scene, output.end_of_b, "b", 1);
    }
    line(scene, output.between, "hit", 2.5);
    scene.dot(output.support_a, "a", 5).dot(output.support_b, "b", 5);
  }
  if (output.state !== DISJOINT) {
    scene.dot(output.common, "normal", 6);
    scene.label(output.common, "common point", {
      role: "normal",
      offset: [0, 22],
      anchor: "middle",
      size: "small",
    });
  }
}

const point = (field: "a" | "b" | "p" | "q", label: string, role: Role) =>
  ({ kind: "point", field, label, role, step: GRIP_STEP, limit: [-2.5, 2.5] }) as const;
const turn = (field: "turn_a" | "turn_b", from: "a" | "b", label: string, role: Role) =>
  ({ kind: "point", field, from, label, role, step: GRIP_STEP, limit: [-1.25, 1.25] }) as const;

const SEPARATED = {
  a: [-1.125, 0],
  b: [0.875, 0.25],
  turn_a: [0, 1],
  turn_b: [0, 1],
  radius: 0,
} as const;

/** What the reader's line does, and what can be said about all lines. */
function yours(output: Output): string {
  const { state, wrong, on_line } = output;
  const on = on_line ? ` It touches ${vertices(on_line)}.` : "";
  if (wrong) {
    const now = `Your line has ${vertices(wrong)} on the wrong side.${on}`;
    return state === OVERLAPPING ? `${now} No line has 0.` : now;
  }
  return on_line
    ? `Your line has no vertex on the wrong side, but it touches ${vertices(on_line)}.`
    : "Your line separates them, too: it proves that they are disjoint.";
}

export default defineFigure<Input, Output>({
  title: "A line between two bodies",
  view: { kind: "2d", x: [-2.6, 2.6], y: [-2.4, 2.4] },
  aspect: 1.08,
  initial: {
    ...SEPARATED,
    p: [-1, 1.75],
    q: [0.5, -1.75],
    shown: 1,
  },
  handles: [
    point("p", "one point of your line", "ray"),
    point("q", "another point of your line", "ray"),
    turn("turn_a", "a", "direction of body A", "a"),
    turn("turn_b", "b", "direction of body B", "b"),
    point("a", "position of body A", "a"),
    point("b", "position of body B", "b"),
  ],
  controls: [
    {
      kind: "states",
      label: "Bodies",
      options: [
        { label: "disjoint", fields: { ...SEPARATED } },
        { label: "touching", fields: { ...SEPARATED, b: [0.375, 0.25] } },
        { label: "overlapping", fields: { ...SEPARATED, b: [0.125, 0.25] } },
      ],
    },
    {
      kind: "choice",
      field: "shown",
      label: "The book’s proof",
      options: [
        { value: 1, label: "shown" },
        { value: 0, label: "hidden" },
      ],
    },
    { kind: "slider", field: "radius", label: "radius", min: 0, max: 0.5, step: 0.0625, unit: "m" },
    { kind: "numbers", field: "p", label: "your p", role: "ray", step: 0.0625 },
    { kind: "numbers", field: "q", label: "your q", role: "ray", step: 0.0625 },
    { kind: "numbers", field: "a", label: "A", role: "a", step: 0.0625 },
    { kind: "numbers", field: "turn_a", label: "direction", role: "a", step: 0.0625 },
    { kind: "numbers", field: "b", label: "B", role: "b", step: 0.0625 },
    { kind: "numbers", field: "turn_b", label: "direction", role: "b", step: 0.0625 },
  ],
  draw(scene, input, output) {
    const { a, b, p, q, turn_a, turn_b } = input;
    scene.arrow(a, plus(a, turn_a), { role: "a", width: 1.2, dashed: true });
    scene.arrow(b, plus(b, turn_b), { role: "b", width: 1.2, dashed: true });
    scene.label(a, "A", { role: "a", offset: [-12, 22], anchor: "end" });
    scene.label(b, "B", { role: "b", offset: [12, 22] });
    if (output.problem) return;
    const [of_a, of_b] = [outline_a(input, output), outline_b(input, output)];
    body(scene, of_a, 0, "a");
    body(scene, of_b, input.radius, "b");
    const away = (from: Vec2, to: Vec2): Vec2 => [
      to[0] + 32 * (to[0] - from[0]),
      to[1] + 32 * (to[1] - from[1]),
    ];
    const right = output.wrong === 0;
    const role = right ? "hit" : "ray";
    scene.line(away(q, p), away(p, q), { role, width: 2, dashed: true });
    scene.label(p, right ? "0 wrong" : `${output.wrong} wrong`, {
      role: right ? "hit" : "miss",
      offset: [14, -8],
    });
    const wrong = (of: readonly Vec2[], is: readonly number[]): void => {
      for (const [i, v] of of.entries()) if (is[i]) scene.dot(v, "miss", 9, true);
    };
    wrong(of_a, output.wrong_a);
    wrong(of_b, output.wrong_b);
    if (input.shown) proof(scene, output);
  },
  values: (_input, output) => [
    {
      name: "bodies",
      meaning: "decided exactly",
      value: STATES[output.state] ?? "",
      role: output.state === DISJOINT ? "hit" : "normal",
    },
    {
      name: "proof",
      meaning: [
        "a line between them",
        "a common point, and a line",
        "a common point, also after any small move",
      ][output.state] as string,
      value: output.checked ? "holds" : "fails",
      role: output.checked ? "hit" : "miss",
    },
    {
      name: "gap",
      meaning: "the shortest distance",
      value: output.state === DISJOINT ? `${pretty(output.gap)} m` : "none",
    },
    lineValue(output),
  ],
  describe(_input, output) {
    const now = [
      `The bodies are disjoint, ${pretty(output.gap)} m apart: the line between them proves it.`,
      "The bodies touch: they have a common point, and a line has them on its two sides.",
      "The bodies overlap.",
    ][output.state];
    return `${now} ${yours(output)}`;
  },
});

function lineValue({ state, wrong, on_line }: Output): Value {
  const separates = wrong === 0 && (on_line === 0 || state === TOUCHING);
  return {
    name: "your line",
    meaning: on_line ? `touches ${vertices(on_line)}` : "vertices on the wrong side",
    value: wrong,
    role: separates ? "hit" : "miss",
  };
}
