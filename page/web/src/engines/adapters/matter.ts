// matter.js. It counts lengths in pixels and times in milliseconds: 1 m is 100 pixels here.

import Matter from "matter-js";
import { dependencies } from "../../../../package.json";
import { orientationOf, planeAngle } from "../simulate.ts";
import type { Adapter, Body, Engine, Placed, Scene, Settings, World } from "../types.ts";

/** Pixels in a metre. */
const SCALE = 100;
/** ms: the duration to which matter.js refers velocities. */
const BASE = 1000 / 60;

/** Its threshold of rebound, which belongs to all worlds and is not documented. */
const resolver = Matter as unknown as { Resolver: { _restingThresh: number } };
const RESTING = resolver.Resolver._restingThresh;

/** Sides of the polygon that is a disc; by default 25. */
const ROUND = 100;
/** It multiplies the inertia of all bodies by this. */
const INERTIA_SCALE = (Matter.Body as unknown as { _inertiaScale: number })._inertiaScale;

function bodyOf(
  placed: Placed,
  options: Matter.IChamferableBodyDefinition = {},
  sides?: number,
): Matter.Body {
  const [x, y] = placed.position;
  const { shape } = placed;
  const made =
    shape.type === "ball"
      ? Matter.Bodies.circle(SCALE * x, SCALE * y, SCALE * shape.radius, options, sides)
      : Matter.Bodies.rectangle(
          SCALE * x,
          SCALE * y,
          2 * SCALE * shape.half[0],
          2 * SCALE * shape.half[1],
          options,
        );
  Matter.Body.setAngle(made, planeAngle(orientationOf(placed)));
  return made;
}

function moving(scene: Scene, body: Body, strict: boolean): Matter.Body {
  const made = bodyOf(
    body,
    {
      isStatic: body.mass === undefined,
      restitution: scene.restitution,
      friction: scene.friction,
      // The scenes have no air.
      frictionAir: 0,
    },
    strict ? ROUND : undefined,
  );
  if (body.mass !== undefined) {
    // Sets the inertia to that of the shape, too.
    Matter.Body.setMass(made, body.mass);
    if (strict) Matter.Body.setInertia(made, made.inertia / INERTIA_SCALE);
    // m/s to pixels in BASE.
    const rate = (SCALE * BASE) / 1000;
    const [vx, vy] = body.velocity ?? [0, 0, 0];
    Matter.Body.setVelocity(made, { x: vx * rate, y: vy * rate });
    Matter.Body.setAngularVelocity(made, ((body.spin?.[2] ?? 0) * BASE) / 1000);
  }
  return made;
}

function world(scene: Scene, settings: Settings): World {
  resolver.Resolver._restingThresh = settings.strict ? 0 : RESTING;
  const engine = Matter.Engine.create({
    velocityIterations: settings.iterations,
    positionIterations: settings.strict ? Math.max(6, settings.iterations) : 6,
  });
  // Gravity is given per pixel and ms² as direction times scale.
  engine.gravity.x = scene.gravity[0];
  engine.gravity.y = scene.gravity[1];
  engine.gravity.scale = SCALE / 1e6;
  const bodies = scene.bodies.map((body) => moving(scene, body, settings.strict));
  Matter.Composite.add(engine.world, bodies);
  return {
    step: () => {
      Matter.Engine.update(engine, settings.step * 1000);
    },
    pose(body) {
      const { position, angle } = bodies[body]!;
      return {
        position: [position.x / SCALE, position.y / SCALE, 0],
        orientation: [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)],
      };
    },
    close() {
      resolver.Resolver._restingThresh = RESTING;
      Matter.Engine.clear(engine);
    },
  };
}

const engine: Engine = {
  world,
  depth(a, b, sharp) {
    const sides = sharp ? ROUND : undefined;
    const collision = Matter.Collision.collides(bodyOf(a, {}, sides), bodyOf(b, {}, sides)) as {
      depth: number;
    } | null;
    return collision ? -collision.depth / SCALE : Number.NaN;
  },
};

export const matter: Adapter = {
  id: "matter",
  title: "matter.js",
  version: dependencies["matter-js"],
  dimension: 2,
  licence: "MIT",
  promise:
    "Stable stacking, conservation of momentum, restitution and friction are listed as features, and steps of at most 16.667 ms are recommended. It has no continuous detection, discs are polygons, and no bound on errors is promised.",
  source: "https://brm.io/matter-js/",
  iterations: "velocityIterations; with thresholds off positionIterations are at least as many",
  switches:
    "continuous detection: it has none; thresholds off: no least speed of rebound, discs of 100 sides, and the inertia of the shape instead of four times as much",
  defaults: { step: 1 / 60, iterations: 4, continuous: false, strict: false },
  load: async () => engine,
};
