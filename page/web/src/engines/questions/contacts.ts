// Bodies that slide, roll, lie and are stacked.

import { ball, box, coordinate, FLOOR, finish } from "../simulate.ts";
import type { Body, Question, Scene, Vec } from "../types.ts";

const onFloor = (friction: number, gravity: Vec, ...bodies: Body[]): Scene => ({
  gravity,
  restitution: 0,
  friction,
  bodies: [FLOOR, ...bodies],
});

const DOWN: Vec = [0, -10, 0];
/** Gravity as on a slope of 3 in 4, along which x points downhill. */
const SLOPE: Vec = [6, -8, 0];

const slab = (velocity: Vec = [0, 0, 0]): Body =>
  box([1, 0.25, 0.5], [0, 0.25, 0], { mass: 2, velocity });

const sliding = onFloor(0.5, DOWN, slab([3, 0, 0]));
const held = onFloor(0.8, SLOPE, slab());
const slipping = onFloor(0.25, SLOPE, slab());

const cube = (level: number, mass: number): Body =>
  box([0.5, 0.5, 0.5], [0, 0.5 + level, 0], { mass });

const stack = onFloor(0.5, DOWN, ...Array.from({ length: 10 }, (_, i) => cube(i, 1)));
const heavy = onFloor(0.5, DOWN, cube(0, 1), cube(1, 1000));
const rolling = onFloor(0.2, DOWN, ball(0.5, [0, 0.5, 0], { mass: 1, velocity: [7, 0, 0] }));

export const contacts: readonly Question[] = [
  {
    id: "slide-to-rest",
    text: "A slab slides on a level floor at 3 m/s, with μ = 0.5 (g = 10 m/s²). How far does it slide?",
    unit: "m",
    lesson: "18_contacts",
    planar: true,
    duration: 2,
    exact: { value: 0.9, how: "v²/(2 μ g); it rests after 0.6 s" },
    ask: (engine, settings) => coordinate(engine, sliding, settings, 2, 1, 0),
  },
  {
    id: "held-on-slope",
    text: "A slab lies on a slope of 3 in 4 with μ = 0.8 (g = 10 m/s²). How far does it creep in 10 s?",
    unit: "m",
    lesson: "18_contacts",
    planar: true,
    duration: 10,
    exact: { value: 0, how: "μ is more than 3/4, so it stays where it is" },
    ask: (engine, settings) => coordinate(engine, held, settings, 10, 1, 0),
  },
  {
    id: "slips-on-slope",
    text: "The same slab with μ = 0.25, from rest. How far does it slide in 1 s?",
    unit: "m",
    lesson: "18_contacts",
    planar: true,
    duration: 1,
    exact: { value: 2, how: "a = 6 − 0.25 · 8 = 4 m/s², and a t²/2" },
    ask: (engine, settings) => coordinate(engine, slipping, settings, 1, 1, 0),
  },
  {
    id: "stack-of-ten",
    text: "Ten cubes of 1 m are stacked. How high is the centre of the topmost after 10 s (g = 10 m/s²)?",
    unit: "m",
    lesson: "18_contacts",
    planar: true,
    duration: 10,
    exact: { value: 9.5, how: "rigid cubes stay at rest" },
    ask: (engine, settings) => coordinate(engine, stack, settings, 10, 10, 1),
  },
  {
    id: "heavy-on-light",
    text: "A cube of 1,000 kg lies on a cube of 1 kg, both 1 m. How high is the centre of the upper one after 5 s (g = 10 m/s²)?",
    unit: "m",
    lesson: "18_contacts",
    planar: true,
    duration: 5,
    exact: { value: 1.5, how: "rigid cubes stay at rest" },
    ask: (engine, settings) => coordinate(engine, heavy, settings, 5, 2, 1),
  },
  {
    id: "slides-then-rolls",
    text: "A solid ball (in the plane: a disc) is pushed along a floor at 7 m/s without rotating, with μ = 0.2 (g = 10 m/s²). It slides, then rolls. How far is it after 2 s?",
    unit: "m",
    lesson: "20_scenes",
    planar: true,
    duration: 2,
    exact: { value: 11, how: "slides for 1 s to 6 m, then rolls at 5/7 of 7 m/s" },
    exact2: {
      value: 385 / 36,
      how: "a disc slides for 7/6 s to 245/36 m, then rolls at 2/3 of 7 m/s",
    },
    ask: (engine, settings) => finish(engine, rolling, settings, 2)?.[1]?.position[0],
  },
];
