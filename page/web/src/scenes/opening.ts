// The scene that the page opens with, and its C++ (page/player/opening.cpp): elastic balls between
// walls in a plane, from event to event. The reader knows scenes of this kind alone and refuses all
// others; the player's own reader, in C++, knows every scene and tells what is wrong with one.

import { Program, type Source } from "../../../wasm/loader.ts";
import type { Vec3 } from "../numbers.ts";
import type { Body, Frame, SceneFacts } from "./messages.ts";

/** The scene as the page draws it, and as the C++ takes it. */
export interface OpeningScene extends Pick<SceneFacts, "about" | "duration" | "gravity"> {
  readonly bodies: readonly Body[];
  /** The bodies that are balls, by number. */
  readonly balls: readonly number[];
  /** Eight numbers for each ball, then four for each wall. */
  readonly numbers: readonly number[];
}

type Fields = Readonly<Record<string, unknown>>;

/** An object with these keys, and those of `optional` or not; no others. */
function fields(value: unknown, where: string, keys: string[], optional: string[] = []): Fields {
  if (typeof value !== "object" || value === null || Array.isArray(value))
    throw new Error(`${where} is no object`);
  const missing = keys.find((key) => !Object.hasOwn(value, key));
  if (missing !== undefined) throw new Error(`${where} has no ${missing}`);
  const other = Object.keys(value).find((key) => !keys.includes(key) && !optional.includes(key));
  if (other !== undefined) throw new Error(`${where}.${other} is not known to the opening`);
  return value as Fields;
}

function list(value: unknown, where: string): readonly unknown[] {
  if (!Array.isArray(value)) throw new Error(`${where} is no list`);
  return value;
}

function number(value: unknown, where: string): number {
  if (typeof value !== "number") throw new Error(`${where} is no number`);
  return value;
}

function positive(value: unknown, where: string): number {
  const given = number(value, where);
  if (!(given > 0)) throw new Error(`${where} is not greater than 0`);
  return given;
}

function vector(value: unknown, where: string): Vec3 {
  const [x, y, z, ...more] = list(value, where).map((part) => number(part, where));
  if (x === undefined || y === undefined || z === undefined || more.length > 0)
    throw new Error(`${where} has not three numbers`);
  return [x, y, z];
}

/** A vector in the plane of x and y. */
function flat(value: unknown, where: string): Vec3 {
  const given = vector(value, where);
  if (given[2] !== 0) throw new Error(`${where} leaves the plane z = 0`);
  return given;
}

function expect(there: unknown, wanted: unknown, where: string): void {
  if (there !== wanted) throw new Error(`${where} is not ${String(wanted)}`);
}

/** Whether a direction is along x or y: such a unit vector has no rounding in its length. */
const isAlongAxis = ([x, y]: Vec3): boolean => Math.abs(x) + Math.abs(y) === 1 && x * y === 0;

/**
 * Reads a scene (`scene.schema.json`) whose bodies are moving balls and walls in the plane z = 0, without
 * gravity, friction and compliance, and elastic. From event to event such a scene needs no tolerance. (Where balls
 * touch at the start, the plan may prefer steps: the page opens with a scene that it plans from event to event.)
 * @throws Error with the first thing that is otherwise
 */
