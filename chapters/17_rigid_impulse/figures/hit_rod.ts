// A rod on ice, seen from above, and the ball that hits it. The arrows are the velocities of its
// points just after the hit; the outline is the rod at the chosen time.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  at: number;
  rod: number;
  ball: number;
  speed: number;
  e: number;
  time: number;
  half: number;
  way: number;
}

interface Output {
  impulse: number;
  without_turning: number;
  velocity: number;
  angular_velocity: number;
  ball_velocity: number;
  along: readonly number[];
  grip: number;
  still: number;
  lost: number;
  ratio: number;
  middle: Vec2;
  left: Vec2;
  right: Vec2;
  ball_position: number;
}

/** How many metres long an arrow of 1 m/s is. */
const PER_SPEED = 0.3;

export default defineFigure<Input, Output>({
  title: "Where to hit a rod",
  view: { kind: "2d", x: [-2.1, 2.1], y: [-1.1, 1.6] },
  aspect: 1.3,
  initial: { at: 0.7, rod: 3, ball: 1, speed: 4, e: 0.5, time: 0.4, half: 1, way: 0 },
  handles: [
    {
      kind: "slide",
      field: "at",
      label: "x, where the ball hits, from the middle, m",
      role: "ball",
      at: (input): Vec2 => [input.at, -0.1],
      along: (): Vec2 => [1, 0],
      step: 0.01,
      limit: [-1.6, 1.6],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "way",
      label: "impulse",
      options: [
        { value: 0, label: "by the book" },
        { value: 1, label: "without rotation" },
      ],
    },
    { kind: "slider", field: "at", label: "x", min: -1.6, max: 1.6, step: 0.01, unit: "m" },
    { kind: "slider", field: "rod", label: "m_rod", min: 0.5, max: 9, step: 0.1, unit: "kg" },
    { kind: "slider", field: "ball", label: "m_ball", min: 0.1, max: 9, step: 0.1, unit: "kg" },
    {
      kind: "slider",
      field: "half",
      label: "L/2",
      min: 0.5,
      max: 1.6,
      step: 0.05,
      unit: "m",
    },
    { kind: "slider", field: "e", label: "e", min: 0, max: 1, step: 0.05 },
    {
      kind: "slider",
      field: "time",
      label: "t",
      min: -0.3,
      max: 1,
      step: 0.01,
      unit: "s",
      play: 4,
    },
  ],
  draw(scene, input, output) {
    scene.line([-input.half, 0], [input.half, 0], { role: "surface", width: 7 });
    scene.dot([0, 0], "ink", 4, true);
    scene.label([-input.half, 0], "grip", { role: "muted", offset: [-10, 5], anchor: "end" });
    if (output.problem) return;
    const r = 0.1;
    scene.ball([input.at, output.ball_position], r, { role: "ball", fill: 0.35 });
    scene.ball([input.at, -r], r, { role: "ball", dashed: true, fill: 0 });
    const tips: Vec2[] = [];
    for (const [k, v] of output.along.entries()) {
      const x = (k / 2 - 1) * input.half;
      const tip: Vec2 = [x, v * PER_SPEED];
      tips.push(tip);
      if (Math.abs(v) * PER_SPEED > 0.02) scene.arrow([x, 0], tip, { role: "a", width: 2 });
    }
    scene.path(tips, { role: "a", width: 1, dashed: true });
    scene.line(output.left, output.right, { role: "b", width: 3, dashed: true });
    scene.dot(output.middle, "b", 4);
    scene.dot(output.left, "b", 3, true);
    if (output.lost < -1e-9) scene.label([-2, 1.45], "gains energy", { role: "miss" });
    if (Math.abs(output.still) <= 1.8) {
      scene.dot([output.still, 0], "hit", 6, true);
      scene.label([output.still, 0], "at rest", {
        role: "hit",
        offset: [0, -14],
        anchor: "middle",
      });
    }
  },
  values: (input, output) => [
    { name: "j", meaning: "impulse", value: output.impulse, unit: "N·s" },
    {
      name: "j",
      meaning: "if the rod could not rotate",
      value: output.without_turning,
      unit: "N·s",
      role: "muted",
    },
    { name: "v", meaning: "of the rod’s middle", value: output.velocity, unit: "m/s", role: "b" },
    { name: "ω", meaning: "of the rod", value: output.angular_velocity, unit: "rad/s", role: "b" },
    { name: "v_grip", meaning: "of the left end", value: output.grip, unit: "m/s", role: "a" },
    {
      name: "v_ball",
      meaning: "of the ball afterwards",
      value: output.ball_velocity,
      unit: "m/s",
      role: "ball",
    },
    {
      name: "x_0",
      meaning: "the point that stays at rest",
      value: output.still,
      unit: "m",
      role: "hit",
    },
    {
      name: "−v_n′/v_n",
      meaning: "should be e",
      value: output.ratio,
      role: input.way === 1 ? "miss" : "ink",
    },
    { name: "lost", meaning: "share of the kinetic energy", value: output.lost },
  ],
  describe(input, output) {
    const where = Math.abs(output.still) <= input.half ? "lies on the rod" : "lies beyond the rod";
    const energy = output.lost < -1e-9 ? " The collision creates energy." : "";
    return `The ball hits ${pretty(input.at, 2)} m from the middle: the middle leaves at ${pretty(output.velocity, 3)} m/s, the grip at ${pretty(output.grip, 3)} m/s, and the point that stays at rest ${where}.${energy}`;
  },
});
