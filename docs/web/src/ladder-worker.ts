// Times a ladder's methods in the reader's browser, away from the page so that it stays usable.

import { type LadderResult, loadLadder } from "../../wasm/loader.ts";
import type { LadderRow, WorkerMessage } from "./ladder-data.ts";

const INPUTS = 2000;
const BUDGET_SECONDS = 10;

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
  const { families, methods } = ladder.layout;
  const of = families.length * methods.length;
  let done = 0;
  for (const [f, family] of families.entries()) {
    ladder.prepare(f, INPUTS);
    for (const [m, method] of methods.entries()) {
      if (seconds() > BUDGET_SECONDS) {
        scope.postMessage({ kind: "end", complete: false, seconds: seconds() });
        return;
      }
      done += 1;
      const row = rowFrom(ladder.run(m), family.id, method.id);
      scope.postMessage({ kind: "row", row, done, of });
    }
  }
  scope.postMessage({ kind: "end", complete: true, seconds: seconds() });
}

function rowFrom(result: LadderResult, family: string, method: string): LadderRow {
  const known = (value: number): number | null => (Number.isNaN(value) ? null : value);
  const { error_median, error_max } = result;
  return {
    ...result,
    family,
    method,
    error_median: known(error_median),
    error_max: known(error_max),
  };
}
