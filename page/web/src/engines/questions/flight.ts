// Bodies that fall and bounce.

import { apex, ball, box, coordinate, FLOOR, track } from "../simulate.ts";
import type { Engine, Question, Scene, Settings } from "../types.ts";

const GRAVITY = [0, -10, 0] as const;

/** A ball of radius 0.25 m, 1 m above the floor. */
const dropped = (restitution: number): Scene => ({
  gravity: GRAVITY,
  restitution,
  friction: 0,
  bodies: [FLOOR, ball(0.25, [0, 1.25, 0], { mass: 1 })],
});

/** The highest point of a body's centre between two times, s. */
function highest(
  engine: Engine,
  scene: Scene,
  settings: Settings,
  [from, until]: readonly [number, number],
): number | undefined {
  const found = track(engine, scene, settings, until, 1);
  const first = found && Math.ceil(from / found.step);
  return found?.poses && apex(found.poses.slice(first).map(({ position }) => position[1]));
}

const freeFall: Scene = {
  gravity: GRAVITY,
  restitution: 0,
  friction: 0,
  bodies: [FLOOR, ball(0.5, [0, 20, 0], { mass: 1, velocity: [1, 0, 0] })],
};

const walls: Scene = {
  gravity: [0, 0, 0],
  restitution: 1,
  friction: 0,
  bodies: [
    box([1, 5, 5], [-6, 0, 0]),
    box([1, 5, 5], [6, 0, 0]),
    ball(0.5, [0, 0, 0], { mass: 1, velocity: [10, 0, 0] }),
  ],
};

const rod: Scene = {
  gravity: GRAVITY,
  restitution: 0.5,
  friction: 0,
  bodies: [FLOOR, box([1, 0.05, 0.05], [0, 1.05, 0], { mass: 1 })],
};

export const flight: readonly Question[] = [
  {
    id: "free-fall",
    text: "A ball is thrown at 1 m/s along x from a height of 20 m, with g = 10 m/s². How high is its centre after 1 s?",
    unit: "m",
    lesson: "19_time_stepping",
    planar: true,
    duration: 1,
    exact: { value: 15, how: "20 − g t²/2, without rounding" },
    ask: (engine, settings) => coordinate(engine, freeFall, settings, 1, 1, 1),
  },
  {
    id: "minute",
    text: "A ball with e = 1 is dropped from 1 m (g = 10 m/s²). How high does it rise at the end of a minute, in the last 2 s?",
    unit: "m",
    lesson: "15_restitution",
    planar: true,
    duration: 60,
    exact: { value: 1, how: "no energy is lost, so it rises to where it was dropped" },
    ask(engine, settings) {
      const top = highest(engine, dropped(1), settings, [58, 60]);
      return top === undefined ? undefined : top - 0.25;
    },
  },
  {
    id: "third-rebound",
    text: "A ball with e = 0.8 is dropped from 1 m (g = 10 m/s²). How high does it rise after its third impact?",
    unit: "m",
    lesson: "15_restitution",
    planar: true,
    duration: 2.15,
    exact: { value: 0.262144, how: "0.8⁶ of 1 m, without rounding" },
    ask(engine, settings) {
      // The third impact is at 1.735 s, the fourth at 2.193 s.
      const top = highest(engine, dropped(0.8), settings, [1.75, 2.15]);
      return top === undefined ? undefined : top - 0.25;
    },
  },
  {
    id: "at-rest",
    text: "A ball with e = 0.5 is dropped from 1 m (g = 10 m/s²). It has infinitely many bounces, and they end after 1.342 s. How high above the floor is its lowest point after 3 s?",
    unit: "m",
    lesson: "15_restitution",
    planar: true,
    duration: 3,
    exact: { value: 0, how: "the bounces end after √(2h/g) (1 + e)/(1 − e)" },
    ask(engine, settings) {
      const height = coordinate(engine, dropped(0.5), settings, 3, 1, 1);
      return height === undefined ? undefined : height - 0.25;
    },
  },
  {
    id: "walls",
    text: "A ball of radius 0.5 m starts in the middle between two walls that are 10 m apart, at 10 m/s, with e = 1. At which x is it after 10 s?",
    unit: "m",
    lesson: "21_events",
    planar: true,
    duration: 10,
    exact: { value: -1, how: "100 m of a path that is reflected at ±4.5 m, without rounding" },
    ask: (engine, settings) => coordinate(engine, walls, settings, 10, 2, 0),
  },
  {
    id: "rod-on-both-ends",
    text: "A level rod of 2 m falls 1 m and lands on both ends at once, with e = 0.5 (g = 10 m/s²). How high does it rise?",
    unit: "m",
    lesson: "17_rigid_impulse",
    planar: true,
    duration: 0.85,
    exact: { value: 0.25, how: "by symmetry it does not rotate, so it rises to e² of 1 m" },
    ask(engine, settings) {
      const top = highest(engine, rod, settings, [0.55, 0.85]);
      return top === undefined ? undefined : top - 0.05;
    },
  },
];
