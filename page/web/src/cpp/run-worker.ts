// Supervises a student's program from a thread of its own, because the page's timers stop in a hidden tab, and the
// thread in which the program runs may never return.

import type { Event } from "../../../wasm/test_program.mjs";
import { type Spawn, watchTests } from "../../../wasm/test_watch.mjs";
import { type FromRunner, NOT_LOADED, type RunOrder, type Scope } from "./messages.ts";
import type { Looks } from "./types.ts";

const scope = globalThis as unknown as Scope<RunOrder, FromRunner>;

interface Thread {
  readonly worker: Worker;
  /** Why it cannot be used: its script may fail to load before the first request. */
  broken?: string;
  onBroken?: (why: string) => void;
}

/** The thread's script, where it is not beside this one: in an exercise saved as one file (alone/files.ts). */
const { contactProgram } = globalThis as { contactProgram?: string };
const saved =
  contactProgram && URL.createObjectURL(new Blob([contactProgram], { type: "text/javascript" }));

function newThread(): Thread {
  const worker = saved
    ? new Worker(saved)
    : new Worker(new URL("program-worker.js", location.href), { type: "module" });
  const thread: Thread = { worker };
  worker.onerror = (event) => {
    event.preventDefault();
    thread.broken = event.message || NOT_LOADED;
    thread.onBroken?.(thread.broken);
  };
  return thread;
}

/** One thread is always ready before it is needed. */
let ready = newThread();

scope.onmessage = ({ data }) => {
  run(data).catch((error: unknown) => {
    const why = error instanceof Error ? error.message : String(error);
    scope.postMessage({ kind: "failed", why });
  });
};

async function run({ program, tests, seed, look }: RunOrder): Promise<void> {
  const module = await WebAssembly.compile(program);
  const spawn: Spawn = (order, tell, fail) => {
    const thread = ready.broken === undefined ? ready : newThread();
    ready = newThread();
    const { worker } = thread;
    worker.onmessage = ({ data }: MessageEvent<Event | { event: "broken"; why: string }>) => {
      if (data.event === "broken") fail(new Error(data.why));
      else tell(data);
    };
    thread.onBroken = (why) => fail(new Error(why));
    worker.postMessage({ program: module, ...order, seed });
    return { end: () => worker.terminate() };
  };
  const { results, output, looks } = await watchTests(spawn, tests, {
    look,
    onStart: (test) => scope.postMessage({ kind: "start", test }),
    onTest: (result) => scope.postMessage({ kind: "test", result }),
  });
  scope.postMessage({ kind: "done", results, output, looks: looks as Looks });
}
