// Discs on a table with cells, from event to event. Below it the tournament of their predictions,
// and a row for each kind of event.

import {
  defineFigure,
  type PointHandle,
  pretty,
  type Role,
  type Scene,
  type Vec2,
} from "@contact/figure";

type Letter = "a" | "b" | "c" | "d" | "e" | "f" | "g";
type Input = Record<`position_${Letter}` | `velocity_${Letter}`, Vec2> & { event: number };

interface Output {
  event: number;
  time: number;
  start: readonly number[];
  stored: readonly number[];
  now: readonly number[];
  meeting: readonly number[];
  hit_time: readonly number[];
  partner: readonly number[];
  is_void: readonly number[];
  next_time: readonly number[];
  crosses: readonly number[];
  kind: number;
  who: number;
  whom: number;
  columns: number;
  rows: number;
  cell: number;
  seen: readonly number[];
  winner: readonly number[];
  played: readonly number[];
  matches: number;
  kinds: readonly number[];
  made_void: readonly number[];
  hits: number;
  crossings: number;
  voids: number;
  tests: number;
  all_tests: number;
}

const LETTERS = ["a", "b", "c", "d", "e", "f", "g"] as const;
const RADIUS = 0.3;
const WIDTH = 4;
const HEIGHT = 3;
const MOST = 24;
const WALLS = ["left wall", "right wall", "lower wall", "upper wall"] as const;
const HIT = 1;
const CROSSING = 2;
const VOID = 3;

const name = (disc: number): string => LETTERS[disc]?.toUpperCase() ?? "";
/** What a disc hits: another one, or a wall. */
const partnerName = (partner: number): string =>
  name(partner) || `the ${WALLS[partner - LETTERS.length] ?? "wall"}`;
const point = (flat: readonly number[], disc: number): Vec2 => [
  flat[2 * disc] ?? Number.NaN,
  flat[2 * disc + 1] ?? Number.NaN,
];

/** The tournament under the table: its root above, and below a leaf for each disc. */
const LEAVES = 8;
const TOP = -0.42;
const STEP = 0.4;
const place = (node: number): Vec2 => {
  const level = Math.floor(Math.log2(node));
  const below = LEAVES / 2 ** level;
  const first = (node - 2 ** level) * below;
  const last = Math.min(first + below, LETTERS.length);
  return [((first + last) / 2 / LETTERS.length) * WIDTH, TOP - level * STEP];
};

/** The rows of events under the tournament: the middle of the first, and a box's size. */
const ROWS = -2.7;
const ROW = 0.17;
const BOX = 0.125;

/** The discs that were part of the event shown. */
const tookPart = (output: Output, disc: number): boolean =>
  output.kind > 0 && (disc === output.who || (output.kind === HIT && disc === output.whom));

function drawCells(scene: Scene, output: Output): void {
  const { columns, rows, cell } = output;
  const [right, top] = [
    (i: number) => Math.min(i * cell, WIDTH),
    (i: number) => Math.min(i * cell, HEIGHT),
  ];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const seen = output.seen[row * columns + column] ?? 0;
      if (!seen) continue;
      scene.face(
        [
          [right(column), top(row)],
          [right(column + 1), top(row)],
          [right(column + 1), top(row + 1)],
          [right(column), top(row + 1)],
        ],
        { role: "c", fill: seen > 1 ? 0.16 : 0.05 },
      );
    }
  }
  for (let i = 1; i < columns; i++)
    scene.line([right(i), 0], [right(i), HEIGHT], { role: "ghost", width: 1 });
  for (let i = 1; i < rows; i++)
    scene.line([0, top(i)], [WIDTH, top(i)], { role: "ghost", width: 1 });
}

/** The line from where a disc is to where it expects its next hit. */
function drawPrediction(scene: Scene, output: Output, disc: number): void {
  if ((output.partner[disc] ?? -1) < 0) return;
  const isVoid = (output.is_void[disc] ?? 0) > 0;
  const [from, to] = [point(output.now, disc), point(output.meeting, disc)];
  const role: Role = isVoid ? "miss" : "ray";
  scene.line(from, to, { role, width: 1.3, dashed: isVoid });
  if (isVoid) {
    const [x, y] = to;
    scene.line([x - 0.07, y - 0.07], [x + 0.07, y + 0.07], { role, width: 2 });
    scene.line([x - 0.07, y + 0.07], [x + 0.07, y - 0.07], { role, width: 2 });
  } else {
    scene.dot(to, role, 3);
  }
  // Two that predict the same hit share a label.
  const other = output.partner[disc] ?? -1;
  const both = output.partner[other] === disc && output.hit_time[other] === output.hit_time[disc];
  if (both && other < disc) return;
  const who = both ? `${name(disc)}, ${name(other)}` : name(disc);
  const leftwards = to[0] < from[0] ? to[0] > 0.75 : to[0] > WIDTH - 0.75;
  const time = pretty(output.hit_time[disc] ?? 0, 3);
  scene.label(to, `${who} ${time}${isVoid ? " void" : ""}`, {
    role,
    offset: [leftwards ? -7 : 7, to[1] < from[1] ? 15 : -6],
    anchor: leftwards ? "end" : "start",
    size: "small",
  });
}

