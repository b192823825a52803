// Rapier in three dimensions.

import RAPIER from "@dimforge/rapier3d-compat";
import { dependencies } from "../../../../package.json";
import { orientationOf } from "../simulate.ts";
import type { Adapter, Engine, Placed, Quat, Scene, Settings, Vec, World } from "../types.ts";

const vector = ([x, y, z]: Vec) => ({ x, y, z });
const rotation = ([x, y, z, w]: Quat) => ({ x, y, z, w });

const shapeOf = ({ shape }: Placed): RAPIER.Shape =>
  shape.type === "ball" ? new RAPIER.Ball(shape.radius) : new RAPIER.Cuboid(...shape.half);

const colliderOf = ({ shape }: Placed): RAPIER.ColliderDesc =>
  shape.type === "ball"
    ? RAPIER.ColliderDesc.ball(shape.radius)
    : RAPIER.ColliderDesc.cuboid(...shape.half);

function world(scene: Scene, settings: Settings): World {
  const made = new RAPIER.World(vector(scene.gravity));
  made.timestep = settings.step;
  made.numSolverIterations = settings.iterations;
  const bodies = scene.bodies.map((body) => {
    const fixed = body.mass === undefined;
    const about = (fixed ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic())
      .setTranslation(...body.position)
      .setRotation(rotation(orientationOf(body)))
      .setLinvel(...(body.velocity ?? [0, 0, 0]))
      .setAngvel(vector(body.spin ?? [0, 0, 0]))
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
      const { x, y, z } = bodies[body]!.translation();
      const q = bodies[body]!.rotation();
      return { position: [x, y, z], orientation: [q.x, q.y, q.z, q.w] };
    },
    close: () => made.free(),
  };
}

function signedDistance(a: Placed, b: Placed): number {
  const contact = shapeOf(a).contactShape(
    vector(a.position),
    rotation(orientationOf(a)),
    shapeOf(b),
    vector(b.position),
    rotation(orientationOf(b)),
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
      rotation(orientationOf(target)),
      length,
      true,
    );
    return time === null || time < 0 ? Number.POSITIVE_INFINITY : time;
  },
  meshHits(mesh, rays) {
    const made = new RAPIER.World({ x: 0, y: 0, z: 0 });
    const collider = made.createCollider(
      RAPIER.ColliderDesc.trimesh(mesh.vertices, mesh.triangles),
    );
    const ray = new RAPIER.Ray({ x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 0 });
    const hits = rays.map(({ origin, direction, length }) => {
      ray.origin = vector(origin);
      ray.dir = vector(direction);
      const time = collider.castRay(ray, length, true);
      return time === null || time < 0 ? Number.POSITIVE_INFINITY : time;
    });
    made.free();
    return hits;
  },
  distance: signedDistance,
  depth: signedDistance,
  impact(a, velocity, b) {
    const hit = shapeOf(a).castShape(
      vector(a.position),
      rotation(orientationOf(a)),
      vector(velocity),
      shapeOf(b),
      vector(b.position),
      rotation(orientationOf(b)),
      { x: 0, y: 0, z: 0 },
      0,
      1e30,
      true,
    );
    return hit?.time_of_impact ?? Number.POSITIVE_INFINITY;
  },
};

export const rapier3d: Adapter = {
  id: "rapier3d",
  title: "Rapier 3D",
  version: dependencies["@dimforge/rapier3d-compat"],
  dimension: 3,
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
