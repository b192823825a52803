// The run workers as the page sees them. Each watches over one program at a time; one that is not needed rests.

import { type FromRunner, NOT_LOADED, type RunOrder } from "./messages.ts";
import { CheckerError, type Looks, type TestResult } from "./types.ts";

export interface RunHooks {
  readonly onStart: (test: string) => void;
  readonly onTest: (result: TestResult) => void;
  readonly signal?: AbortSignal | undefined;
}

export interface Finished {
  readonly results: readonly TestResult[];
  readonly output: string;
  /** What the closer look at each test found. */
  readonly looks: Looks;
}

const notLoaded = () =>
  new CheckerError(
    "A part of the page could not be loaded, so nothing was checked. Load the page again; your code is kept.",
  );

export class Runners {
  readonly #script: string;
  readonly #resting: Worker[] = [];

  /** @param script the address of the run worker */
  constructor(script: string) {
    this.#script = script;
  }

  /** Has one ready: its script loads while the compiler works. */
  prepare(): void {
    if (this.#resting.length === 0) this.#resting.push(this.#new());
  }

  #new(): Worker {
    const worker = new Worker(this.#script, { type: "module" });
    // One that does not load must not be there for the next check.
    worker.onerror = (event) => {
      event.preventDefault();
      const at = this.#resting.indexOf(worker);
      if (at >= 0) this.#resting.splice(at, 1);
    };
    return worker;
  }

  run(order: RunOrder, { onStart, onTest, signal }: RunHooks): Promise<Finished> {
    const worker = this.#resting.pop() ?? this.#new();
    return new Promise((resolve, reject) => {
      const end = (error: unknown) => {
        worker.terminate(); // and with it the program's own thread
        signal?.removeEventListener("abort", abort);
        reject(error);
      };
      const abort = () => end(signal?.reason);
      if (signal?.aborted) return abort();
      signal?.addEventListener("abort", abort, { once: true });
      worker.onerror = (event) => {
        event.preventDefault();
        end(event.message ? new Error(`the run worker: ${event.message}`) : notLoaded());
      };
      worker.onmessage = ({ data }: MessageEvent<FromRunner>) => {
        if (data.kind === "start") onStart(data.test);
        else if (data.kind === "test") onTest(data.result);
        else if (data.kind === "failed")
          end(data.why === NOT_LOADED ? notLoaded() : new Error(data.why));
        else {
          signal?.removeEventListener("abort", abort);
          this.#resting.push(worker);
          resolve(data);
        }
      };
      worker.postMessage(order, [order.program.buffer]);
    });
  }
}
