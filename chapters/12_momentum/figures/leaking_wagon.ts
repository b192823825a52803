// A wagon that loses sand or collects rain. Above: its velocity against time, by two laws. Below: a
// wagon for each law, on its own track.

import { defineFigure, pretty, type Role, type Scene, type Vec2 } from "@contact/figure";

interface Input {
  velocity: number;
  rate: number;
  apart: number;
  force: number;
  rains: number;
  time: number;
}

interface Output {
  moment: readonly number[];
  velocity: readonly number[];
  alone: readonly number[];
  mass: number;
  relative: number;
  velocity_now: number;
  alone_now: number;
  position: number;
  position_alone: number;
  thrust: number;
  p_given: number;
  p_all: number;
  p_all_alone: number;
  agree: number;
}

/** How high 1 m/s is and how far 1 m; where the two tracks lie; between what velocities it draws. */
const HIGH = 0.5;
const FAR = 1 / 6;
const TRACKS = [-2.35, -3.75] as const;
const LEAST = -2;
const MOST = 10;
const END = 10.3;
const at = (t: number, v: number): Vec2 => [t, HIGH * v];
const seen = (position: number): boolean => FAR * position >= -0.5 && FAR * position <= 10.4;
const drawn = (v: number): boolean => v >= LEAST && v <= MOST;

