// Jolt Physics, built for one thread and single precision.

import initJolt from "jolt-physics";
import { dependencies } from "../../../../package.json";
import { orientationOf } from "../simulate.ts";
import type {
  Adapter,
  Engine,
  Mesh,
  Placed,
  Quat,
  Ray,
  Scene,
  Settings,
  Vec,
  World,
} from "../types.ts";

type Jolt = typeof initJolt;
type Interface = InstanceType<Jolt["JoltInterface"]>;
type BodyId = InstanceType<Jolt["BodyID"]>;

const FIXED = 0;
const MOVING = 1;

/** An empty world with two layers: fixed bodies meet moving ones alone. */
function empty(jolt: Jolt): Interface {
  const settings = new jolt.JoltSettings();
  const pairs = new jolt.ObjectLayerPairFilterTable(2);
  pairs.EnableCollision(FIXED, MOVING);
  pairs.EnableCollision(MOVING, MOVING);
  const layers = new jolt.BroadPhaseLayerInterfaceTable(2, 2);
  for (const layer of [FIXED, MOVING])
    layers.MapObjectToBroadPhaseLayer(layer, new jolt.BroadPhaseLayer(layer));
  settings.mMaxBodies = 256;
  settings.mMaxWorkerThreads = 0;
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(
    layers,
    2,
    pairs,
    2,
  );
  const made = new jolt.JoltInterface(settings);
  jolt.destroy(settings);
  return made;
}

const vec3 = (jolt: Jolt, v: Vec) => new jolt.Vec3(...v);
const place = (jolt: Jolt, v: Vec) => new jolt.RVec3(...v);
const quat = (jolt: Jolt, q: Quat) => new jolt.Quat(...q);

/** @param sharp whether edges of boxes are not rounded by the default convex radius of 0.05 m */
function shapeOf(jolt: Jolt, { shape }: Placed, sharp: boolean) {
  if (shape.type === "ball") return new jolt.SphereShape(shape.radius);
  const half = vec3(jolt, shape.half);
  // A convex radius must fit into the box.
  const radius = sharp ? 0 : Math.min(0.05, ...shape.half);
  return new jolt.BoxShape(half, radius);
}

function created(jolt: Jolt, scene: Scene, settings: Settings, body: Scene["bodies"][number]) {
  const fixed = body.mass === undefined;
  const about = new jolt.BodyCreationSettings(
    shapeOf(jolt, body, settings.strict),
    place(jolt, body.position),
    quat(jolt, orientationOf(body)),
    fixed ? jolt.EMotionType_Static : jolt.EMotionType_Dynamic,
    fixed ? FIXED : MOVING,
  );
  about.mRestitution = scene.restitution;
  about.mFriction = scene.friction;
  // The scenes have no air.
  about.mLinearDamping = 0;
  about.mAngularDamping = 0;
  about.mAllowSleeping = !settings.strict;
  about.mApplyGyroscopicForce = settings.strict;
  if (settings.continuous && body.fast) about.mMotionQuality = jolt.EMotionQuality_LinearCast;
  if (!fixed) {
    about.mOverrideMassProperties = jolt.EOverrideMassProperties_CalculateInertia;
    about.mMassPropertiesOverride.mMass = body.mass!;
    about.mLinearVelocity = vec3(jolt, body.velocity ?? [0, 0, 0]);
    about.mAngularVelocity = vec3(jolt, body.spin ?? [0, 0, 0]);
  }
  return about;
}

function world(jolt: Jolt, scene: Scene, settings: Settings): World {
  const made = empty(jolt);
  const system = made.GetPhysicsSystem();
  system.SetGravity(vec3(jolt, scene.gravity));
  const physics = system.GetPhysicsSettings();
  physics.mNumVelocitySteps = settings.iterations;
  if (settings.strict) physics.mMinVelocityForRestitution = 0;
  system.SetPhysicsSettings(physics);
  const bodies = system.GetBodyInterface();
  const ids: BodyId[] = scene.bodies.map((body) => {
    const one = bodies.CreateBody(created(jolt, scene, settings, body));
    bodies.AddBody(one.GetID(), jolt.EActivation_Activate);
    return one.GetID();
  });
  return {
    step: () => made.Step(settings.step, 1),
    pose(body) {
      const p = bodies.GetPosition(ids[body]!);
      const position: Vec = [p.GetX(), p.GetY(), p.GetZ()];
      const q = bodies.GetRotation(ids[body]!);
      return { position, orientation: [q.GetX(), q.GetY(), q.GetZ(), q.GetW()] };
    },
    close: () => jolt.destroy(made),
  };
}

/** What a query lets through: everything. */
const filters = (jolt: Jolt) =>
  [
    new jolt.BroadPhaseLayerFilter(),
    new jolt.ObjectLayerFilter(),
    new jolt.BodyFilter(),
    new jolt.ShapeFilter(),
  ] as const;

type Query = InstanceType<Jolt["NarrowPhaseQuery"]>;

/** Asks a world with one fixed body. */
function withBody<T>(
  jolt: Jolt,
  shape: InstanceType<Jolt["Shape"]>,
  at: Placed,
  ask: (query: Query) => T,
): T {
  const made = empty(jolt);
  const system = made.GetPhysicsSystem();
  const about = new jolt.BodyCreationSettings(
    shape,
    place(jolt, at.position),
    quat(jolt, orientationOf(at)),
    jolt.EMotionType_Static,
    FIXED,
  );
  system.GetBodyInterface().CreateAndAddBody(about, jolt.EActivation_DontActivate);
  try {
    return ask(system.GetNarrowPhaseQuery());
  } finally {
    jolt.destroy(made);
  }
}

