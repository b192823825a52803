// The book itself: geometric questions by the reference headers (page/engines/queries.cpp), scenes by the scene
// player's reader, planner and simulator (page/player). Both are compiled to WebAssembly.

import { type Figure, loadFigure, type Source } from "../../../../wasm/loader.ts";
import { MORE, REACHED, Simulation } from "../../scenes/simulation.ts";
import { orientationOf } from "../simulate.ts";
import type {
  Adapter,
  Body,
  Engine,
  Mesh,
  Placed,
  Quat,
  Ray,
  Scene,
  Vec,
  World,
} from "../types.ts";

/** The rays of one call, as page/engines/queries.cpp has room for. */
const ROOM = { vertices: 162, triangles: 320, rays: 500 };

const wFirst = ([x, y, z, w]: Quat): number[] => [w, x, y, z];

const filled = (numbers: ArrayLike<number>, size: number): number[] =>
  Array.from({ length: size }, (_, i) => numbers[i] ?? 0);

function sizes(shape: Placed["shape"]): { radius: number; half: Vec } {
  return shape.type === "ball"
    ? { radius: shape.radius, half: [0, 0, 0] }
    : { radius: 0, half: shape.half };
}

const SOMEWHERE: Placed = { shape: { type: "ball", radius: 1 }, position: [0, 0, 0] };
const ONE_RAY: Ray = { origin: [0, 0, 0], direction: [1, 0, 0], length: 1 };
const NO_MESH: Mesh = { vertices: new Float32Array(0), triangles: new Uint32Array(0) };

class Queries {
  readonly #figure: Figure;

  constructor(figure: Figure) {
    this.#figure = figure;
  }

  /** @param query as in page/engines/queries.cpp */
  ask(
    query: number,
    a: Placed,
    b = SOMEWHERE,
    ray = ONE_RAY,
    mesh = NO_MESH,
    rays: readonly Ray[] = [],
  ) {
    const [of_a, of_b] = [sizes(a.shape), sizes(b.shape)];
    const { answer, hit, problem } = this.#figure.compute({
      query: [query],
      radius_a: [of_a.radius],
      radius_b: [of_b.radius],
      half_a: of_a.half,
      half_b: of_b.half,
      centre_a: a.position,
      centre_b: b.position,
      q_a: wFirst(orientationOf(a)),
      q_b: wFirst(orientationOf(b)),
      origin: ray.origin,
      direction: ray.direction,
      vertices: [mesh.vertices.length / 3],
      triangles: [mesh.triangles.length / 3],
      rays: [rays.length],
      vertex: filled(mesh.vertices, 3 * ROOM.vertices),
      triangle: filled(mesh.triangles, 3 * ROOM.triangles),
      ray_origin: filled(
        rays.flatMap(({ origin }) => [...origin]),
        3 * ROOM.rays,
      ),
      ray_direction: filled(
        rays.flatMap(({ direction }) => [...direction]),
        3 * ROOM.rays,
      ),
    });
    if (problem?.[0] !== 0) throw new Error("the book's module has no room for this question");
    return { answer: answer![0]!, hits: hit!.slice(0, rays.length) };
  }

  mesh(mesh: Mesh, rays: readonly Ray[]): readonly number[] {
    return this.ask(3, SOMEWHERE, SOMEWHERE, ONE_RAY, mesh, rays).hits;
  }
}

/** A body in the format of a scene's file (chapters/20_scenes/scene.schema.json). */
function written({ shape, position, orientation, mass, velocity, spin }: Body, index: number) {
  return {
    name: `body_${index}`,
    shape:
      shape.type === "ball"
        ? { type: "sphere", radius: shape.radius }
        : { type: "box", half_lengths: shape.half },
    material: "all",
    position,
    ...(orientation && { orientation: { quaternion: wFirst(orientation) } }),
    ...(mass === undefined ? { moves: false } : { mass }),
    ...(velocity && { velocity }),
    ...(spin && { angular_velocity: spin }),
  };
}

function sceneText(scene: Scene, step: number): string {
  return JSON.stringify({
    format: "contact-scene/1",
    units: "SI",
    name: "question",
    about: "A question to the engines.",
    gravity: scene.gravity,
    materials: [{ name: "all", restitution: scene.restitution, friction: scene.friction }],
    bodies: scene.bodies.map(written),
    duration: 3600,
    tolerance: { position: 1e-9 },
    output: { every: step },
  });
}

/** Numbers of a body in a frame: its position, and the quaternion of its orientation, w first. */
const BODY = 7;

function open(simulation: Simulation, scene: Scene, step: number): World {
  const opened = simulation.open(sceneText(scene, step), "question.json", {
    with: [],
    without: [],
  });
  if ("wrong" in opened) throw new Error(opened.wrong);
  let steps = 0;
  let bodies = simulation.frame(0)!.bodies;
  return {
    step() {
      steps += 1;
      let end = MORE;
      while (end === MORE) end = simulation.advance(0, steps * step, 100_000);
      if (end !== REACHED) throw new Error(simulation.trouble());
      bodies = simulation.frame(0)!.bodies;
    },
    pose(body) {
      const [x, y, z, w, a, b, c] = [...bodies.subarray(BODY * body, BODY * body + BODY)];
      return { position: [x!, y!, z!], orientation: [a!, b!, c!, w!] };
    },
    close() {},
  };
}

function engineOf(simulation: Simulation, queries: Queries): Engine {
  return {
    world: (scene, { step }) => open(simulation, scene, step),
    ray: (target, ray) => queries.ask(0, target, SOMEWHERE, ray).answer,
    distance: (a, b) => queries.ask(1, a, b).answer,
    depth: (a, b) => queries.ask(1, a, b).answer,
    impact: (a, velocity, b) => queries.ask(2, a, b, { ...ONE_RAY, direction: velocity }).answer,
    meshHits(mesh, rays) {
      const hits: number[] = [];
      for (let i = 0; i < rays.length; i += ROOM.rays)
        hits.push(...queries.mesh(mesh, rays.slice(i, i + ROOM.rays)));
      return hits;
    },
  };
}

/** @param player @param queries where the two modules are, or their bytes */
export const book = (player: Source, queries: Source): Adapter => ({
  id: "book",
  title: "this book",
  version: "as shown",
  dimension: 3,
  licence: "MIT",
  promise:
    "Each reference function states its error, and the plan of a scene states a bound on the error of positions, or that it has none.",
  source: "chapters/20_scenes.html",
  iterations: "none: the plan of the scene chooses its methods",
  switches: "none: a tolerance of 1e-9 m, from which the plan chooses steps or events",
  defaults: { step: 1 / 60, iterations: 1, continuous: true, strict: true },
  load: async () =>
    engineOf(await Simulation.start(player), new Queries(await loadFigure(queries))),
});
