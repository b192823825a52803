// Balls in a room, by a method and as they should be, and below the room the largest distance of the
// two, on a logarithmic scale.

import { defineFigure, pretty, type Role, type Vec2 } from "@contact/figure";

interface Input {
  motion: number;
  method: number;
  balls: readonly number[];
  at: number;
}

interface Output {
  count: number;
  room: number;
  seconds: number;
  got: readonly number[];
  right: readonly number[];
  apart: readonly number[];
  read: number;
  hits: number;
  right_hits: number;
  at_the_end: number;
  overlap: number;
  energy_change: number;
}

const METHODS = [
  "steps of 1/60 s",
  "steps of 1/240 s",
  "events, float",
  "events, double",
  "events, all effects on",
  "events, as planned",
] as const;
const MOST = 9;
const RADIUS = 0.25;
/** Samples a second, and how wide the room is in the picture. */
const RATE = 60;
const WIDE = 6;
/** The plot under the room: powers of ten. */
const LOW = -16;
const HIGH = 1;
const TALL = 0.15;
const BASE = -0.5 - (HIGH - LOW) * TALL;
const height = (apart: number): number =>
  BASE + (Math.max(LOW, Math.min(HIGH, Math.log10(apart))) - LOW) * TALL;

/** Balls on a lattice, shifted and with velocities, all by fixed whole numbers. */
const lattice = (): number[] =>
  Array.from({ length: MOST }, (_, i) => {
    const shift = (k: number): number => (((7 * i + 5 * k) % 9) - 4) / 25;
    const speed = (k: number): number => (((5 * i + 4 * k) % 11) - 5) / 2;
    return [0.5 + (i % 3) + shift(0), 0.5 + Math.floor(i / 3) + shift(1), 0, speed(0), speed(1), 0];
  }).flat();

export default defineFigure<Input, Output>({
  title: "Balls by a method, and as they should be",
  view: { kind: "2d", x: [-0.8, 6.3], y: [BASE - 0.5, 6.2] },
  aspect: 0.75,
  initial: { motion: 1, method: 0, balls: lattice(), at: 0.5 },
  handles: [
    {
      kind: "slide",
      field: "at",
      label: "t, the time that is shown, s",
      role: "muted",
      at: (input, output): Vec2 => [(WIDE * input.at) / (output.seconds || 1), BASE],
      along: (_input, output): Vec2 => [WIDE / (output.seconds || 1), 0],
      step: 1 / RATE,
      limit: [0, 1],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "method",
      options: METHODS.map((label, value) => ({ value, label })),
    },
    { kind: "slider", field: "at", label: "t", min: 0, max: 1, step: 1 / RATE, unit: "s", play: 6 },
  ],
  draw(scene, input, output) {
    const line = input.motion === 0;
    const room = output.problem ? 3 : output.room;
    const scale = WIDE / room;
    const middle = WIDE / 2;
    const [low, high] = line ? [middle - scale / 2, middle + scale / 2] : [0, WIDE];
    const corners: readonly Vec2[] = [
      [0, low],
      [WIDE, low],
      [WIDE, high],
      [0, high],
      [0, low],
    ];
    scene.path(corners, { role: "surface", width: 3 });
    scene.line([0, BASE], [WIDE, BASE], { role: "muted", width: 1 });
    for (const power of [-16, -12, -8, -4, 0]) {
      const y = height(10 ** power);
      scene.line([0, y], [WIDE, y], { role: "ghost", width: 1 });
      scene.label([0, y], power === 0 ? "1 m" : `1e${power}`, {
        role: "muted",
        offset: [-5, 4],
        anchor: "end",
        size: "small",
      });
    }
    scene.label([WIDE, BASE], "t, s", {
      role: "muted",
      offset: [-18, 20],
      anchor: "end",
      size: "small",
    });
    if (output.problem) return;
    const sample = Math.round(Math.min(Math.max(input.at, 0), output.seconds) * RATE);
    const place = (all: readonly number[], ball: number, k: number): Vec2 => {
      const x = all[2 * (MOST * k + ball)] ?? 0;
      const y = line ? 0.5 : (all[2 * (MOST * k + ball) + 1] ?? 0);
      return [scale * x, low + scale * y];
    };
    for (let ball = 0; ball < output.count; ball++) {
      const path = (all: readonly number[]): Vec2[] =>
        Array.from({ length: sample + 1 }, (_, k) => place(all, ball, k));
      if (sample > 0 && !line) {
        scene.path(path(output.right), { role: "b", width: 1.5 });
        scene.path(path(output.got), { role: "miss", width: 1.5, dashed: true });
      }
      scene.ball(place(output.right, ball, sample), scale * RADIUS, { role: "b", fill: 0.35 });
      scene.ball(place(output.got, ball, sample), scale * RADIUS, {
        role: "miss",
        fill: 0,
        outline: true,
      });
    }
    const along = (k: number): number => (WIDE * k) / (output.seconds * RATE);
    const end = Math.round(output.seconds * RATE);
    scene.path(
      output.apart.slice(0, end + 1).map((apart, k): Vec2 => [along(k), height(apart)]),
      { role: "ink", width: 2.2 },
    );
    scene.line([along(sample), BASE], [along(sample), height(10)], {
      role: "muted",
      width: 1,
      dashed: true,
    });
  },
  values: (_input, output) => [
    { name: "hits", meaning: "by the method, in all", value: output.hits, role: "miss" as Role },
    { name: "hits", meaning: "right", value: output.right_hits, role: "b" as Role },
    {
      name: "distance",
      meaning: "at t, of the ball that is farthest from where it should be",
      value: output.read,
      unit: "m",
      role: "ink" as Role,
    },
    { name: "distance", meaning: "the same at the end", value: output.at_the_end, unit: "m" },
    {
      name: "overlap",
      meaning: "the deepest by the method",
      value: output.overlap,
      unit: "m",
    },
    {
      name: "ΔE/E",
      meaning: "the method’s change of energy, as a share",
      value: output.energy_change,
    },
  ],
  describe(input, output) {
    return `By ${METHODS[input.method] ?? "the method"} there are ${pretty(output.hits)} hits instead of ${pretty(output.right_hits)}. At ${pretty(input.at, 2)} s a ball is up to ${pretty(output.read, 2)} m from where it should be, at the end up to ${pretty(output.at_the_end, 2)} m.`;
  },
});
