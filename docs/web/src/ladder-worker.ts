// Times a ladder's methods in the reader's browser, away from the page so that it stays usable.

import type { LadderFamily, LadderMethod, LadderRow, WorkerMessage } from "./ladder-data.ts";

interface Exports {
  readonly memory: WebAssembly.Memory;
  _initialize?(): void;
  layout(): number;
  prepare(family: number, n: number): void;
  run(method: number): number;
}

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

async function load(url: string): Promise<Exports> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  const module = await WebAssembly.compile(await response.arrayBuffer());
  const imports: Record<string, Record<string, () => number>> = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = name === "now" ? () => performance.now() : () => 52;
  }
  const { exports } = await WebAssembly.instantiate(module, imports);
  const ladder = exports as unknown as Exports;
  ladder._initialize?.();
  return ladder;
}

async function measure(url: string): Promise<void> {
  const began = performance.now();
  const seconds = (): number => (performance.now() - began) / 1000;
  const ladder = await load(url);
  const bytes = new Uint8Array(ladder.memory.buffer, ladder.layout());
  const text = new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  const layout = JSON.parse(text) as { families: LadderFamily[]; methods: LadderMethod[] };
  const of = layout.families.length * layout.methods.length;
  let done = 0;
  for (const [f, family] of layout.families.entries()) {
    ladder.prepare(f, INPUTS);
    for (const [m, method] of layout.methods.entries()) {
      if (seconds() > BUDGET_SECONDS) {
        scope.postMessage({ kind: "end", complete: false, seconds: seconds() });
        return;
      }
      const place = ladder.run(m);
      const row = rowFrom(new Float64Array(ladder.memory.buffer, place, 9), family.id, method.id);
      done += 1;
      scope.postMessage({ kind: "row", row, done, of });
    }
  }
  scope.postMessage({ kind: "end", complete: true, seconds: seconds() });
}

function rowFrom(numbers: Float64Array, family: string, method: string): LadderRow {
  const [n, wrong, undecided, errorMedian, errorMax, nsMedian, nsQ1, nsQ3, repeats] = [
    ...numbers,
  ] as [number, number, number, number, number, number, number, number, number];
  const known = (value: number): number | null => (Number.isNaN(value) ? null : value);
  return {
    family,
    method,
    n,
    wrong,
    undecided,
    error_median: known(errorMedian),
    error_max: known(errorMax),
    ns_median: nsMedian,
    ns_q1: nsQ1,
    ns_q3: nsQ3,
    repeats,
  };
}