function drawDiscs(scene: Scene, input: Input, output: Output): void {
  for (let disc = 0; disc < LETTERS.length; disc++) {
    const [stored, now] = [point(output.stored, disc), point(output.now, disc)];
    const role: Role = tookPart(output, disc) ? (output.kind === VOID ? "miss" : "hit") : "ball";
    scene.line(stored, now, { role, width: 1.5, dashed: true });
    scene.ball(stored, RADIUS, { role, fill: 0.28 });
    scene.ball(now, RADIUS, { role, fill: 0, outline: true });
  }
  for (let disc = 0; disc < LETTERS.length; disc++) drawPrediction(scene, output, disc);
  for (const [disc, letter] of LETTERS.entries()) {
    const now = point(output.now, disc);
    if (input.event < 0.5) {
      const [x, y] = input[`position_${letter}`];
      const [vx, vy] = input[`velocity_${letter}`];
      scene.arrow([x, y], [x + vx, y + vy], { role: "ball", width: 2 });
    }
    scene.label(now, name(disc), {
      role: "ink",
      offset: input.event < 0.5 ? [-17, -10] : [0, 5],
      anchor: "middle",
    });
  }
}

function drawTournament(scene: Scene, output: Output): void {
  for (let node = 2; node < 2 * LEAVES; node++) {
    if ((output.winner[node] ?? -1) < 0) continue;
    const parent = Math.floor(node / 2);
    const won = output.winner[parent] === output.winner[node];
    scene.line(place(node), place(parent), { role: won ? "ink" : "ghost", width: won ? 1.8 : 1.2 });
  }
  for (let node = 1; node < 2 * LEAVES; node++) {
    const winner = output.winner[node] ?? -1;
    if (winner < 0) continue;
    const at = place(node);
    const leaf = node >= LEAVES;
    const replayed = (output.played[node] ?? 0) > 0 || (leaf && tookPart(output, winner));
    scene.dot(at, replayed ? "hit" : "muted", replayed ? 6 : 4, !replayed);
    const words =
      node === 1 ? `${name(winner)} ${pretty(output.next_time[winner] ?? 0, 3)} s` : name(winner);
    const leftChild = node > 1 && node % 2 === 0;
    scene.label(at, words, {
      role: replayed ? "hit" : "ink",
      offset: leaf ? [0, 19] : [leftChild ? -9 : 9, node === 1 ? -2 : 4],
      anchor: leaf ? "middle" : leftChild ? "end" : "start",
      size: "small",
    });
    if (!leaf) continue;
    const time = output.next_time[winner] ?? Infinity;
    const isVoid = (output.is_void[winner] ?? 0) > 0;
    const crosses = (output.crosses[winner] ?? 0) > 0;
    const partner = output.partner[winner] ?? -1;
    const what = crosses
      ? "cell"
      : partner < 0
        ? "–"
        : partner < LETTERS.length
          ? `hits ${name(partner)}`
          : "wall";
    const lines = [
      Number.isFinite(time) ? pretty(time, 3) : "never",
      isVoid && !crosses ? "void" : what,
    ];
    for (const [i, text] of lines.entries())
      scene.label(at, text, {
        role: isVoid && !crosses ? "miss" : "muted",
        offset: [0, 33 + 14 * i],
        anchor: "middle",
        size: "small",
      });
  }
}

/** A row for each kind of event, with a cell for each of the first events. */
function drawRows(scene: Scene, output: Output): void {
  const left = WIDTH - MOST * BOX;
  const of = (kind: number) => (n: number) => output.kinds[n] === kind;
  const rows: readonly [string, Role, (n: number) => boolean][] = [
    ["hits", "hit", of(HIT)],
    ["make void", "a", (n) => (output.made_void[n] ?? 0) > 0],
    ["crossings", "muted", of(CROSSING)],
    ["void", "miss", of(VOID)],
  ];
  for (const [row, [label, role, has]] of rows.entries()) {
    const y = ROWS - row * ROW;
    scene.line([left, y - ROW / 2], [WIDTH, y - ROW / 2], { role: "ghost", width: 1 });
    scene.label([left, y], label, { role, offset: [-8, 4], anchor: "end", size: "small" });
    for (let n = 0; n < MOST; n++) {
      if (!has(n)) continue;
      const [x, half] = [left + n * BOX, ROW / 2 - 0.02];
      scene.face(
        [
          [x + 0.01, y - half],
          [x + BOX - 0.01, y - half],
          [x + BOX - 0.01, y + half],
          [x + 0.01, y + half],
        ],
        { role, fill: 0.75 },
      );
    }
  }
  for (const n of [1, 5, 10, 15, 20]) {
    scene.label([left + (n - 0.5) * BOX, ROWS + ROW / 2], pretty(n), {
      role: "muted",
      offset: [0, -4],
      anchor: "middle",
      size: "small",
    });
  }
  if (!(output.event > 0)) return;
  const [x, top, bottom] = [left + (output.event - 1) * BOX, ROWS + ROW / 2, ROWS - 3.5 * ROW];
  scene.path(
    [
      [x, top],
      [x + BOX, top],
      [x + BOX, bottom],
      [x, bottom],
      [x, top],
    ],
    { role: "ink", width: 1.8 },
  );
}

