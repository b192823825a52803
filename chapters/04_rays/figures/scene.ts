// Seven bodies, and what a ray meets of them in order; or a bullet, sampled once a frame or asked by
// the segment of its path.

import { defineFigure, pretty, type Role, type Value, type Vec2 } from "@contact/figure";

interface Input {
  origin: Vec2;
  through: Vec2;
  ball: Vec2;
  box: Vec2;
  thickness: number;
  speed: number;
  radius: number;
  test: number;
}

interface Output {
  wall: readonly number[];
  box_outline: readonly number[];
  ball_radius: number;
  cylinder: Vec2;
  cylinder_radius: number;
  capsule: readonly number[];
  capsule_radius: number;
  cone: readonly number[];
  triangle: readonly number[];
  hits: number;
  body: readonly number[];
  t: readonly number[];
  at: readonly number[];
  normal: readonly number[];
  inside: number;
  frames: number;
  sample: readonly number[];
  path_end: Vec2;
  met: readonly number[];
  met_body: readonly number[];
  met_frame: readonly number[];
  met_at: readonly number[];
  skipped: number;
  line_meets_wall: number;
  ball_meets_wall: number;
  enlarged_meets_wall: number;
  ball_at: Vec2;
}

const BODIES = ["wall", "ball", "box", "cylinder", "capsule", "cone", "triangle"];
const FAR = 14;

const point = (numbers: readonly number[], i: number): Vec2 => [
  numbers[2 * i] ?? 0,
  numbers[2 * i + 1] ?? 0,
];
const points = (numbers: readonly number[]): Vec2[] =>
  Array.from({ length: numbers.length / 2 }, (_, i) => point(numbers, i));