function castWith(jolt: Jolt, query: Query) {
  const settings = new jolt.RayCastSettings();
  const allowed = filters(jolt);
  return ({ origin, direction: [x, y, z], length }: Ray): number => {
    const collector = new jolt.CastRayClosestHitCollisionCollector();
    const ray = new jolt.RRayCast(
      place(jolt, origin),
      vec3(jolt, [x * length, y * length, z * length]),
    );
    query.CastRay(ray, settings, collector, ...allowed);
    const distance = collector.HadHit()
      ? collector.mHit.mFraction * length
      : Number.POSITIVE_INFINITY;
    jolt.destroy(ray);
    jolt.destroy(collector);
    return distance;
  };
}

function meshShape(jolt: Jolt, { vertices, triangles }: Mesh) {
  const list = new jolt.TriangleList();
  const vertex = (i: number) => vec3(jolt, [...vertices.subarray(3 * i, 3 * i + 3)] as never);
  for (let i = 0; i < triangles.length; i += 3)
    list.push_back(
      new jolt.Triangle(
        vertex(triangles[i]!),
        vertex(triangles[i + 1]!),
        vertex(triangles[i + 2]!),
      ),
    );
  return new jolt.MeshShapeSettings(list).Create().Get();
}

/** A body at a pose as queries want it: the transformation of its centre of mass. */
const transform = (jolt: Jolt, at: Placed) =>
  jolt.RMat44.prototype.sRotationTranslation(
    quat(jolt, orientationOf(at)),
    place(jolt, at.position),
  );

/**
 * The signed distance by a collision query; NaN: none was reported.
 * @param apart m: up to which bodies that are apart are reported. Depths are less exact if it is not 0.
 */
function reported(jolt: Jolt, a: Placed, b: Placed, sharp: boolean, apart: number): number {
  return withBody(jolt, shapeOf(jolt, b, sharp), b, (query) => {
    const settings = new jolt.CollideShapeSettings();
    settings.mMaxSeparationDistance = apart;
    const collector = new jolt.CollideShapeClosestHitCollisionCollector();
    query.CollideShape(
      shapeOf(jolt, a, sharp),
      vec3(jolt, [1, 1, 1]),
      transform(jolt, a),
      settings,
      place(jolt, [0, 0, 0]),
      collector,
      ...filters(jolt),
    );
    return collector.HadHit() ? -collector.mHit.mPenetrationDepth : Number.NaN;
  });
}

/** s: how far ahead the cast looks. */
const HORIZON = 4;

function impact(jolt: Jolt, a: Placed, [x, y, z]: Vec, b: Placed, sharp: boolean): number {
  return withBody(jolt, shapeOf(jolt, b, sharp), b, (query) => {
    const cast = new jolt.RShapeCast(
      shapeOf(jolt, a, sharp),
      vec3(jolt, [1, 1, 1]),
      transform(jolt, a),
      vec3(jolt, [x * HORIZON, y * HORIZON, z * HORIZON]),
    );
    const collector = new jolt.CastShapeClosestHitCollisionCollector();
    const settings = new jolt.ShapeCastSettings();
    query.CastShape(cast, settings, place(jolt, [0, 0, 0]), collector, ...filters(jolt));
    return collector.HadHit() ? collector.mHit.mFraction * HORIZON : Number.POSITIVE_INFINITY;
  });
}

const engineOf = (jolt: Jolt): Engine => ({
  world: (scene, settings) => world(jolt, scene, settings),
  ray: (target, ray, sharp) =>
    withBody(jolt, shapeOf(jolt, target, sharp), target, (query) => castWith(jolt, query)(ray)),
  meshHits: (mesh, rays) =>
    withBody(
      jolt,
      meshShape(jolt, mesh),
      { shape: { type: "ball", radius: 1 }, position: [0, 0, 0] },
      (query) => {
        const cast = castWith(jolt, query);
        return rays.map(cast);
      },
    ),
  distance: (a, b, sharp) => reported(jolt, a, b, sharp, 1),
  depth: (a, b, sharp) => reported(jolt, a, b, sharp, 0),
  impact: (a, velocity, b, sharp) => impact(jolt, a, velocity, b, sharp),
});

export const jolt: Adapter = {
  id: "jolt",
  title: "Jolt",
  version: dependencies["jolt-physics"],
  dimension: 3,
  licence: "MIT",
  promise:
    "Deterministic if the same calls are made in the same order. Continuous detection is a linear cast: a body moves up to its first impact, loses the rest of the step, and bounces in the next. Edges of convex shapes are rounded by a convex radius, and an impact slower than 1 m/s does not bounce. No bound on errors is promised.",
  source: "https://jrouwe.github.io/JoltPhysics/",
  iterations: "mNumVelocitySteps",
  switches:
    "continuous detection: LinearCast of fast bodies; thresholds off: no sleeping, mMinVelocityForRestitution 0, convex radius 0, and mApplyGyroscopicForce on",
  defaults: { step: 1 / 60, iterations: 10, continuous: false, strict: false },
  load: async () => engineOf(await initJolt()),
};
