// A body that rotates freely.

import { box, rotated, track } from "../simulate.ts";
import type { Question, Scene, Vec } from "../types.ts";

const HALF: Vec = [0.3, 0.2, 0.1];
const MASS = 3;
const SPIN: Vec = [0.01, 5, 0];

const wingNut: Scene = {
  gravity: [0, 0, 0],
  restitution: 0,
  friction: 0,
  bodies: [box(HALF, [0, 0, 0], { mass: MASS, spin: SPIN })],
};

/** Moments of inertia of a solid box, kg m². */
const INERTIA: Vec = [0, 1, 2].map((i) => {
  const [a, b] = [HALF[(i + 1) % 3]!, HALF[(i + 2) % 3]!];
  return (MASS / 3) * (a * a + b * b);
}) as unknown as Vec;

/** Angular velocity in axes of the body, and the quaternion from body to world, x, y, z, w. */
type State = readonly number[];

/** Euler's equations, and the rate of the quaternion. */
function rate([p, q, r, x, y, z, w]: State): number[] {
  const [A, B, C] = INERTIA;
  const [a, b, c] = [p! / 2, q! / 2, r! / 2];
  return [
    ((B - C) / A) * q! * r!,
    ((C - A) / B) * r! * p!,
    ((A - B) / C) * p! * q!,
    w! * a + y! * c - z! * b,
    w! * b + z! * a - x! * c,
    w! * c + x! * b - y! * a,
    -x! * a - y! * b - z! * c,
  ];
}

/** One step of the classical method of Runge and Kutta. */
function rungeKutta(state: State, h: number): State {
  const moved = (by: readonly number[], f: number) => state.map((s, i) => s + f * by[i]!);
  const k1 = rate(state);
  const k2 = rate(moved(k1, h / 2));
  const k3 = rate(moved(k2, h / 2));
  const k4 = rate(moved(k3, h));
  return state.map((s, i) => s + (h / 6) * (k1[i]! + 2 * k2[i]! + 2 * k3[i]! + k4[i]!));
}

/** The y component of the body's y axis in the world. */
const upright = ([, , , x, , z]: State): number => 1 - 2 * (x! * x! + z! * z!);

/**
 * When the axis is first perpendicular to where it was, s.
 * @param h the step, s
 */
export function flipTime(h: number): number {
  let state: State = [...SPIN, 0, 0, 0, 1];
  for (let i = 0; i * h < 20; i += 1) {
    const next = rungeKutta(state, h);
    if (upright(next) < 0) return i * h + refined(state, h);
    state = next;
  }
  return Number.NaN;
}

/** The part of a step after which the axis is perpendicular, by bisection. */
function refined(state: State, h: number): number {
  let [low, high] = [0, h];
  for (let i = 0; i < 60; i += 1) {
    const half = (low + high) / 2;
    if (upright(rungeKutta(state, half)) < 0) high = half;
    else low = half;
  }
  return low;
}

/** Where a smooth curve through samples crosses 0 before number `at`, in samples: by the cubic through four. */
function crossing(samples: readonly number[], at: number): number {
  const [a, b, c, d] = [samples[at - 2] ?? 0, samples[at - 1]!, samples[at]!, samples[at + 1] ?? 0];
  const cubic = (t: number): number =>
    (-a * t * (t - 1) * (t - 2)) / 6 +
    (b * (t + 1) * (t - 1) * (t - 2)) / 2 -
    (c * (t + 1) * t * (t - 2)) / 2 +
    (d * (t + 1) * t * (t - 1)) / 6;
  let [low, high] = [0, 1];
  for (let i = 0; i < 60; i += 1) {
    const half = (low + high) / 2;
    if (cubic(half) < 0) high = half;
    else low = half;
  }
  return at - 1 + low;
}

export const rotation: readonly Question[] = [
  {
    id: "wing-nut",
    text: "A box of 0.6 × 0.4 × 0.2 m rotates about its middle axis at 5 rad/s, and at 0.01 rad/s about its longest. When is the middle axis first perpendicular to where it was?",
    unit: "s",
    lesson: "17_rigid_impulse",
    planar: false,
    duration: 10,
    exact: {
      value: flipTime(1 / 4096),
      how: "Euler's equations by Runge–Kutta steps of 2⁻¹² s; halving the step changes it by less than 1e-9 s",
    },
    ask(engine, settings) {
      const found = track(engine, wingNut, settings, 10, 0);
      if (!found) return undefined;
      const ups = found.poses.map(({ orientation }) => rotated(orientation, [0, 1, 0])[1]);
      const at = ups.findIndex((up) => up < 0);
      if (at < 1) return Number.NaN;
      return found.step * crossing(ups, at);
    },
  },
];
