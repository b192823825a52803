// Balls that hit balls, plates and a rod.

import { ball, box, coordinate, finish } from "../simulate.ts";
import type { Body, Question, Scene } from "../types.ts";

/** Elastic bodies without gravity and friction. */
const elastic = (...bodies: Body[]): Scene => ({
  gravity: [0, 0, 0],
  restitution: 1,
  friction: 0,
  bodies,
});

const headOn = elastic(
  ball(0.5, [-2, 0, 0], { mass: 1, velocity: [3, 0, 0] }),
  ball(0.5, [0, 0, 0], { mass: 3 }),
);

/** @param spacing from centre to centre, m */
const cradle = (spacing: number): Scene =>
  elastic(
    ball(0.5, [-2, 0, 0], { mass: 1, velocity: [2, 0, 0] }),
    ...[0, 1, 2, 3].map((i) => ball(0.5, [i * spacing, 0, 0], { mass: 1 })),
  );

const oblique = elastic(
  ball(0.5, [-2, 0, 0], { mass: 1, velocity: [2, 0, 0] }),
  ball(0.5, [0, 0.6, 0], { mass: 1 }),
);

/** Ten touching balls in a triangle, and one that comes along x. */
function rack(): Scene {
  const rows = [0, 1, 2, 3].flatMap((row) =>
    Array.from({ length: row + 1 }, (_, i) =>
      ball(0.5, [(row * Math.sqrt(3)) / 2, i - row / 2, 0], { mass: 1 }),
    ),
  );
  return elastic(ball(0.5, [-3, 0.125, 0], { mass: 1, velocity: [5.5, 0, 0] }), ...rows);
}

const RACK = rack();
const RACK_CENTRE =
  RACK.bodies.reduce((sum, { position }) => sum + position[0], 0) / RACK.bodies.length;

const bullet: Scene = {
  gravity: [0, 0, 0],
  restitution: 0.25,
  friction: 0,
  bodies: [
    box([0.005, 1, 1], [0, 0, 0]),
    ball(0.004, [-3.009, 0, 0], { mass: 0.008, velocity: [300, 0, 0], fast: true }),
  ],
};

const twoBullets = elastic(
  ball(0.05, [-3.05, 0, 0], { mass: 1, velocity: [60, 0, 0], fast: true }),
  ball(0.05, [3.05, 0, 0], { mass: 1, velocity: [-60, 0, 0], fast: true }),
);

const rod = elastic(
  box([0.1, 1, 0.1], [0, 0, 0], { mass: 1 }),
  ball(0.1, [-1, 0.8, 0], { mass: 1, velocity: [2, 0, 0] }),
);
const ROD_INERTIA = (0.2 ** 2 + 2 ** 2) / 12;

export const impacts: readonly Question[] = [
  {
    id: "head-on",
    text: "A ball of 1 kg at 3 m/s, 1 m away, hits a resting ball of 3 kg, with e = 1. At which x is it after 2 s, if it starts at −2 m?",
    unit: "m",
    lesson: "13_collisions_1d",
    planar: true,
    duration: 2,
    exact: { value: -3.5, how: "it meets the other at −1 m after 1/3 s, and returns at 1.5 m/s" },
    ask: (engine, settings) => coordinate(engine, headOn, settings, 2, 0, 0),
  },
  {
    id: "cradle-apart",
    text: "A ball at 2 m/s hits a row of four equal balls with gaps of 0.25 m, with e = 1. The last one begins at 3.75 m. At which x is it after 1.5 s?",
    unit: "m",
    lesson: "13_collisions_1d",
    planar: true,
    duration: 1.5,
    exact: { value: 5, how: "each ball passes its velocity on; the last is hit after 0.875 s" },
    ask: (engine, settings) => coordinate(engine, cradle(1.25), settings, 1.5, 4, 0),
  },
  {
    id: "cradle-touching",
    text: "The same with four balls that touch, the last at 3 m: at which x is it after 1.5 s, if the impact passes from ball to ball?",
    unit: "m",
    lesson: "18_contacts",
    planar: true,
    duration: 1.5,
    exact: {
      value: 5,
      how: "the limit of vanishing gaps; a rigid model alone does not decide what touching balls do",
    },
    ask: (engine, settings) => coordinate(engine, cradle(1), settings, 1.5, 4, 0),
  },
  {
    id: "oblique",
    text: "A ball of radius 0.5 m at 2 m/s along x hits an equal one at rest whose centre is 0.6 m beside its path, with e = 1, without friction. How far beside the path is the second ball after 2 s?",
    unit: "m",
    lesson: "14_collisions_2d",
    planar: true,
    duration: 2,
    exact: { value: 1.944, how: "impact after 0.6 s along (0.8, 0.6); then 0.96 m/s for 1.4 s" },
    ask: (engine, settings) => coordinate(engine, oblique, settings, 2, 1, 1),
  },
  {
    id: "rack",
    text: "A ball at 5.5 m/s breaks a triangle of ten equal balls that touch. How far does the centre of mass of all eleven move along x in 2 s?",
    unit: "m",
    lesson: "12_momentum",
    planar: true,
    duration: 2,
    exact: { value: 1, how: "momentum is kept: 5.5 m/s · 1/11 for 2 s" },
    ask(engine, settings) {
      const end = finish(engine, RACK, settings, 2);
      if (!end) return undefined;
      return end.reduce((sum, { position }) => sum + position[0], 0) / end.length - RACK_CENTRE;
    },
  },
  {
    id: "bullet-and-plate",
    text: "A bullet of radius 4 mm at 300 m/s comes from 3 m before a fixed plate 1 cm thick, with e = 0.25. At which x is it after 0.05 s, if the plate is at 0?",
    unit: "m",
    lesson: "11_time_of_impact",
    planar: true,
    duration: 0.05,
    exact: { value: -3.009, how: "impact at −0.009 m after 0.01 s, then −75 m/s for 0.04 s" },
    ask: (engine, settings) => coordinate(engine, bullet, settings, 0.05, 1, 0),
  },
  {
    id: "two-bullets",
    text: "Two balls of radius 5 cm meet head-on at 60 m/s each, from ±3.05 m, with e = 1. At which x is the first after 0.1 s?",
    unit: "m",
    lesson: "11_time_of_impact",
    planar: true,
    duration: 0.1,
    exact: { value: -3.05, how: "they meet at 0.05 s, exchange their velocities and return" },
    ask: (engine, settings) => coordinate(engine, twoBullets, settings, 0.1, 0, 0),
  },
  {
    id: "hit-rod",
    text: "A ball of 1 kg and radius 0.1 m at 2 m/s hits a resting rod (0.2 m × 2 m, 1 kg) 0.8 m beside its centre, with e = 1, without friction, 0.4 s after the start. How far has the rod's centre moved after 1 s?",
    unit: "m",
    lesson: "17_rigid_impulse",
    planar: true,
    duration: 1,
    exact: {
      value: (0.6 * 4) / (2 + 0.8 ** 2 / ROD_INERTIA),
      how: "impulse 2v/(1/m + 1/m + d²/I) with I = m (0.2² + 2²)/12; in double, 15 digits",
    },
    ask: (engine, settings) => coordinate(engine, rod, settings, 1, 0, 0),
  },
];
