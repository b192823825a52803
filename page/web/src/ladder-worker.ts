// Times a ladder's methods in the reader's browser, away from the page so that it stays usable.

import { type Ladder, type LadderPeer, type LadderResult, loadLadder } from "../../wasm/loader.ts";
import type { LadderMethod, LadderRow, WorkerMessage } from "./ladder-data.ts";
import { knownError } from "./ladder-measure.ts";
import { loadPeer, type PeerCode, timed } from "./ladder-peers.ts";

const MAX_INPUTS = 2000;
const FEWEST_INPUTS = 16;
const SECONDS = 10;
const PASSES = 8; // of each method in `run`

const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent<string>) => void) | null;
  postMessage(message: WorkerMessage): void;
};

scope.onmessage = (event) => {
  measure(event.data).catch((error: unknown) =>
    scope.postMessage({ kind: "error", message: error instanceof Error ? error.message : "?" }),
  );
};

async function measure(url: string): Promise<void> {
  const began = performance.now();
  const seconds = (): number => (performance.now() - began) / 1000;
  const ladder = await loadLadder(url);
  const { families, methods, peers } = ladder.layout;
  const codes = await Promise.all(peers.map((peer, p) => loadPeer(peer, ladder.given(p))));
  scope.postMessage({ kind: "peers", peers: peers.map((peer, p) => named(peer, codes[p]!)) });
  const asked = families.map((family) => indicesOf(methods, family));
  const others = families.map((family) => indicesOf(peers, family));
  const of = [...asked, ...others].reduce((sum, indices) => sum + indices.length, 0);
  let done = 0;
  for (const [f, family] of families.entries()) {
    const share = (SECONDS - seconds()) / (families.length - f);
    ladder.prepare(f, inputsFor(ladder, f, asked[f]!, share));
    const send = (result: LadderResult, method: string): void => {
      done += 1;
      scope.postMessage({ kind: "row", row: rowFrom(result, family.id, method), done, of });
    };
    let n = 0;
    for (const m of asked[f]!) {
      const result = ladder.run(m);
      n = result.n;
      send(result, methods[m]!.id);
    }
    for (const p of others[f]!) send(runPeer(ladder, p, codes[p]!, n), peers[p]!.id);
  }
  scope.postMessage({ kind: "end", seconds: seconds() });
}

/** How the page calls a peer. */
function named({ id, title, scalar, part }: LadderPeer, { version, note }: PeerCode): LadderMethod {
  const about = { id, title: `${title} ${version}`, scalar, exact: false, peer: true, part };
  return note === undefined ? about : { ...about, note };
}

/** Times a peer on the n prepared inputs and compares its answers with the truth. */
function runPeer(ladder: Ladder, peer: number, code: PeerCode, n: number): LadderResult {
  const asked = code.prepare(ladder.questions(peer, n));
  const times = timed(asked.pass, n);
  return { ...ladder.judge(peer, asked.answers()), ...times };
}

type OfPart = { readonly part: string };

/** The methods that answer the question of the family. */
const indicesOf = (methods: readonly OfPart[], { part }: OfPart): number[] =>
  [...methods.keys()].filter((m) => methods[m]!.part === part);

/** How many inputs of a family there is time for, from one pass of each method over the fewest. */
function inputsFor(
  ladder: Ladder,
  family: number,
  methods: readonly number[],
  share: number,
): number {
  const start = performance.now();
  ladder.prepare(family, FEWEST_INPUTS);
  const prepared = performance.now();
  for (const m of methods) ladder.pass(m);
  const cost = (prepared - start + PASSES * (performance.now() - prepared)) / 1000;
  const n = Math.floor((FEWEST_INPUTS * Math.max(0, share)) / cost);
  return Math.min(MAX_INPUTS, Math.max(FEWEST_INPUTS, n));
}

function rowFrom(result: LadderResult, family: string, method: string): LadderRow {
  const { error_median, error_max } = result;
  return {
    ...result,
    family,
    method,
    error_median: knownError(error_median),
    error_max: knownError(error_max),
  };
}
