// Two bodies and the volumes around them. A volume is red where it may meet the other one and the
// bodies do not. The bars count how often that is so at random positions.

import { defineFigure, type Role, type Scene, type Value, type Vec2 } from "@contact/figure";

interface Input {
  a: Vec2;
  b: Vec2;
  turn_a: Vec2;
  turn_b: Vec2;
  shape_a: number;
  shape_b: number;
  kind: number;
  positions: number;
  drawn: number;
}

interface Output {
  vertices: readonly number[];
  vertex: readonly number[];
  corners: readonly number[];
  corner: readonly number[];
  centre: readonly number[];
  radius: readonly number[];
  meet: number;
  says: readonly number[];
  wrong: readonly number[];
  wrong_count: number;
  tested: number;
  tested_meet: number;
  tested_says: readonly number[];
  tested_wrong: readonly number[];
}

const KINDS = ["circles", "AABBs", "objects’ boxes", "8-DOPs", "hulls"] as const;
const MEANINGS = [
  "carried along",
  "made again from the vertices",
  "carried along",
  "made again from the vertices",
  "convex",
];
/** Room for each body in the C++'s lists. */
const VERTICES = 12;
/** Cells of a bar: all random positions. */
const CELLS = 40;
/** Dragged points move in tenths of this. */
const GRIP_STEP = 1.25;

const count = (n: number): string => n.toLocaleString("en-US");
const percent = (share: number): string => `${Math.round(100 * share)} %`;
const answer = (says: number | undefined): string => (says ? "may meet" : "apart");

/** The polygon with a number in a list that has room for `VERTICES` points each. */
const polygon = (points: readonly number[], which: number, vertices = 0): Vec2[] =>
  Array.from({ length: vertices }, (_, i): Vec2 => {
    const at = 2 * (VERTICES * which + i);
    return [points[at] ?? 0, points[at + 1] ?? 0];
  });

function volume(scene: Scene, output: Output, which: number, role: Role): void {
  const [x = 0, y = 0] = output.centre.slice(2 * which);
  const radius = output.radius[which] ?? 0;
  const style = { role, fill: 0.1, dashed: role === "muted" };
  if (radius > 0) scene.ball([x, y], radius, style);
  else scene.face(polygon(output.corner, which, output.corners[which]), style);
}

function body(scene: Scene, output: Output, which: number): void {
  const role = which ? "b" : "a";
  const outline = polygon(output.vertex, which, output.vertices[which]);
  scene.face(outline, { role, fill: 0.45, outline: false });
  scene.path([...outline, ...outline.slice(0, 1)], { role, width: 2 });
}

/** The random positions as a bar: green, the bodies meet; red, only the volumes do. */
function bar(output: Output, kind: number): Role[] {
  const cells = (part: number): number => Math.round((CELLS * part) / output.tested);
  const meet = cells(output.tested_meet);
  const says = cells(output.tested_says[kind] ?? 0);
  return Array.from({ length: CELLS }, (_, i) => (i < meet ? "hit" : i < says ? "miss" : "ghost"));
}

const turn = (field: "turn_a" | "turn_b", from: "a" | "b", label: string, role: Role) =>
  ({ kind: "point", field, from, label, role, step: GRIP_STEP, limit: [-2, 2] }) as const;
const position = (field: "a" | "b", label: string, role: Role) =>
  ({ kind: "point", field, label, role, step: GRIP_STEP, limit: [-3, 3] }) as const;
const shape = (field: "shape_a" | "shape_b", label: string) =>
  ({
    kind: "choice",
    field,
    label,
    options: ["star", "rod", "L", "disc"].map((name, value) => ({ value, label: name })),
  }) as const;

export default defineFigure<Input, Output>({
  title: "Do two bodies meet, if their volumes do?",
  view: { kind: "2d", x: [-3.3, 3.3], y: [-3.4, 2.1] },
  aspect: 1.2,
  initial: {
    a: [-1.125, 0.125],
    b: [0.75, 0.625],
    turn_a: [0.5, 1.25],
    turn_b: [1, -1.25],
    shape_a: 0,
    shape_b: 1,
    kind: 0,
    positions: 0,
    drawn: 1,
  },
  handles: [
    turn("turn_a", "a", "direction of body A", "a"),
    turn("turn_b", "b", "direction of body B", "b"),
    position("a", "position of body A", "a"),
    position("b", "position of body B", "b"),
  ],
  controls: [
    {
      kind: "choice",
      field: "kind",
      label: "Volumes",
      options: KINDS.map((label, value) => ({ value, label })),
    },
    shape("shape_a", "A"),
    shape("shape_b", "B"),
    {
      kind: "states",
      label: "Random positions",
      options: [
        { label: "none", fields: { positions: 0 } },
        { label: "1,000", fields: { positions: 1000, drawn: 1 } },
        { label: "another 1,000", fields: { positions: 1000, drawn: 2 } },
      ],
    },
    { kind: "numbers", field: "a", label: "A", role: "a", step: 0.125 },
    { kind: "numbers", field: "turn_a", label: "direction", role: "a", step: 0.125 },
    { kind: "numbers", field: "b", label: "B", role: "b", step: 0.125 },
    { kind: "numbers", field: "turn_b", label: "direction", role: "b", step: 0.125 },
  ],
  draw(scene, { a, b, turn_a, turn_b, kind }, output) {
    for (const [from, by, role] of [
      [a, turn_a, "a"],
      [b, turn_b, "b"],
    ] as const)
      scene.arrow(from, [from[0] + by[0], from[1] + by[1]], { role, width: 1.2, dashed: true });
    scene.label(a, "A", { role: "a", offset: [-12, 22], anchor: "end" });
    scene.label(b, "B", { role: "b", offset: [12, 22] });
    if (output.problem) return;
    const role = output.wrong[kind] ? "miss" : output.says[kind] ? "hit" : "muted";
    for (const which of [0, 1]) volume(scene, output, which, role);
    for (const which of [0, 1]) body(scene, output, which);
    if (output.tested) scene.strips(KINDS.map((name, i) => ({ name, cells: bar(output, i) })));
  },
  values: (_input, output) => [
    ...KINDS.map((name, i): Value => {
      const [says, wrong] = [output.tested_says[i] ?? 0, output.tested_wrong[i] ?? 0];
      return {
        name,
        meaning: output.tested
          ? `in ${count(output.tested)}: met ${count(says)} times, ${count(wrong)} false alarms`
          : (MEANINGS[i] ?? ""),
        value: `${answer(output.says[i])}${output.wrong[i] ? ": false alarm" : ""}`,
        role: output.wrong[i] ? "miss" : "hit",
      };
    }),
    {
      name: "bodies",
      meaning: output.tested
        ? `in ${count(output.tested)}: met ${count(output.tested_meet)} times`
        : "decided exactly",
      value: output.meet ? "meet" : "apart",
    },
  ],
  describe(_input, output) {
    const wrong = KINDS.filter((_, i) => output.wrong[i]);
    const now = output.meet ? "The bodies meet, and so do all volumes." : "The bodies are apart.";
    const others = output.meet
      ? ""
      : wrong.length
        ? ` False alarms: ${wrong.join(", ")}.`
        : " So are all volumes.";
    const [met = 0, bad = 0] = [output.tested_says[0], output.tested_wrong[0]];
    const often = output.tested
      ? ` In ${count(output.tested)} random positions the circles met ${count(met)} times; in ${count(
          bad,
        )} of these (${percent(met ? bad / met : 0)}) the bodies did not.`
      : "";
    return `${now}${others}${often}`;
  },
});
