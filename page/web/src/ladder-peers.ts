// Methods of a ladder that are JavaScript: other libraries, on the same inputs as the book's C++. The module writes
// the questions and compares the answers with the truth; here they are answered and timed.

import type { LadderPeer } from "../../wasm/loader.ts";

/** The prepared questions. */
export interface Asked {
  /** Answers every question once; nothing but the method is done here, so the caller times it. */
  pass(): void;
  /** The answers of the last pass, as the ladder's C++ wants them. */
  answers(): Float64Array;
}

export interface PeerCode {
  readonly version: string;
  /** Makes the library's own objects of the questions of a family, which are all its numbers. This is not timed. */
  prepare(questions: Float64Array): Asked;
}

/** By the name in the ladder's C++. Each script is loaded when a ladder runs that asks for it. */
const SCRIPTS: Readonly<Record<string, () => Promise<PeerCode>>> = {
  "three-ray-sphere": async () => (await import("./peers/three-rays.ts")).sphere,
  "three-ray-box": async () => (await import("./peers/three-rays.ts")).box,
  "bvh-triangles": async () => (await import("./peers/triangle-pairs.ts")).bvh,
  "fast-triangles": async () => (await import("./peers/triangle-pairs.ts")).fast,
};

export async function loadPeer({ id }: LadderPeer): Promise<PeerCode> {
  const script = SCRIPTS[id];
  if (!script) throw new Error(`the page has no peer ${id}`);
  return script();
}

export interface Times {
  readonly ns_median: number;
  readonly ns_q1: number;
  readonly ns_q3: number;
  readonly repeats: number;
}

/** As tests/support/ladder_page.hpp times the C++ in the page. */
const PASSES = 7;
const LONG_ENOUGH = 4; // ms: a browser's clock is coarse
/** Until then the browser may still run code that it has not optimised. */
const WARM_UP = 20; // ms

/** Time of one of n answers. @param now the time in milliseconds */
export function timed(pass: () => void, n: number, now = () => performance.now()): Times {
  const oneTurn = (least: number): number => {
    const start = now();
    let elapsed = 0;
    let rounds = 0;
    while (elapsed < least) {
      pass();
      rounds += 1;
      elapsed = now() - start;
    }
    return (elapsed * 1e6) / (rounds * n);
  };
  oneTurn(WARM_UP);
  const ns = Array.from({ length: PASSES }, () => oneTurn(LONG_ENOUGH)).sort((a, b) => a - b);
  const at = (share: number): number => {
    const place = share * (PASSES - 1);
    const below = ns[Math.floor(place)]!;
    return below + (place % 1) * (ns[Math.ceil(place)]! - below);
  };
  return { ns_median: at(0.5), ns_q1: at(0.25), ns_q3: at(0.75), repeats: PASSES };
}