export function readOpening(text: string): OpeningScene {
  const scene = fields(
    JSON.parse(text),
    "scene",
    ["format", "units", "name", "about", "gravity", "materials", "bodies", "duration", "tolerance"],
    ["output", "expect"],
  );
  expect(scene["format"], "contact-scene/1", "format");
  expect(scene["units"], "SI", "units");
  const gravity = vector(scene["gravity"], "gravity");
  if (gravity.some((part) => part !== 0)) throw new Error("gravity is not 0");
  const materials = list(scene["materials"], "materials").map((value, i) => {
    const where = `materials[${i}]`;
    const material = fields(value, where, ["name", "restitution", "friction"]);
    expect(material["restitution"], 1, `${where}.restitution`);
    expect(material["friction"], 0, `${where}.friction`);
    return material["name"];
  });
  const bodies: Body[] = [];
  const balls: number[] = [];
  const ofBalls: number[] = [];
  const ofWalls: number[] = [];
  for (const [i, value] of list(scene["bodies"], "bodies").entries()) {
    const where = `bodies[${i}]`;
    const ball = ["mass", "position", "velocity"];
    const body = fields(value, where, ["name", "shape", "material"], ball);
    const name = String(body["name"]);
    if (!materials.includes(body["material"])) throw new Error(`${where} has no such material`);
    const shape = fields(body["shape"], `${where}.shape`, ["type"], ["radius", "normal", "offset"]);
    if (shape["type"] === "sphere") {
      fields(shape, `${where}.shape`, ["type", "radius"]);
      fields(body, where, ["name", "shape", "material", "mass", "position"], ["velocity"]);
      const radius = positive(shape["radius"], `${where}.shape.radius`);
      ofBalls.push(
        ...flat(body["position"], `${where}.position`),
        ...flat(body["velocity"] ?? [0, 0, 0], `${where}.velocity`),
        radius,
        positive(body["mass"], `${where}.mass`),
      );
      balls.push(i);
      bodies.push({ name, moves: true, shape: { type: "sphere", radius } });
    } else {
      expect(shape["type"], "half_space", `${where}.shape.type`);
      fields(shape, `${where}.shape`, ["type", "normal", "offset"]);
      fields(body, where, ["name", "shape", "material"]);
      const normal = flat(shape["normal"], `${where}.shape.normal`);
      if (!isAlongAxis(normal)) throw new Error(`${where}.shape.normal is along no axis`);
      const offset = number(shape["offset"], `${where}.shape.offset`);
      ofWalls.push(...normal, offset);
      bodies.push({ name, moves: false, shape: { type: "half_space", normal, offset } });
    }
  }
  if (balls.length === 0) throw new Error("no ball moves");
  return {
    about: String(scene["about"]),
    duration: positive(scene["duration"], "duration"),
    gravity,
    bodies,
    balls,
    numbers: [...ofBalls, ...ofWalls],
  };
}

interface Functions {
  opening_room(balls: number, walls: number): number;
  opening_begin(): void;
  opening_advance(until: number, budget: number): number;
  opening_frame(): number;
}

/** Numbers of a frame before its balls, in the order of opening.cpp. */
const HEAD = 2;

/** How an advance ended: as in simulation.ts. */
const STUCK = 2;

/** A run of the scene. */
export class OpeningRun {
  readonly #program: Program<Functions>;
  readonly #scene: OpeningScene;

  private constructor(program: Program<Functions>, scene: OpeningScene) {
    this.#program = program;
    this.#scene = scene;
  }

  /** At its start. */
  static async start(source: Source, scene: OpeningScene): Promise<OpeningRun> {
    const program = await Program.start<Functions>(source);
    const { balls, bodies, numbers } = scene;
    const room = program.call((opening) =>
      opening.opening_room(balls.length, bodies.length - balls.length),
    );
    program.numbers(room, numbers.length).set(numbers);
    const run = new OpeningRun(program, scene);
    run.restart();
    return run;
  }

  restart(): void {
    this.#program.call((opening) => opening.opening_begin());
  }

  /** Runs until a time, for at most so many hits; says whether it can go on. */
  advance(until: number, budget: number): boolean {
    return this.#program.call((opening) => opening.opening_advance(until, budget)) !== STUCK;
  }

  /** Where everything is now: seven numbers for each body, as of the player. */
  frame(): Pick<Frame, "side" | "time" | "hits" | "bodies"> {
    const { balls, bodies } = this.#scene;
    const place = this.#program.call((opening) => opening.opening_frame());
    const numbers = this.#program.numbers(place, HEAD + 3 * balls.length);
    const [time, hits] = numbers;
    const posed = new Float64Array(7 * bodies.length);
    for (const i of bodies.keys()) posed[7 * i + 3] = 1; // the quaternion 1: a smooth ball never turns
    for (const [k, i] of balls.entries())
      posed.set(numbers.subarray(HEAD + 3 * k, HEAD + 3 * k + 3), 7 * i);
    return { side: 0, time: time!, hits: hits!, bodies: posed };
  }
}
