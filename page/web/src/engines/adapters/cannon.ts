// cannon-es.

import * as CANNON from "cannon-es";
import { dependencies } from "../../../../package.json";
import { orientationOf } from "../simulate.ts";
import type { Adapter, Engine, Mesh, Placed, Ray, Scene, Settings, Vec, World } from "../types.ts";

const vector = (v: Vec) => new CANNON.Vec3(...v);

const shapeOf = ({ shape }: Placed): CANNON.Shape =>
  shape.type === "ball" ? new CANNON.Sphere(shape.radius) : new CANNON.Box(vector(shape.half));

function bodyOf(placed: Placed, options: CANNON.BodyOptions = {}): CANNON.Body {
  return new CANNON.Body({
    mass: 0,
    shape: shapeOf(placed),
    position: vector(placed.position),
    quaternion: new CANNON.Quaternion(...orientationOf(placed)),
    ...options,
  });
}

function world(scene: Scene, settings: Settings): World {
  const made = new CANNON.World({ gravity: vector(scene.gravity), allowSleep: false });
  (made.solver as CANNON.GSSolver).iterations = settings.iterations;
  made.defaultContactMaterial.friction = scene.friction;
  made.defaultContactMaterial.restitution = scene.restitution;
  const bodies = scene.bodies.map((body) => {
    const one = bodyOf(body, {
      mass: body.mass ?? 0,
      velocity: vector(body.velocity ?? [0, 0, 0]),
      angularVelocity: vector(body.spin ?? [0, 0, 0]),
      // The scenes have no air.
      linearDamping: 0,
      angularDamping: 0,
    });
    made.addBody(one);
    return one;
  });
  return {
    step: () => made.step(settings.step),
    pose(body) {
      const { position: p, quaternion: q } = bodies[body]!;
      return { position: [p.x, p.y, p.z], orientation: [q.x, q.y, q.z, q.w] };
    },
    close() {},
  };
}

function firstHit(body: CANNON.Body, { origin, direction, length }: Ray): number {
  const from = vector(origin);
  const ray = new CANNON.Ray(from, from.vadd(vector(direction).scale(length)));
  ray.mode = CANNON.Ray.CLOSEST;
  const result = new CANNON.RaycastResult();
  ray.intersectBody(body, result);
  return result.hasHit ? result.distance : Number.POSITIVE_INFINITY;
}

function meshBody({ vertices, triangles }: Mesh): CANNON.Body {
  const body = new CANNON.Body({ mass: 0 });
  body.addShape(new CANNON.Trimesh([...vertices], [...triangles]));
  body.updateAABB();
  return body;
}

/** The deepest contact that the narrow phase reports. */
function reported(a: Placed, b: Placed): number {
  const made = new CANNON.World();
  const [first, second] = [bodyOf(a, { mass: 1 }), bodyOf(b, { mass: 1 })];
  made.addBody(first);
  made.addBody(second);
  first.updateAABB();
  second.updateAABB();
  const contacts: CANNON.ContactEquation[] = [];
  made.narrowphase.getContacts([first], [second], made, contacts, [], [], []);
  const distances = contacts.map(({ bi, bj, ri, rj, ni }) =>
    ni.dot(bj.position.vadd(rj).vsub(bi.position.vadd(ri))),
  );
  return distances.length > 0 ? Math.min(...distances) : Number.NaN;
}

const engine: Engine = {
  world,
  ray: (target, ray) => firstHit(bodyOf(target), ray),
  meshHits(mesh, rays) {
    const body = meshBody(mesh);
    return rays.map((ray) => firstHit(body, ray));
  },
  depth: reported,
};

export const cannon: Adapter = {
  id: "cannon",
  title: "cannon-es",
  version: dependencies["cannon-es"],
  dimension: 3,
  licence: "MIT",
  promise:
    "A lightweight 3D engine for the web, with an iterative Gauss–Seidel solver; contacts are springs with a stiffness and a relaxation time. No bound on errors is promised, and it has no continuous detection.",
  source: "https://pmndrs.github.io/cannon-es/docs/",
  iterations: "iterations of its GSSolver",
  switches:
    "continuous detection: it has none; thresholds off: nothing, since its bodies sleep only if that is asked for",
  defaults: { step: 1 / 60, iterations: 10, continuous: false, strict: false },
  load: async () => engine,
};
