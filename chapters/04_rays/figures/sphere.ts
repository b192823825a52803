// A ball and a ray: where the chosen method has it enter and leave, and the outline that parallel
// rays find by this method. Red is what the method gets wrong.

import {
  defineFigure,
  floatOrDouble,
  pretty,
  type Role,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  origin: Vec2;
  through: Vec2;
  centre: Vec2;
  radius: number;
  far: number;
  direction: number;
  method: number;
  single: number;
}

interface Output {
  moved: number;
  drawn_from: Vec2;
  drawn_to: Vec2;
  meets: number;
  hit: number;
  inside: number;
  t: number;
  point: Vec2;
  normal: Vec2;
  square: number;
  compared: number;
  difference: number;
  finds: readonly number[];
  says: readonly number[];
  wrong: readonly number[];
  entry: readonly number[];
  exit: readonly number[];
  entry_at: readonly number[];
  exit_at: readonly number[];
  entry_past: readonly number[];
  exit_past: readonly number[];
  off: readonly number[];
  ray_finds: readonly number[];
  ray_wrong: readonly number[];
  ray_entry: readonly number[];
  ray_exit: readonly number[];
  rays_wrong: number;
  rays_off: number;
}

const METHODS = ["the book’s", "the lecture’s", "the textbook’s", "nearest point"];
/** The two numbers that each method compares. */
const FIRST = ["r²", "(D·M)²", "B²", "r²"];
const SECOND = ["distance² of line and c", "|M|² − r²", "4 A C", "distance² of line and c"];
const MEETS = ["misses the ball", "touches the ball", "crosses the ball"];
/** An entry that is off by less than this is not seen in the drawing, m. */
const VISIBLE = 0.02;

const at = (numbers: readonly number[], i: number): Vec2 => [
  numbers[2 * i] ?? 0,
  numbers[2 * i + 1] ?? 0,
];
const ahead = (from: Vec2, by: Vec2, factor: number): Vec2 => [
  from[0] + by[0] * factor,
  from[1] + by[1] * factor,
];
const metres = (length = 0): string => `${pretty(length, 3)} m`;
const off = (output: Output, i: number): boolean => (output.off[i] ?? 0) >= VISIBLE;
/** Where a method has the line enter and leave. */
const roots = (output: Output, i: number): string =>
  output.moved
    ? `${pretty(output.entry_past[i] ?? 0)} and ${pretty(output.exit_past[i] ?? 0)} m past o`
    : `t = ${pretty(output.entry[i] ?? 0)} and ${pretty(output.exit[i] ?? 0)}`;

/** Whether a point is in the drawing, and a label on one side of it, but not over the edge. */
const seen = ([x, y]: Vec2): boolean => Math.abs(x) < 5 && Math.abs(y) < 3.2;
const beside = ([x]: Vec2, left: boolean, down: number) =>
  x > -2.7 && (left || x > 2.7)
    ? ({ offset: [-8, down], anchor: "end" } as const)
    : ({ offset: [10, down], anchor: "start" } as const);

