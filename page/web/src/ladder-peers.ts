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
  /** What a reader must know of its times. */
  readonly note?: string;
  /** Makes the library's own objects of the questions of a family, one after the other. This is not timed. */
  prepare(questions: Float64Array): Asked;
}

/**
 * By the name in the ladder's C++. Each script is loaded when a ladder runs that asks for it. What the questions refer
 * to is given once, and what is built of it is not timed.
 */
const SCRIPTS: Readonly<Record<string, (given: Float64Array) => Promise<PeerCode>>> = {
  "three-ray-sphere": async () => (await import("./peers/three-rays.ts")).sphere,
  "three-ray-box": async () => (await import("./peers/three-rays.ts")).box,
  "bvh-meshes": async (given) => (await import("./peers/mesh-segments.ts")).bvh(given),
  "bvh-triangles": async () => (await import("./peers/triangle-pairs.ts")).bvh,
  "fast-triangles": async () => (await import("./peers/triangle-pairs.ts")).fast,
};

/** @param given numbers that the questions refer to, as the ladder's C++ gives them */
export async function loadPeer(
  { id }: Pick<LadderPeer, "id">,
  given: Float64Array,
): Promise<PeerCode> {
  const script = SCRIPTS[id];
  if (!script) throw new Error(`the page has no peer ${id}`);
  return script(given);
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
/** Of a turn that warms up. Such turns are repeated while they become faster: the browser still optimises the code. */
const WARM_UP = 20; // ms
const MOST_WARM_UPS = 10;
const FASTER = 0.8;

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
  let before = Number.POSITIVE_INFINITY;
  for (let turn = 0; turn < MOST_WARM_UPS; turn += 1) {
    const cold = oneTurn(WARM_UP);
    if (cold > FASTER * before) break;
    before = cold;
  }
  const ns = Array.from({ length: PASSES }, () => oneTurn(LONG_ENOUGH)).sort((a, b) => a - b);
  const at = (share: number): number => {
    const place = share * (PASSES - 1);
    const below = ns[Math.floor(place)]!;
    return below + (place % 1) * (ns[Math.ceil(place)]! - below);
  };
  return { ns_median: at(0.5), ns_q1: at(0.25), ns_q3: at(0.75), repeats: PASSES };
}