const handle = (
  field: keyof Input,
  label: string,
  more: Partial<PointHandle<Input>>,
): PointHandle<Input> => ({
  kind: "point",
  field,
  label,
  role: "ball",
  step: 0.05,
  shown: (input) => input.event < 0.5,
  ...more,
});

export default defineFigure<Input, Output>({
  title: "A queue of predicted events",
  view: { kind: "2d", x: [-0.05, 4.05], y: [-3.32, 3.05] },
  aspect: 0.64,
  initial: {
    position_a: [2.45, 2.05],
    position_b: [1.9, 0.4],
    position_c: [3.05, 2.6],
    position_d: [3.2, 1.85],
    position_e: [1.9, 1.5],
    position_f: [2.6, 0.7],
    position_g: [0.55, 1.7],
    velocity_a: [0.35, -0.45],
    velocity_b: [0.55, -0.4],
    velocity_c: [-0.75, 0.45],
    velocity_d: [-0.25, 0.55],
    velocity_e: [-0.15, 0.55],
    velocity_f: [-0.4, 0.3],
    velocity_g: [0.5, -0.35],
    event: 0,
  },
  handles: [
    ...LETTERS.map((letter) =>
      handle(`velocity_${letter}`, `velocity of ${letter.toUpperCase()}, m/s`, {
        from: `position_${letter}`,
        limit: [-2, 2],
      }),
    ),
    ...LETTERS.map((letter) =>
      handle(`position_${letter}`, `centre of ${letter.toUpperCase()}`, { limit: [0.3, 3.7] }),
    ),
  ],
  controls: [
    { kind: "slider", field: "event", label: "events", min: 0, max: MOST, step: 1, play: 24 },
    {
      kind: "states",
      label: "go to",
      options: [{ label: "the start, to arrange the discs", fields: { event: 0 } }],
    },
  ],
  draw(scene, input, output) {
    const corners: readonly Vec2[] = [
      [0, 0],
      [WIDTH, 0],
      [WIDTH, HEIGHT],
      [0, HEIGHT],
      [0, 0],
    ];
    if (output.problem) {
      scene.path(corners, { role: "surface", width: 3 });
      for (const letter of LETTERS)
        scene.ball(input[`position_${letter}`], RADIUS, { role: "ball", fill: 0.28 });
      return;
    }
    drawCells(scene, output);
    scene.path(corners, { role: "surface", width: 3 });
    drawDiscs(scene, input, output);
    drawTournament(scene, output);
    drawRows(scene, output);
  },
  values: (_input, output) => [
    { name: "t", meaning: "of the last event", value: output.time, unit: "s" },
    { name: "hits", meaning: "so far", value: output.hits, role: "hit" },
    { name: "crossings", meaning: "from cell to cell", value: output.crossings, role: "muted" },
    { name: "void", meaning: "predictions discarded", value: output.voids, role: "miss" },
    {
      name: "made void",
      meaning: "predictions, by this event",
      value: output.event > 0 ? (output.made_void[output.event - 1] ?? 0) : 0,
      role: "a",
    },
    {
      name: "matches",
      meaning: "played again after this event",
      value: output.matches,
      role: "hit",
    },
    {
      name: "tests",
      meaning: "of pairs so far, the first predictions included",
      value: output.tests,
    },
    {
      name: "without cells",
      meaning: "tests that the same hits would need",
      value: output.all_tests,
    },
  ],
  describe(_input, output) {
    const who = name(output.who);
    const at = `Event ${pretty(output.event)}, at ${pretty(output.time, 3)} s:`;
    const next = output.winner[1] ?? 0;
    const then = Number.isFinite(output.next_time[next] ?? Infinity)
      ? ` ${name(next)} is at the root: its event comes next, at ${pretty(output.next_time[next] ?? 0, 3)} s.`
      : " No event follows.";
    if (output.kind === HIT) {
      const made = output.made_void[output.event - 1] ?? 0;
      const words =
        made === 0 ? "" : `, which makes ${pretty(made)} prediction${made > 1 ? "s" : ""} void`;
      return `${at} ${who} hits ${partnerName(output.whom)}${words}.${then}`;
    }
    if (output.kind === CROSSING)
      return `${at} ${who} enters another cell, and new neighbours are tested.${then}`;
    if (output.kind === VOID)
      return `${at} the prediction that ${who} hits ${partnerName(output.whom)} is void and discarded; the next hit of ${who} is predicted again.${then}`;
    return `Each disc has predicted its next event.${then}`;
  },
});
