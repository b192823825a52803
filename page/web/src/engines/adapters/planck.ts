// planck.js: Box2D 2.4 in JavaScript.

import {
  Box,
  Circle,
  Distance,
  DistanceInput,
  DistanceOutput,
  type Body as PlanckBody,
  Settings as PlanckSettings,
  type Shape as PlanckShape,
  World as PlanckWorld,
  SimplexCache,
  Transform,
  Vec2,
} from "planck";
import { dependencies } from "../../../../package.json";
import { orientationOf, planeAngle } from "../simulate.ts";
import type { Adapter, Engine, Placed, Scene, Settings, World } from "../types.ts";

const shapeOf = ({ shape }: Placed): PlanckShape =>
  shape.type === "ball" ? new Circle(shape.radius) : new Box(shape.half[0], shape.half[1]);

const at = ({ position: [x, y] }: Placed): Vec2 => new Vec2(x, y);

/** Its defaults, which belong to all worlds. */
const THRESHOLDS = {
  velocityThreshold: PlanckSettings.velocityThreshold,
  maxTranslation: PlanckSettings.maxTranslation,
};

function thresholds(strict: boolean): void {
  PlanckSettings.velocityThreshold = strict ? 0 : THRESHOLDS.velocityThreshold;
  PlanckSettings.maxTranslation = strict ? 1000 : THRESHOLDS.maxTranslation;
}

/** Solid bodies of the plane have the inertia of a disc or a rectangle, and the density that gives the mass. */
function density({ shape }: Placed, mass: number): number {
  const area =
    shape.type === "ball" ? Math.PI * shape.radius ** 2 : 4 * shape.half[0] * shape.half[1];
  return mass / area;
}

function world(scene: Scene, settings: Settings): World {
  thresholds(settings.strict);
  const made = new PlanckWorld({
    gravity: new Vec2(scene.gravity[0], scene.gravity[1]),
    allowSleep: !settings.strict,
  });
  const bodies: PlanckBody[] = scene.bodies.map((body) => {
    const fixed = body.mass === undefined;
    const one = made.createBody({
      type: fixed ? "static" : "dynamic",
      position: at(body),
      angle: planeAngle(orientationOf(body)),
      linearVelocity: new Vec2(body.velocity?.[0] ?? 0, body.velocity?.[1] ?? 0),
      angularVelocity: body.spin?.[2] ?? 0,
      bullet: settings.continuous && body.fast === true,
    });
    one.createFixture({
      shape: shapeOf(body),
      density: fixed ? 0 : density(body, body.mass!),
      friction: scene.friction,
      restitution: scene.restitution,
    });
    return one;
  });
  return {
    step() {
      made.step(settings.step, settings.iterations, POSITION_ITERATIONS);
    },
    pose(body) {
      const { x, y } = bodies[body]!.getPosition();
      const angle = bodies[body]!.getAngle();
      return { position: [x, y, 0], orientation: [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)] };
    },
    close: () => thresholds(false),
  };
}

const POSITION_ITERATIONS = 3;

const engine: Engine = {
  world,
  ray(target, { origin, direction, length }) {
    const output = { normal: new Vec2(), fraction: 0 };
    const from = new Vec2(origin[0], origin[1]);
    const to = new Vec2(origin[0] + length * direction[0], origin[1] + length * direction[1]);
    const placed = new Transform(at(target), planeAngle(orientationOf(target)));
    const hit = shapeOf(target).rayCast(output, { p1: from, p2: to, maxFraction: 1 }, placed, 0);
    return hit ? output.fraction * length : Number.POSITIVE_INFINITY;
  },
  /** By the distance of the cores: the radius of a polygon is a skin for its solver, no part of the shape. */
  distance(a, b) {
    const input = new DistanceInput();
    input.proxyA.set(shapeOf(a), 0);
    input.proxyB.set(shapeOf(b), 0);
    input.transformA.setNum(at(a), planeAngle(orientationOf(a)));
    input.transformB.setNum(at(b), planeAngle(orientationOf(b)));
    input.useRadii = false;
    const output = new DistanceOutput();
    Distance(output, new SimplexCache(), input);
    const radius = ({ shape }: Placed): number => (shape.type === "ball" ? shape.radius : 0);
    return output.distance - radius(a) - radius(b);
  },
};

export const planck: Adapter = {
  id: "planck",
  title: "planck",
  version: dependencies["planck"],
  dimension: 2,
  licence: "MIT",
  promise:
    "Box2D in JavaScript. Continuous detection against fixed bodies, and among moving ones for bullets; impacts slower than a threshold do not bounce. No bound on errors is promised.",
  source: "https://piqnt.com/planck.js/docs/",
  iterations: "velocity iterations; position iterations stay at 3",
  switches:
    "continuous detection: bullet of fast bodies; thresholds off: no sleeping, velocityThreshold 0, maxTranslation 1000 m",
  defaults: { step: 1 / 60, iterations: 8, continuous: false, strict: false },
  load: async () => engine,
};
