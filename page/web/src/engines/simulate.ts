// Runs a scene in an engine and samples what a question needs.

import type { Body, Engine, Placed, Pose, Quat, Scene, Settings, Vec } from "./types.ts";

/** The step that is used: at most the one asked for, and a whole number of them is the duration. */
export function fittingStep(step: number, duration: number): number {
  const steps = Math.ceil(duration / step - 1e-6);
  return duration / steps;
}

/**
 * The poses of one body after each step, the first at time 0. Undefined: the engine runs no scenes.
 * @param duration s
 */
export function track(
  engine: Engine,
  scene: Scene,
  settings: Settings,
  duration: number,
  body: number,
): { readonly step: number; readonly poses: readonly Pose[] } | undefined {
  if (!engine.world) return undefined;
  const step = fittingStep(settings.step, duration);
  const steps = Math.round(duration / step);
  const world = engine.world(scene, { ...settings, step });
  try {
    const poses = [world.pose(body)];
    for (let i = 0; i < steps; i += 1) {
      world.step();
      poses.push(world.pose(body));
    }
    return { step, poses };
  } finally {
    world.close();
  }
}

/** All poses at the end. Undefined: the engine runs no scenes. */
export function finish(
  engine: Engine,
  scene: Scene,
  settings: Settings,
  duration: number,
): readonly Pose[] | undefined {
  if (!engine.world) return undefined;
  const step = fittingStep(settings.step, duration);
  const steps = Math.round(duration / step);
  const world = engine.world(scene, { ...settings, step });
  try {
    for (let i = 0; i < steps; i += 1) world.step();
    return scene.bodies.map((_, i) => world.pose(i));
  } finally {
    world.close();
  }
}

/** A coordinate of a body at the end. */
export function coordinate(
  engine: Engine,
  scene: Scene,
  settings: Settings,
  duration: number,
  body: number,
  axis: 0 | 1 | 2,
): number | undefined {
  return finish(engine, scene, settings, duration)?.[body]?.position[axis];
}

/** The highest point of a path that is a parabola near it, from samples that are equally far apart. */
export function apex(heights: readonly number[]): number {
  let best = 1;
  for (let i = 1; i + 1 < heights.length; i += 1) if (heights[i]! > heights[best]!) best = i;
  const [a, b, c] = [heights[best - 1]!, heights[best]!, heights[best + 1]!];
  const bend = a - 2 * b + c;
  if (!(bend < 0)) return b;
  const offset = (a - c) / (2 * bend);
  // Beyond the neighbours it is no parabola through a maximum.
  return Math.abs(offset) <= 1 ? b - (offset * (a - c)) / 4 : b;
}

export const ball = (radius: number, position: Vec, more: Partial<Body> = {}): Body => ({
  shape: { type: "ball", radius },
  position,
  ...more,
});

export const box = (half: Vec, position: Vec, more: Partial<Body> = {}): Body => ({
  shape: { type: "box", half },
  position,
  ...more,
});

/** A fixed floor whose top is y = 0. */
export const FLOOR: Body = box([50, 1, 50], [0, -1, 0]);

export const NO_ROTATION: Quat = [0, 0, 0, 1];

export const about = (axis: Vec, angle: number): Quat => {
  const s = Math.sin(angle / 2);
  return [axis[0] * s, axis[1] * s, axis[2] * s, Math.cos(angle / 2)];
};

/** The angle about z of a planar orientation. */
export const planeAngle = ([, , z, w]: Quat): number => 2 * Math.atan2(z, w);

export const orientationOf = (placed: Placed): Quat => placed.orientation ?? NO_ROTATION;

/** A vector of the body in world axes. */
export function rotated([x, y, z, w]: Quat, [a, b, c]: Vec): Vec {
  const [tx, ty, tz] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
}
