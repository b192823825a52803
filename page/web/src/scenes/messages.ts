// What the scene player's C++ says (page/player/player.cpp), and what page and worker tell each
// other.

import type { Vec3 } from "../numbers.ts";

export type Shape =
  | { readonly type: "sphere"; readonly radius: number }
  | { readonly type: "box"; readonly half_lengths: Vec3 }
  | { readonly type: "capsule"; readonly radius: number; readonly half_length: number }
  | { readonly type: "hull"; readonly points: readonly Vec3[] }
  | { readonly type: "half_space"; readonly normal: Vec3; readonly offset: number };

export interface Body {
  readonly name: string;
  readonly moves: boolean;
  readonly shape: Shape;
}

export interface SceneFacts {
  readonly name: string;
  readonly about: string;
  readonly duration: number;
  readonly gravity: Vec3;
  readonly tolerance: number | null;
  readonly bodies: readonly Body[];
}

export interface Decision {
  readonly effect: string;
  readonly on: boolean;
  readonly planned: boolean;
  readonly overridden: boolean;
  readonly proven: boolean;
  /** Whether it is switched; else it is a value. */
  readonly switched: boolean;
  readonly why: string;
  /** The conditions, as `contact plan --explain` writes them. */
  readonly says: readonly string[];
  readonly error: number | null;
  readonly error_is: string;
  readonly instructions: number | null;
  readonly instructions_are: string;
  /** Why switching it leaves the run as it is; empty if it does not, or may not. */
  readonly changes_nothing: string;
  readonly value: number | null;
}

export interface Plan {
  readonly pairs: number;
  readonly speed: number | null;
  readonly step: number | null;
  /** m; 0: no error of a place is accepted. */
  readonly tolerance: number;
  /** Of all decisions together, m; null: no bound. */
  readonly error: number | null;
  /** Both, in words. */
  readonly accepted: string;
  readonly decisions: readonly Decision[];
  readonly notices: readonly string[];
}

export interface Composition {
  readonly event_driven: boolean;
  readonly step: number;
  readonly bytes_per_body: number;
  readonly bytes: number;
  readonly stages: readonly { readonly name: string; readonly detail: string }[];
  readonly fallback: { readonly time: number; readonly why: string } | null;
}

/** A run that was made, or why there is none. The second has its own plan. */
export type Side = (Composition | { readonly refused: string }) & { readonly plan?: Plan };

/** What is forced on and off, and the step that is asked for in s. */
export interface Overrides {
  readonly with: readonly string[];
  readonly without: readonly string[];
  readonly step?: number;
}

export interface Opened {
  readonly scene: SceneFacts;
  readonly plan: Plan;
  readonly sides: readonly Side[];
}

/** A run at a moment. */
export interface Frame {
  /** 0: as planned, 1: as switched. */
  readonly side: number;
  readonly time: number;
  readonly energy: number;
  readonly firstEnergy: number;
  readonly steps: number;
  readonly substeps: number;
  readonly hits: number;
  readonly pairs: number;
  readonly contacts: number;
  readonly rests: number;
  readonly largestOverlap: number;
  readonly bytes: number;
  readonly bytesPerBody: number;
  readonly eventDriven: boolean;
  /** The largest distance between a body here and the same body in the run as planned, m. */
  readonly apart: number;
  /** That body, or −1. */
  readonly farthest: number;
  /** Seven numbers a body: where it is, and the quaternion w, x, y, z by which it is turned. */
  readonly bodies: Float64Array;
}

export type ToWorker =
  | { readonly do: "load"; readonly wasm: string }
  | {
      readonly do: "open";
      readonly text: string;
      readonly file: string;
      readonly overrides: Overrides;
    }
  | { readonly do: "switch"; readonly overrides: Overrides }
  | { readonly do: "run"; readonly until: number };

export type FromWorker =
  | { readonly kind: "loaded" }
  | { readonly kind: "opened"; readonly opened: Opened; readonly frames: readonly Frame[] }
  /** What was given is no scene: the lines of `contact scene check`. */
  | { readonly kind: "wrong"; readonly lines: string }
  | {
      readonly kind: "switched";
      readonly sides: readonly Side[];
      readonly frames: readonly Frame[];
    }
  /** Both runs have come to the time that was asked for; what each took to compute, ms in all. */
  | { readonly kind: "frame"; readonly frames: readonly Frame[]; readonly took: readonly number[] }
  /** A run has gone over from events to steps. */
  | { readonly kind: "composed"; readonly side: number; readonly composition: Composition }
  /** One run cannot go on. */
  | {
      readonly kind: "ended";
      readonly side: number;
      readonly words: string;
      readonly frames: readonly Frame[];
    }
  /** The C++ stopped, or never started. */
  | { readonly kind: "broken"; readonly words: string };