const ahead = (from: Vec2, by: Vec2, factor: number): Vec2 => [
  from[0] + by[0] * factor,
  from[1] + by[1] * factor,
];
const middle = (corners: readonly Vec2[]): Vec2 => [
  corners.reduce((sum, [x]) => sum + x, 0) / corners.length,
  corners.reduce((sum, [, y]) => sum + y, 0) / corners.length,
];
/** The outline of a capsule, for drawing. */
const capsule = (from: Vec2, to: Vec2, radius: number): Vec2[] => {
  const start = Math.atan2(to[1] - from[1], to[0] - from[0]) - Math.PI / 2;
  return Array.from({ length: 34 }, (_, i): Vec2 => {
    const angle = start + ((i % 17) * Math.PI) / 16 + (i < 17 ? 0 : Math.PI);
    const [x, y] = i < 17 ? to : from;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
};
const name = (body = 0): string => BODIES[body] ?? "";
/** What the bullet meets first by samples (0) or by segments (1). */
const found = (output: Output, by: number): string =>
  output.met[by] ? `${name(output.met_body[by])}, frame ${output.met_frame[by]}` : "nothing";

export default defineFigure<Input, Output>({
  title: "What is hit first?",
  view: { kind: "2d", x: [-5, 5], y: [-3.2, 3.2] },
  aspect: 1.35,
  initial: {
    origin: [-4.25, -0.25],
    through: [-2, -0.25],
    ball: [3.6, -0.25],
    box: [-0.75, 1.9],
    thickness: 0.25,
    speed: 1.5,
    radius: 0.15,
    test: 1,
  },
  handles: [
    {
      kind: "point",
      field: "ball",
      label: "centre of the ball",
      role: "ball",
      step: 0.25,
      limit: [-4.5, 4.5],
    },
    {
      kind: "point",
      field: "box",
      label: "centre of the box",
      role: "surface",
      step: 0.25,
      limit: [-4.5, 4.5],
    },
    {
      kind: "point",
      field: "through",
      label: "q, a point ahead",
      role: "ray",
      step: 0.25,
      limit: [-4.75, 4.75],
    },
    {
      kind: "point",
      field: "origin",
      label: "o, the start",
      role: "ray",
      step: 0.25,
      limit: [-4.75, 4.75],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "test",
      label: "Test",
      options: [
        { value: 0, label: "a ray, all hits in order" },
        { value: 1, label: "a bullet, once a frame" },
        { value: 2, label: "a bullet, by its path" },
      ],
    },
    {
      kind: "slider",
      field: "speed",
      label: "speed",
      min: 0.2,
      max: 3,
      step: 0.05,
      unit: "m a frame",
    },
    { kind: "slider", field: "thickness", label: "wall", min: 0.05, max: 1, step: 0.05, unit: "m" },
    { kind: "slider", field: "radius", label: "bullet", min: 0, max: 0.5, step: 0.05, unit: "m" },
    { kind: "numbers", field: "origin", label: "o", role: "ray", step: 0.25 },
    { kind: "numbers", field: "through", label: "q", role: "ray", step: 0.25 },
    { kind: "numbers", field: "ball", label: "ball", role: "ball", step: 0.25 },
    { kind: "numbers", field: "box", label: "box", role: "surface", step: 0.25 },
  ],
  draw(scene, input, output) {
    const { origin, through, test } = input;
    scene.label(origin, "o", { role: "ray", offset: [0, -18], anchor: "middle" });
    scene.label(through, "q", { role: "ray", offset: [0, -18], anchor: "middle" });
    if (output.problem) return;

    const first = test === 0 ? (output.hits ? output.body[0] : -1) : -1;
    const met = test > 0 && output.met[test - 1] ? output.met_body[test - 1] : first;
    const missed = test === 1 && output.skipped ? (output.met_body[1] ?? -1) : -1;
    const style = (body: number) => {
      const role: Role = body === missed ? "miss" : body === met ? "hit" : "surface";
      return { role, fill: role === "surface" ? 0.14 : 0.3 };
    };
    const word = (at: Vec2, body: number, down = 4): void => {
      const { role } = style(body);
      scene.label(at, name(body), { role, offset: [0, down], anchor: "middle", size: "small" });
    };
    scene.face(points(output.wall), style(0));
    word([middle(points(output.wall))[0], point(output.wall, 3)[1]], 0, -8);
    scene.ball(input.ball, output.ball_radius, style(1));
    word([input.ball[0], input.ball[1] - output.ball_radius], 1, 15);
    scene.face(points(output.box_outline), style(2));
    word([input.box[0], input.box[1] - 0.85], 2, 8);
    scene.ball(output.cylinder, output.cylinder_radius, style(3));
    word(output.cylinder, 3);
    const [from, to] = [point(output.capsule, 0), point(output.capsule, 1)];
    scene.face(capsule(from, to, output.capsule_radius), style(4));
    word(middle([from, to]), 4);
    scene.face(points(output.cone), style(5));
    word(middle(points(output.cone)), 5, 8);
    scene.line(point(output.triangle, 0), point(output.triangle, 1), {
      role: style(6).role,
      width: 4,
    });
    word(middle(points(output.triangle)), 6, 40);

    if (test === 0) {
      const by: Vec2 = [through[0] - origin[0], through[1] - origin[1]];
      const length = Math.hypot(...by);
      scene.arrow(origin, ahead(origin, by, FAR / length), { role: "ray", width: 2 });
      for (let i = 0; i < output.hits; i++) {
        const at = point(output.at, i);
        scene.dot(at, i === 0 ? "hit" : "muted", i === 0 ? 6 : 4, i > 0);
        scene.label(at, `${i + 1}`, {
          role: i === 0 ? "hit" : "muted",
          offset: [-9, -9],
          anchor: "end",
          size: "small",
        });
      }
      if (output.inside) scene.dot(origin, "hit", 13, true);
      if (output.hits && !output.inside) {
        const at = point(output.at, 0);
        scene.arrow(at, ahead(at, point(output.normal, 0), 0.7), { role: "normal", width: 2 });
      }
      return;
    }

    scene.line(origin, output.path_end, { role: "ray", width: 1, dashed: true });
    const by = test - 1;
    const stop = output.met[by] ? (output.met_frame[by] ?? 0) : output.frames;
    if (test === 2)
      scene.line(origin, output.met[1] ? point(output.met_at, 1) : output.path_end, {
        role: "ray",
        width: 3,
      });
    for (let i = 0; i < stop; i++) {
      const at = point(output.sample, i);
      if (test === 1 && output.met[0] && i === stop - 1) continue;
      if (test === 2 && output.met[1] && i === stop - 1) continue;
      if (input.radius > 0) scene.ball(at, input.radius, { role: "ray", fill: 0.5 });
      scene.dot(at, "ray", 2.5);
    }
    if (output.met[by]) {
      scene.ball(point(output.met_at, by), input.radius, { role: "hit", fill: 0.5 });
      scene.dot(point(output.met_at, by), "hit", 5);
    }
    if (missed >= 0)
      scene.label([0, 2.85], `no frame has the bullet in the ${name(missed)}`, {
        role: "miss",
        anchor: "middle",
      });
    else if (!output.line_meets_wall && output.ball_meets_wall) {
      scene.ball(output.ball_at, input.radius, { role: "miss", fill: 0.3 });
      scene.label([0, 2.85], "the bullet’s rim touches the wall", {
        role: "miss",
        anchor: "middle",
      });
    } else if (output.enlarged_meets_wall && !output.ball_meets_wall)
      scene.label([0, 2.85], "only the enlarged wall is touched", {
        role: "miss",
        anchor: "middle",
      });
  },
  values(_input, output) {
    const order = Array.from({ length: output.hits }, (_, i) => name(output.body[i]));
    const says = (meets: number): string => (meets ? "hit" : "miss");
    const rounded: Role = output.ball_meets_wall === output.line_meets_wall ? "ink" : "miss";
    return [
      {
        name: "t",
        meaning: output.hits
          ? `of the first hit: ${order[0]}${output.inside ? ", started inside" : ""}`
          : "of the first hit",
        value: output.hits ? (output.t[0] ?? 0) : "–",
        role: "hit",
      },
      { name: "order", meaning: "in which the ray meets them", value: order.join(", ") || "–" },
      {
        name: "samples",
        meaning: "once a frame, the bullet meets",
        value: found(output, 0),
        role: output.skipped ? "miss" : "hit",
      },
      {
        name: "path",
        meaning: "on its segments, it meets",
        value: found(output, 1),
        role: "hit",
      },
      { name: "line", meaning: "of the centre, and the wall", value: says(output.line_meets_wall) },
      {
        name: "ball",
        meaning: "of the bullet’s radius, and the wall",
        value: says(output.ball_meets_wall),
        role: rounded,
      },
      {
        name: "enlarged",
        meaning: "wall by this radius, and the line",
        value: says(output.enlarged_meets_wall),
        role: output.enlarged_meets_wall === output.ball_meets_wall ? "ink" : "miss",
      },
    ] satisfies Value[];
  },
  describe(_input, output) {
    const ray = output.hits
      ? `The ray meets ${output.hits === 1 ? "one body" : `${output.hits} bodies`}, first the ${name(output.body[0])} at t = ${pretty(output.t[0] ?? 0)}.`
      : "The ray meets nothing.";
    const path = output.met[1] ? `meets the ${name(output.met_body[1])} first` : "meets nothing";
    const samples = output.met[0] ? `is in the ${name(output.met_body[0])}` : "is in no body";
    return `${ray} The bullet’s path ${path}; sampled once a frame, the bullet ${samples}.`;
  },
});
