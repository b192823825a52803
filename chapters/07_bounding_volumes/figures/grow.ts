// Eight points and three circles around them: the lecture's, which takes in one point after the
// other, the circle around the centroid, and the smallest one.

import {
  defineFigure,
  floatOrDouble,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
} from "@contact/figure";

interface Input {
  p0: Vec2;
  p1: Vec2;
  p2: Vec2;
  p3: Vec2;
  p4: Vec2;
  p5: Vec2;
  p6: Vec2;
  p7: Vec2;
  taken: number;
  order: number;
  single: number;
}

interface Output {
  low: number;
  high: number;
  order: readonly number[];
  start_radius: number;
  start_centre: Vec2;
  radius: number;
  centre: Vec2;
  grew: number;
  radius_before: number;
  centre_before: Vec2;
  grown_radius: number;
  missed: readonly number[];
  outside: readonly number[];
  missed_count: number;
  missed_most: number;
  centroid_radius: number;
  smallest_radius: number;
  centroid: Vec2;
  smallest_centre: Vec2;
  support_count: number;
  support: readonly number[];
  grown_ratio: number;
  centroid_ratio: number;
  min_ratio: number;
  greatest_ratio: number;
}

const NAMES = ["p0", "p1", "p2", "p3", "p4", "p5", "p6", "p7"] as const;
const ORDERS = ["as numbered", "reversed", "the best", "the worst"];
/**
 * Dragged points move in tenths of this, in eighths of a metre, which are stored without rounding.
 */
const GRIP_STEP = 1.25;

const times = (ratio: number): string => `${ratio.toFixed(3)}\u00a0×`;
const taken = (input: Input): number =>
  Math.min(NAMES.length, Math.max(0, Math.floor(input.taken)));

function circle(scene: Scene, centre: Vec2, radius: number, role: Role, dashed = false): void {
  scene.ball(centre, radius, { role, fill: dashed ? 0 : 0.07, dashed });
  scene.dot(centre, role, 3, dashed);
}

export default defineFigure<Input, Output>({
  title: "A circle that takes in one point after the other",
  view: { kind: "2d", x: [-4.5, 4.5], y: [-3.6, 3.6] },
  aspect: 1.2,
  initial: {
    p0: [1.5, 1.75],
    p1: [-2.5, 1.25],
    p2: [-1.75, -1.75],
    p3: [1.25, -2.25],
    p4: [-2.5, 0.25],
    p5: [-2, 0.75],
    p6: [-1.5, 1.75],
    p7: [-2, -1],
    taken: 3,
    order: 0,
    single: 1,
  },
  handles: NAMES.map((field, i) => ({
    kind: "point" as const,
    field,
    label: `point ${i}`,
    role: "ray" as const,
    step: GRIP_STEP,
    limit: [-3.25, 3.25] as const,
  })),
  controls: [
    { kind: "slider", field: "taken", label: "points taken in", min: 0, max: 8, step: 1, play: 8 },
    {
      kind: "states",
      label: "Order of the points",
      options: ORDERS.map((label, order) => ({ label, fields: { order } })),
    },
    floatOrDouble,
    ...NAMES.map((field, i) => ({
      kind: "numbers" as const,
      field,
      label: `p_${i}`,
      role: "ray" as const,
      step: 0.125,
    })),
  ],
  draw(scene, input, output) {
    const points = NAMES.map((name) => input[name]);
    const so_far = output.problem ? [] : output.order.slice(0, taken(input));
    for (const [i, p] of points.entries())
      scene.label(p, String(i), { role: so_far.includes(i) ? "a" : "muted", offset: [11, -11] });
    if (output.problem) return;
    const at = (i: number | undefined): Vec2 => points[i ?? 0] ?? [0, 0];

    circle(scene, output.centroid, output.centroid_radius, "b", true);
    circle(scene, output.smallest_centre, output.smallest_radius, "c");
    if (output.grew) circle(scene, output.centre_before, output.radius_before, "a", true);
    circle(scene, output.centre, output.radius, "a");
    for (const i of output.support.slice(0, output.support_count)) scene.dot(at(i), "c", 14, true);
    scene.line(at(output.low), at(output.high), { role: "a", width: 1, dashed: true });
    const last = so_far.at(-1);
    if (last !== undefined && output.grew)
      scene.arrow(output.centre_before, output.centre, { role: "a", width: 2 });

    for (const [i, p] of points.entries()) {
      if (!output.missed[i]) continue;
      scene.dot(p, "miss", 17, true);
      scene.label(p, "outside", { role: "miss", offset: [0, 33], anchor: "middle", size: "small" });
    }
    const small = { size: "small", anchor: "middle" } as const;
    const on = ([x, y]: Vec2, dx: number, dy: number): Vec2 => [x + dx, y + dy];
    scene
      .label(on(output.centre, 0, output.radius), "lecture", {
        ...small,
        role: "a",
        offset: [0, 16],
      })
      .label(on(output.smallest_centre, 0, -output.smallest_radius), "smallest", {
        ...small,
        role: "c",
        offset: [0, -8],
      })
      .label(on(output.centroid, -output.centroid_radius, 0), "centroid", {
        ...small,
        role: "b",
        anchor: "start",
        offset: [5, 0],
      });
  },
  values: (input, output) => [
    {
      name: "lecture",
      meaning: `radius after ${taken(input)} of 8 points`,
      value: output.radius,
      unit: "m",
      role: "a",
    },
    {
      name: "grown",
      meaning: "radius after all, against the smallest",
      value: `${pretty(output.grown_radius)} m, ${times(output.grown_ratio)}`,
      role: "a",
    },
    {
      name: "orders",
      meaning: "the best and the worst of 720",
      value: `${times(output.min_ratio)} to ${times(output.greatest_ratio)}`,
      role: "a",
    },
    {
      name: "centroid",
      meaning: "radius, against the smallest",
      value: `${pretty(output.centroid_radius)} m, ${times(output.centroid_ratio)}`,
      role: "b",
    },
    {
      name: "smallest",
      meaning: `radius, by ${output.support_count} points`,
      value: output.smallest_radius,
      unit: "m",
      role: "c",
    },
    missed(output),
  ],
  describe(input, output) {
    const order = output.order.join(", ");
    const by = output.support.slice(0, output.support_count).join(", ");
    const lost = output.missed_count
      ? ` Rounded, it misses ${output.missed_count} of the points that it has taken in.`
      : "";
    return `The lecture’s circle starts from points ${output.low} and ${
      output.high
    }, and has taken in the first ${taken(input)} of ${order}: radius ${pretty(
      output.radius,
    )} m.${lost} The smallest circle, by points ${by}, has ${pretty(output.smallest_radius)} m.`;
  },
});

function missed(output: Output): Value {
  return {
    name: "missed",
    meaning: "points taken in but outside, and the largest distance",
    value: output.missed_count
      ? `${output.missed_count}, ${pretty(output.missed_most, 3)} m`
      : "none",
    role: output.missed_count ? "miss" : "ink",
  };
}
