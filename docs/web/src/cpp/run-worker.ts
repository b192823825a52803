// Watches over a student's program from a thread of its own: the page's clock stands still in a hidden tab, and the
// thread in which the program runs may never come back.

import type { Event } from "../../../wasm/test_program.mjs";
import { type Spawn, watchTests } from "../../../wasm/test_watch.mjs";
import type { FromRunner, RunOrder, Scope } from "./messages.ts";

const scope = globalThis as unknown as Scope<RunOrder, FromRunner>;

const newThread = () => new Worker(new URL("program-worker.js", location.href), { type: "module" });

/** One thread is always ready before it is needed. */
let ready = newThread();

scope.onmessage = ({ data }) => {
  run(data).catch((error: unknown) => scope.postMessage({ kind: "failed", why: String(error) }));
};

async function run({ program, tests, seconds, seed }: RunOrder): Promise<void> {
  const module = await WebAssembly.compile(program);
  const spawn: Spawn = (order, tell, fail) => {
    const thread = ready;
    ready = newThread();
    thread.onmessage = ({ data }: MessageEvent<Event | { event: "broken"; why: string }>) => {
      if (data.event === "broken") fail(new Error(data.why));
      else tell(data);
    };
    thread.onerror = (event) => fail(new Error(event.message));
    thread.postMessage({ program: module, ...order, seed });
    return { end: () => thread.terminate() };
  };
  const { results, output } = await watchTests(spawn, tests, {
    seconds,
    onStart: (test) => scope.postMessage({ kind: "start", test }),
    onTest: (result) => scope.postMessage({ kind: "test", result }),
  });
  scope.postMessage({ kind: "done", results, output });
}
