// Rapier in the plane.

import RAPIER from "@dimforge/rapier2d-compat";
import { dependencies } from "../../../../package.json";
import { orientationOf, planeAngle } from "../simulate.ts";
import type { Adapter, Engine, Placed, Scene, Settings, Vec, World } from "../types.ts";

const vector = ([x, y]: Vec) => ({ x, y });
const angleOf = (placed: Placed): number => planeAngle(orientationOf(placed));

const shapeOf = ({ shape }: Placed): RAPIER.Shape =>
  shape.type === "ball"
    ? new RAPIER.Ball(shape.radius)
    : new RAPIER.Cuboid(shape.half[0], shape.half[1]);

const colliderOf = ({ shape }: Placed): RAPIER.ColliderDesc =>
  shape.type === "ball"
    ? RAPIER.ColliderDesc.ball(shape.radius)
    : RAPIER.ColliderDesc.cuboid(shape.half[0], shape.half[1]);

function world(scene: Scene, settings: Settings): World {
  const made = new RAPIER.World(vector(scene.gravity));
  made.timestep = settings.step;
  made.numSolverIterations = settings.iterations;
  const bodies = scene.bodies.map((body) => {
    const fixed = body.mass === undefined;
    const about = (fixed ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic())
      .setTranslation(body.position[0], body.position[1])
      .setRotation(angleOf(body))
      .setLinvel(body.velocity?.[0] ?? 0, body.velocity?.[1] ?? 0)
      .setAngvel(body.spin?.[2] ?? 0)
      .setCcdEnabled(settings.continuous && body.fast === true)
      .setCanSleep(!settings.strict);
    const rigid = made.createRigidBody(about);
    const collider = colliderOf(body).setRestitution(scene.restitution).setFriction(scene.friction);
    if (!fixed) collider.setMass(body.mass!);
    made.createCollider(collider, rigid);
    return rigid;
  });
  return {
    step: () => made.step(),
    pose(body) {
      const { x, y } = bodies[body]!.translation();
      const angle = bodies[body]!.rotation();
      return { position: [x, y, 0], orientation: [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)] };
    },
    close: () => made.free(),
  };
}

function signedDistance(a: Placed, b: Placed): number {
  const contact = shapeOf(a).contactShape(
    vector(a.position),
    angleOf(a),
    shapeOf(b),
    vector(b.position),
    angleOf(b),
    1e6,
  );
  return contact?.distance ?? Number.NaN;
}

const engine: Engine = {
  world,
  ray(target, { origin, direction, length }) {
    const ray = new RAPIER.Ray(vector(origin), vector(direction));
    const time = shapeOf(target).castRay(
      ray,
      vector(target.position),
      angleOf(target),
      length,
      true,
    );
    return time === null || time < 0 ? Number.POSITIVE_INFINITY : time;
  },
  distance: signedDistance,
  depth: signedDistance,
  impact(a, velocity, b) {
    const hit = shapeOf(a).castShape(
      vector(a.position),
      angleOf(a),
      vector(velocity),
      shapeOf(b),
      vector(b.position),
      angleOf(b),
      { x: 0, y: 0 },
      0,
      1e30,
      true,
    );
    return hit?.time_of_impact ?? Number.POSITIVE_INFINITY;
  },
};

export const rapier2d: Adapter = {
  id: "rapier2d",
  title: "Rapier 2D",
  version: dependencies["@dimforge/rapier2d-compat"],
  dimension: 2,
  licence: "Apache-2.0",
  promise:
    "Collision response by a velocity-based solver and continuous detection by motion clamping; more solver iterations give a more realistic simulation. No bound on errors is promised.",
  source: "https://rapier.rs/docs/user_guides/javascript/integration_parameters",
  iterations: "numSolverIterations",
  switches:
    "continuous detection: setCcdEnabled of fast bodies; thresholds off: setCanSleep(false) for all bodies",
  defaults: { step: 1 / 60, iterations: 4, continuous: false, strict: false },
  async load() {
    await RAPIER.init();
    return engine;
  },
};