export default defineFigure<Input, Output>({
  title: "Does the ray hit the ball?",
  view: { kind: "2d", x: [-5, 5], y: [-3.2, 3.2], grid: 1 },
  aspect: 1.35,
  initial: {
    origin: [-4, -1.25],
    through: [-2.5, -0.75],
    centre: [1, 0],
    radius: 1.75,
    far: 0,
    direction: 0,
    method: 1,
    single: 0,
  },
  handles: [
    {
      kind: "slide",
      field: "radius",
      label: "r, radius of the ball",
      role: "ball",
      at: ({ centre, radius }) => [centre[0], centre[1] + radius],
      along: () => [0, 1],
      step: 0.25,
      limit: [0.25, 3],
    },
    {
      kind: "point",
      field: "centre",
      label: "c, centre of the ball",
      role: "ball",
      step: 0.25,
      limit: [-4, 4],
    },
    {
      kind: "point",
      field: "through",
      label: "q, a point of the ray",
      role: "ray",
      step: 0.25,
      limit: [-4.5, 4.5],
    },
    {
      kind: "point",
      field: "origin",
      label: "o, start of the ray",
      role: "ray",
      step: 0.25,
      limit: [-4.5, 4.5],
    },
  ],
  controls: [
    {
      kind: "slider",
      field: "far",
      label: "k, start 10ᵏ m back",
      min: 0,
      max: 12,
      step: 0.25,
      play: 8,
    },
    {
      kind: "choice",
      field: "method",
      label: "Method",
      options: [
        { value: 1, label: "the lecture’s: D a unit vector" },
        { value: 2, label: "the textbook’s: A, B, C" },
        { value: 3, label: "nearest point of the line" },
        { value: 0, label: "the book’s: exact decision" },
      ],
    },
    {
      kind: "choice",
      field: "direction",
      label: "D",
      options: [
        { value: 0, label: "a unit vector" },
        { value: 1, label: "from o to q" },
        { value: 2, label: "from o to q, and no farther" },
      ],
    },
    floatOrDouble,
    { kind: "numbers", field: "radius", label: "r", step: 0.25, unit: "m" },
    { kind: "numbers", field: "origin", label: "o", role: "ray", step: 0.25 },
    { kind: "numbers", field: "through", label: "q", role: "ray", step: 0.25 },
    { kind: "numbers", field: "centre", label: "c", role: "ball", step: 0.25 },
  ],
  draw(scene, input, output) {
    const { origin, through, centre, radius, method } = input;
    scene.ball(centre, radius, { role: "ball", fill: 0.16 });
    scene.label(centre, "c", { role: "ball", offset: [0, 26], anchor: "middle" });
    scene.label(through, "q", { role: "ray", offset: [0, -18], anchor: "middle" });
    scene.label(origin, "o", { role: "ray", offset: [0, 27], anchor: "middle" });
    if (output.problem) return;

    for (const [i, finds] of output.ray_finds.entries()) {
      const wrong = output.ray_wrong[i] === 1;
      if (finds) {
        const role: Role = wrong ? "miss" : "surface";
        scene.dot(at(output.ray_entry, i), role, 2.6).dot(at(output.ray_exit, i), role, 2.6);
      } else if (wrong) scene.dot(at(output.ray_entry, i), "miss", 3.2, true);
    }

    const start = output.moved ? output.drawn_from : origin;
    const end = input.direction === 2 ? through : output.drawn_to;
    scene.line(output.drawn_from, output.drawn_to, { role: "ray", width: 1, dashed: true });
    scene.line(start, end, { role: "ray", width: 3 });

    const wrong = output.wrong[method] === 1;
    const role: Role = wrong || off(output, method) ? "miss" : "hit";
    if (output.finds[method]) {
      const entry = at(output.entry_at, method);
      const exit = at(output.exit_at, method);
      const label = (t = 0, past = 0): string =>
        output.moved ? `${pretty(past)} m` : `t = ${pretty(t)}`;
      scene.dot(exit, role, 5, true).dot(entry, role, 6, (output.entry[method] ?? 0) < 0);
      const left = entry[0] <= exit[0];
      const enters = label(output.entry[method], output.entry_past[method]);
      const leaves = label(output.exit[method], output.exit_past[method]);
      if (seen(entry)) scene.label(entry, enters, { role, ...beside(entry, left, -16) });
      if (seen(exit)) scene.label(exit, leaves, { role, ...beside(exit, !left, 20) });
    }
    if (output.moved)
      scene.label([0, -3], `the start is ${metres(output.moved)} behind o`, {
        role: "ray",
        anchor: "middle",
        size: "small",
      });
    if (output.inside) scene.dot(output.point, "hit", 13, true);
    if (wrong) {
      const words = output.says[method] ? "hit, where there is none" : "no hit, where there is one";
      scene.label([0, 2.85], words, { role: "miss", anchor: "middle" });
    } else if (output.finds[method] && off(output, method)) {
      const words = `the entry is off by ${metres(output.off[method])}`;
      scene.label([0, 2.85], words, { role: "miss", anchor: "middle" });
    }
    if (output.hit && !output.inside) {
      const tip = ahead(output.point, output.normal, 0.8);
      scene.arrow(output.point, tip, { role: "normal", width: 2 });
      scene.label(tip, "n", { role: "normal", offset: [-6, 14], anchor: "middle" });
    }
  },
  values(input, output) {
    const { method } = input;
    const judged = (name: string, i: number): Value => {
      const found = output.says[i] ? "hit" : "miss";
      const error = off(output, i) ? `, off by ${metres(output.off[i])}` : "";
      return {
        name,
        meaning: output.finds[i] ? roots(output, i) : "no roots",
        value: output.wrong[i] ? `${found}, wrong` : `${found}${error}`,
        role: output.wrong[i] || off(output, i) ? "miss" : "hit",
      };
    };
    const { rays_wrong: missed } = output;
    return [
      ...METHODS.map(judged),
      { name: "first", meaning: FIRST[method] ?? "", value: output.square },
      { name: "second", meaning: SECOND[method] ?? "", value: output.compared },
      {
        name: "difference",
        meaning: "no hit if negative",
        value: output.difference,
        role: output.difference < 0 ? "miss" : "ink",
      },
      {
        name: "outline",
        meaning: `of ${output.ray_finds.length} parallel rays, decided wrongly`,
        value: missed,
        role: missed ? "miss" : "ink",
      },
      {
        name: "entry",
        meaning: "of the other rays, off by at most",
        value: metres(output.rays_off),
        role: output.rays_off >= VISIBLE ? "miss" : "ink",
      },
    ];
  },
  describe(input, output) {
    const far = output.moved ? `, moved back by ${metres(output.moved)},` : "";
    const part = input.direction === 2 ? "segment" : "ray";
    const found = output.hit
      ? output.inside
        ? `the ${part}${far} starts inside`
        : `the ${part}${far} hits it at t = ${pretty(output.t)}`
      : `the ${part}${far} does not hit it`;
    const wrong = METHODS.filter((_, i) => output.wrong[i] || off(output, i));
    const others = wrong.length ? `Wrong here: ${wrong.join(", ")}.` : "All methods agree.";
    const outline = `Of ${output.ray_finds.length} parallel rays the chosen method decides ${output.rays_wrong} wrongly; the entries of the others are off by up to ${metres(output.rays_off)}.`;
    return `The line ${MEETS[output.meets]}, and ${found}. ${others} ${outline}`;
  },
});