export default defineFigure<Input, Output>({
  title: "A wagon of variable mass",
  view: { kind: "2d", x: [-0.9, 10.9], y: [-4.3, 5.4] },
  aspect: 1.2,
  initial: { velocity: 3, rate: 200, apart: 0, force: 0, rains: 0, time: 6 },
  handles: [
    {
      kind: "slide",
      field: "velocity",
      label: "v, initial velocity, m/s",
      role: "ball",
      at: (input): Vec2 => at(0, input.velocity),
      along: (): Vec2 => [0, HIGH],
      step: 0.1,
      limit: [-1, 6],
    },
    {
      kind: "slide",
      field: "time",
      label: "t, time of the reading, s",
      role: "muted",
      at: (input): Vec2 => at(input.time, 0),
      along: (): Vec2 => [1, 0],
      step: 0.1,
      limit: [0, 10],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "rains",
      label: "the wagon",
      options: [
        { value: 0, label: "loses sand" },
        { value: 1, label: "collects rain" },
      ],
    },
    { kind: "slider", field: "rate", label: "rate", min: 0, max: 300, step: 10, unit: "kg/s" },
    {
      kind: "slider",
      field: "apart",
      label: "u, of sand",
      min: -5,
      max: 5,
      step: 0.1,
      unit: "m/s",
    },
    { kind: "slider", field: "force", label: "F", min: -1000, max: 1000, step: 50, unit: "N" },
    { kind: "slider", field: "time", label: "t", min: 0, max: 10, step: 0.1, unit: "s", play: 5 },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow(at(0, 0), at(END, 0), axis).arrow(at(0, LEAST), at(0, MOST), axis);
    scene.label(at(0, MOST), "velocity, m/s", { role: "muted", offset: [10, 4] });
    scene.label(at(END, 0), "t, s", { role: "muted", offset: [0, 32], anchor: "end" });
    for (const t of [2, 4, 6, 8, 10]) {
      scene.line([t, -0.06], [t, 0.06], axis);
      scene.label([t, 0], pretty(t), {
        role: "muted",
        offset: [0, 18],
        anchor: "middle",
        size: "small",
      });
    }
    for (const v of [2, 4, 6, 8]) {
      scene.line([-0.06, HIGH * v], [0.06, HIGH * v], axis);
      scene.label(at(0, v), pretty(v), {
        role: "muted",
        offset: [-9, 4],
        anchor: "end",
        size: "small",
      });
    }
    for (const y of TRACKS) scene.line([-0.8, y], [10.8, y], { role: "surface", width: 2 });
    if (output.problem) return;

    scene.line(at(input.time, LEAST), at(input.time, MOST), {
      role: "muted",
      width: 1,
      dashed: true,
    });
    for (const [velocities, now, role, dashed, law, high] of [
      [output.alone, output.alone_now, "miss", true, "d(mv)/dt = F", 7.7],
      [output.velocity, output.velocity_now, "hit", false, "m dv/dt = F + u dm/dt", 8.7],
    ] as const) {
      const curve = velocities
        .map((v, i): Vec2 => [output.moment[i] ?? 0, v])
        .filter(([, v]) => drawn(v))
        .map(([t, v]) => at(t, v));
      scene.path(curve, { role, width: 2.5, dashed });
      if (drawn(now)) scene.dot(at(input.time, now), role, 5, dashed);
      scene.line(at(0.4, high), at(1, high), { role, width: 2.5, dashed });
      scene.label(at(1, high), law, { role, offset: [6, 4], size: "small" });
    }

    for (const [position, track, role] of [
      [output.position, TRACKS[0], "hit"],
      [output.position_alone, TRACKS[1], "miss"],
    ] as const) {
      if (seen(position)) {
        wagon(scene, [FAR * position, track], output.mass, role, role === "miss");
        continue;
      }
      // It has left the picture.
      const back = position < 0;
      const where = `${pretty(position, 3)} m`;
      scene.label([back ? -0.7 : 10.7, track], back ? `← ${where}` : `${where} →`, {
        role,
        offset: [0, -8],
        anchor: back ? "start" : "end",
      });
    }
    if (input.rains || input.rate === 0 || Math.abs(output.relative) < 0.05) return;
    if (!seen(output.position)) return;
    const hole: Vec2 = [FAR * output.position, TRACKS[0] - 0.25];
    const tip: Vec2 = [hole[0] + 0.4 * output.relative, hole[1]];
    scene.arrow(hole, tip, { role: "b", width: 2.5 });
    scene.label(tip, "u", {
      role: "b",
      offset: [output.relative < 0 ? -8 : 8, 5],
      anchor: output.relative < 0 ? "end" : "start",
    });
  },
  values: (_input, output) => [
    { name: "m", meaning: "of the wagon at t", value: output.mass, unit: "kg" },
    { name: "u dm/dt", meaning: "thrust", value: output.thrust, unit: "N", role: "b" },
    {
      name: "v",
      meaning: "m dv/dt = F + u dm/dt",
      value: output.velocity_now,
      unit: "m/s",
      role: "hit",
    },
    {
      name: "v",
      meaning: "d(mv)/dt = F: wrong",
      value: output.alone_now,
      unit: "m/s",
      role: "miss",
    },
    { name: "p", meaning: "initial, plus F t", value: output.p_given, unit: "kg·m/s" },
    {
      name: "p",
      meaning: "of wagon and sand, or rain",
      value: output.p_all,
      unit: "kg·m/s",
      role: "hit",
    },
    {
      name: "p",
      meaning: "of both, by d(mv)/dt = F",
      value: output.p_all_alone,
      unit: "kg·m/s",
      role: "miss",
    },
  ],
  describe(input, output) {
    const start = `After ${pretty(input.time, 2)} s the wagon weighs ${pretty(output.mass, 4)} kg and rolls at ${pretty(output.velocity_now, 3)} m/s`;
    if (output.agree) return `${start}, by either law.`;
    return `${start}; by d(mv)/dt = F it would roll at ${pretty(output.alone_now, 3)} m/s.`;
  },
});

/** A wagon with its load, as high as it is heavy; its middle is over the point of the track. */
function wagon(scene: Scene, [x, y]: Vec2, mass: number, role: Role, dashed: boolean): void {
  const load = 0.12 + Math.min(9000, mass) / 6000;
  scene.face(
    [
      [x - 0.6, y + 0.2],
      [x + 0.6, y + 0.2],
      [x + 0.6, y + 0.2 + load],
      [x - 0.6, y + 0.2 + load],
    ],
    { role, fill: dashed ? 0.08 : 0.3, dashed },
  );
  for (const side of [-0.35, 0.35]) scene.ball([x + side, y + 0.13], 0.13, { role, fill: 0.3 });
}
