// Three discs on an air table. First only the path to the first touch is shown; the reader predicts
// where B will reach a cushion, and then sees the rest.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  centre_a: Vec2;
  centre_b: Vec2;
  centre_c: Vec2;
  velocity_a: Vec2;
  guess: Vec2;
  time: number;
  restitution: number;
  step: number;
  show: number;
}

interface Output {
  side: number;
  radius: number;
  duration: number;
  shown: number;
  times: readonly number[];
  path_a: readonly number[];
  path_b: readonly number[];
  path_c: readonly number[];
  events: number;
  first_touch: number;
  touches: number;
  now_a: Vec2;
  now_b: Vec2;
  now_c: Vec2;
  touch_a: Vec2;
  touch_b: Vec2;
  energy: number;
  momentum_x: number;
  momentum_y: number;
  steps_a: readonly number[];
  steps_b: readonly number[];
  steps_c: readonly number[];
  stepped: number;
  cushion_time: number;
  b_at_cushion: Vec2;
  guessed: number;
}

/** The points of a path that comes as x, y, x, y. */
function points(flat: readonly number[]): Vec2[] {
  return Array.from(
    { length: flat.length / 2 },
    (_, i): Vec2 => [flat[2 * i] ?? Number.NaN, flat[2 * i + 1] ?? Number.NaN],
  );
}

export default defineFigure<Input, Output>({
  title: "A table without friction",
  view: { kind: "2d", x: [-0.12, 1.72], y: [-0.12, 1.72] },
  aspect: 1.05,
  initial: {
    centre_a: [0.25, 0.4],
    centre_b: [0.9, 0.65],
    centre_c: [1.25, 1.3],
    velocity_a: [0.9, 0.2],
    guess: [1.2, 0.9],
    time: 0.3,
    restitution: 1,
    step: 0,
    show: 0,
  },
  handles: [
    {
      kind: "point",
      field: "velocity_a",
      from: "centre_a",
      label: "v_A, velocity of A, m/s",
      role: "ray",
      step: 0.05,
      limit: [-1.5, 1.5],
    },
    {
      kind: "point",
      field: "guess",
      label: "your guess: the centre of B when it first reaches a cushion",
      role: "c",
      step: 0.02,
      limit: [0, 1.6],
    },
    {
      kind: "point",
      field: "centre_a",
      label: "centre of A",
      role: "a",
      step: 0.05,
      limit: [0.1, 1.5],
    },
    {
      kind: "point",
      field: "centre_b",
      label: "centre of B",
      role: "b",
      step: 0.05,
      limit: [0.1, 1.5],
    },
    {
      kind: "point",
      field: "centre_c",
      label: "centre of the third disc",
      role: "surface",
      step: 0.05,
      limit: [0.1, 1.5],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "show",
      label: "show",
      options: [
        { value: 0, label: "until two discs touch" },
        { value: 1, label: "the rest" },
      ],
    },
    {
      kind: "slider",
      field: "time",
      label: "t",
      min: 0,
      max: 3,
      step: 0.01,
      unit: "s",
      play: 4,
    },
    { kind: "slider", field: "restitution", label: "e", min: 0, max: 1, step: 0.05 },
    {
      kind: "choice",
      field: "step",
      label: "compare with",
      options: [
        { value: 0, label: "nothing" },
        { value: 0.02, label: "steps of 0.02 s" },
        { value: 0.05, label: "steps of 0.05 s" },
        { value: 0.15, label: "steps of 0.15 s" },
      ],
    },
  ],
  draw(scene, input, output) {
    const { centre_a, centre_b, centre_c, velocity_a, guess } = input;
    if (output.problem) {
      scene.dot(centre_a, "a").dot(centre_b, "b").dot(centre_c, "surface");
      return;
    }
    const s = output.side;
    scene.face(
      [
        [0, 0],
        [s, 0],
        [s, s],
        [0, s],
      ],
      { role: "surface", fill: 0.07 },
    );
    if (output.stepped) {
      for (const [steps, role] of [
        [output.steps_a, "a"],
        [output.steps_b, "b"],
        [output.steps_c, "surface"],
      ] as const) {
        const way = points(steps);
        scene.path(way, { role, width: 1, dashed: true });
        const last = way.at(-1);
        if (last) scene.ball(last, output.radius, { role: "miss", fill: 0.03, dashed: true });
      }
    }
    const discs: [readonly number[], Vec2, Vec2, Role, string][] = [
      [output.path_a, centre_a, output.now_a, "a", "A"],
      [output.path_b, centre_b, output.now_b, "b", "B"],
      [output.path_c, centre_c, output.now_c, "surface", ""],
    ];
    for (const [path, start, now, role, name] of discs) {
      const way = points(path);
      scene.path(way, { role, width: 2 });
      for (const position of way.slice(1, output.events + 1)) scene.dot(position, role, 3);
      scene.ball(start, output.radius, { role, fill: 0.1, dashed: true });
      scene.ball(now, output.radius, { role, fill: 0.35 });
      scene.label(now, name, { role, offset: [0, 44], anchor: "middle" });
    }
    if (output.touches) {
      scene.ball(output.touch_a, output.radius, { role: "hit", fill: 0.05 });
      scene.line(output.touch_a, output.touch_b, { role: "normal", width: 1.5, dashed: true });
    }
    const tip: Vec2 = [centre_a[0] + velocity_a[0], centre_a[1] + velocity_a[1]];
    scene.arrow(centre_a, tip, { role: "ray", width: 2.5 });
    scene.label(tip, "v_A", { role: "ray", offset: [10, -8] });
    scene.ball(guess, output.radius, {
      role: output.guessed ? "hit" : "c",
      fill: 0.06,
      dashed: true,
    });
    scene.label(guess, "B?", {
      role: output.guessed ? "hit" : "c",
      offset: [0, -34],
      anchor: "middle",
    });
    if (output.cushion_time > 0) {
      scene.ball(output.b_at_cushion, output.radius, { role: "hit", fill: 0 });
    }
  },
  values: (_input, output) => [
    {
      name: "t_1",
      meaning: "first touch of two discs",
      value: output.touches ? output.first_touch : "none",
      ...(output.touches ? { unit: "s" } : {}),
      role: "hit",
    },
    { name: "events", meaning: "shown, cushions too", value: output.events },
    { name: "K", meaning: "kinetic energy, 1 kg each", value: output.energy, unit: "J" },
    {
      name: "p",
      meaning: "of all",
      value: [output.momentum_x, output.momentum_y],
      unit: "kg·m/s",
    },
    {
      name: "t_B",
      meaning: "B reaches a cushion",
      value: output.cushion_time > 0 ? output.cushion_time : "not shown",
      ...(output.cushion_time > 0 ? { unit: "s" } : {}),
      role: "b",
    },
  ],
  describe(input, output) {
    if (!output.touches) return "A meets no other disc in these three seconds.";
    const first = `Two discs touch after ${pretty(output.first_touch, 3)} s.`;
    if (!input.show) return `${first} The rest is hidden: mark where B will first reach a cushion.`;
    if (!(output.cushion_time > 0)) return `${first} B reaches no cushion in this time.`;
    return `${first} B reaches a cushion after ${pretty(output.cushion_time, 3)} s, ${output.guessed ? "where you predicted" : "but not where you predicted"}.`;
  },
});
