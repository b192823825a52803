// Box2D 3 as WebAssembly: its build for one thread, without the wider instructions.

import type {
  b2BodyId,
  MainModule,
} from "../../../../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.d.ts";
import makeBox2D from "../../../../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.mjs";
import wasmBinary from "../../../../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.wasm";
import { dependencies } from "../../../../package.json";
import { orientationOf, planeAngle } from "../simulate.ts";
import type { Adapter, Body, Engine, Placed, Scene, Settings, World } from "../types.ts";

/** m/s; more than any body of a scene has. */
const FASTEST = 1e5;

/** The density that gives the mass. */
function density({ shape }: Placed, mass: number): number {
  const area =
    shape.type === "ball" ? Math.PI * shape.radius ** 2 : 4 * shape.half[0] * shape.half[1];
  return mass / area;
}

type WorldId = ReturnType<MainModule["b2CreateWorld"]>;

function create(b2: MainModule, id: WorldId, scene: Scene, settings: Settings, body: Body) {
  const fixed = body.mass === undefined;
  const about = b2.b2DefaultBodyDef();
  about.type = fixed ? b2.b2BodyType.b2_staticBody : b2.b2BodyType.b2_dynamicBody;
  about.position = new b2.b2Vec2(body.position[0], body.position[1]);
  // Its own sine, cosine and angle are approximations of three digits.
  const angle = planeAngle(orientationOf(body));
  const rotation = new b2.b2Rot();
  rotation.c = Math.cos(angle);
  rotation.s = Math.sin(angle);
  about.rotation = rotation;
  about.linearVelocity = new b2.b2Vec2(body.velocity?.[0] ?? 0, body.velocity?.[1] ?? 0);
  about.angularVelocity = body.spin?.[2] ?? 0;
  about.isBullet = settings.continuous && body.fast === true;
  about.enableSleep = !settings.strict;
  const one = b2.b2CreateBody(id, about);
  const shape = b2.b2DefaultShapeDef();
  shape.density = fixed ? 0 : density(body, body.mass!);
  const material = b2.b2DefaultSurfaceMaterial();
  material.friction = scene.friction;
  material.restitution = scene.restitution;
  shape.material = material;
  if (body.shape.type === "ball") {
    const circle = new b2.b2Circle();
    circle.center = new b2.b2Vec2(0, 0);
    circle.radius = body.shape.radius;
    b2.b2CreateCircleShape(one, shape, circle);
  } else {
    b2.b2CreatePolygonShape(one, shape, b2.b2MakeBox(body.shape.half[0], body.shape.half[1]));
  }
  return one;
}

function world(b2: MainModule, scene: Scene, settings: Settings): World {
  const about = b2.b2DefaultWorldDef();
  about.gravity = new b2.b2Vec2(scene.gravity[0], scene.gravity[1]);
  if (settings.strict) {
    about.enableSleep = false;
    about.restitutionThreshold = 0;
    about.maximumLinearSpeed = FASTEST;
  }
  const id = b2.b2CreateWorld(about);
  const bodies: b2BodyId[] = scene.bodies.map((body) => create(b2, id, scene, settings, body));
  return {
    step: () => b2.b2World_Step(id, settings.step, settings.iterations),
    pose(body) {
      const { x, y } = b2.b2Body_GetPosition(bodies[body]!);
      const { c, s } = b2.b2Body_GetRotation(bodies[body]!);
      const angle = Math.atan2(s, c);
      return { position: [x, y, 0], orientation: [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)] };
    },
    close: () => b2.b2DestroyWorld(id),
  };
}

const engineOf = (b2: MainModule): Engine => ({
  world: (scene, settings) => world(b2, scene, settings),
  ray(target, { origin, direction, length }) {
    const id = b2.b2CreateWorld(b2.b2DefaultWorldDef());
    const scene: Scene = { gravity: [0, 0, 0], restitution: 0, friction: 0, bodies: [] };
    create(
      b2,
      id,
      scene,
      { step: 1, iterations: 1, continuous: false, strict: false },
      {
        ...target,
      },
    );
    const found = b2.b2World_CastRayClosest(
      id,
      new b2.b2Vec2(origin[0], origin[1]),
      new b2.b2Vec2(length * direction[0], length * direction[1]),
      b2.b2DefaultQueryFilter(),
    );
    const distance = found.hit ? found.fraction * length : Number.POSITIVE_INFINITY;
    b2.b2DestroyWorld(id);
    return distance;
  },
});

export const box2d: Adapter = {
  id: "box2d",
  title: "Box2D 3",
  version: dependencies["box2d3-wasm"],
  dimension: 2,
  licence: "MIT",
  promise:
    "Deterministic across threads and platforms; a soft step solver whose substeps replace iterations; continuous detection against fixed bodies by default. Impacts slower than 1 m/s do not bounce, and speeds are limited to 400 m/s. No bound on errors is promised.",
  source: "https://box2d.org/documentation/md_simulation.html",
  iterations: "substeps",
  switches:
    "continuous detection: isBullet of fast bodies; thresholds off: no sleeping, restitutionThreshold 0, maximumLinearSpeed 1e5 m/s",
  defaults: { step: 1 / 60, iterations: 4, continuous: false, strict: false },
  load: async () => engineOf(await makeBox2D({ wasmBinary })),
};
