// What the page "Ask the engines" means by a scene, an engine and a question. All quantities are in SI units.

export type Vec = readonly [number, number, number];
/** x, y, z, w. */
export type Quat = readonly [number, number, number, number];

export type Shape =
  | { readonly type: "ball"; readonly radius: number }
  | { readonly type: "box"; readonly half: Vec };

/** A shape in space. */
export interface Placed {
  readonly shape: Shape;
  readonly position: Vec;
  /** Default: not rotated. */
  readonly orientation?: Quat;
}

export interface Body extends Placed {
  /** kg; a body without mass is fixed. */
  readonly mass?: number;
  /** m/s */
  readonly velocity?: Vec;
  /** rad/s, in world axes */
  readonly spin?: Vec;
  /** Whether the engine is told that it is fast, if its settings ask for continuous detection. */
  readonly fast?: boolean;
}

/** Bodies that are all of one material. The y axis points up. */
export interface Scene {
  /** m/s² */
  readonly gravity: Vec;
  readonly restitution: number;
  readonly friction: number;
  readonly bodies: readonly Body[];
}

export interface Pose {
  readonly position: Vec;
  readonly orientation: Quat;
}

/** What a reader may change. A geometric query uses none of it. */
export interface Settings {
  /** s */
  readonly step: number;
  /** As the engine counts them; see `iterations` of its adapter. */
  readonly iterations: number;
  /** Continuous detection for bodies that are `fast`. */
  readonly continuous: boolean;
  /** Whether thresholds are off: sleeping, and the speed below which nothing bounces. */
  readonly strict: boolean;
}

export interface World {
  step(): void;
  pose(body: number): Pose;
  /** Frees what the engine does not free itself. */
  close(): void;
}

export interface Mesh {
  /** x, y, z of each vertex; every number is a float. */
  readonly vertices: Float32Array;
  readonly triangles: Uint32Array;
}

/** An origin and a direction of length 1. */
export interface Ray {
  readonly origin: Vec;
  readonly direction: Vec;
  /** m: nothing farther is asked for, where an engine wants an end. */
  readonly length: number;
}

/** An engine that is loaded. What it has no function for is left out. `sharp`: as "thresholds off" of the settings. */
export interface Engine {
  /** A scene at its beginning. `step` of the settings divides the duration of the question. */
  world?(scene: Scene, settings: Settings): World;
  /** Distance from the origin to the first hit of a solid, m; infinite: no hit. */
  ray?(target: Placed, ray: Ray, sharp: boolean): number;
  /** Distance from each origin to the first hit of a mesh, m; infinite: no hit. */
  meshHits?(mesh: Mesh, rays: readonly Ray[]): readonly number[];
  /** Distance of bodies that are apart or touch, m; negative if they are taken to overlap. NaN: no answer. */
  distance?(a: Placed, b: Placed, sharp: boolean): number;
  /** The least depth of bodies that overlap as a negative distance, m. NaN: no contact was reported. */
  depth?(a: Placed, b: Placed, sharp: boolean): number;
  /** The time at which `a`, translating with a velocity (m/s), first touches `b`, s; infinite: never. */
  impact?(a: Placed, velocity: Vec, b: Placed, sharp: boolean): number;
}

export interface Adapter {
  readonly id: string;
  readonly title: string;
  readonly version: string;
  readonly dimension: 2 | 3;
  readonly licence: string;
  /** What its documentation promises, as a sentence; and where it does. */
  readonly promise: string;
  readonly source: string;
  /** What its iterations are. */
  readonly iterations: string;
  /** What continuous detection and "thresholds off" set in it. */
  readonly switches: string;
  /** The engine's own defaults. Undefined: it only answers geometric questions. */
  readonly defaults?: Settings;
  load(): Promise<Engine>;
}

export interface Question {
  readonly id: string;
  /** What is asked, with all numbers that it needs. */
  readonly text: string;
  /** Of the answer; empty: a count. */
  readonly unit: string;
  /** The chapter whose lesson explains it, and in whose exercise a program is broken by it. */
  readonly lesson: string;
  /** Whether everything happens in a plane, so that engines of the plane can answer. */
  readonly planar: boolean;
  /** If the answer needs a simulation. */
  readonly duration?: number;
  readonly exact: {
    readonly value: number;
    /** How it was found, and how many digits are right. */
    readonly how: string;
  };
  /** If the shapes of the plane have another exact answer: a disc is no ball when it rolls. */
  readonly exact2?: { readonly value: number; readonly how: string };
  /** Undefined: the engine has no function for it. NaN: it has one, and that gave no answer. */
  ask(engine: Engine, settings: Settings): number | undefined;
}

export interface Answer {
  /** NaN: the engine gave no answer. */
  readonly value: number;
  /** Distance from the exact answer, in its unit. */
  readonly error: number;
  /** ms, without loading the engine. */
  readonly time: number;
  /** What the engine threw. */
  readonly failed?: string;
}
