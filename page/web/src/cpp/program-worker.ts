// The thread in which a student's program runs: one order, then it waits to be ended.

import { runTests } from "../../../wasm/test_program.mjs";
import type { Scope } from "./messages.ts";
import type { Look } from "./types.ts";

interface Order {
  readonly program: WebAssembly.Module;
  readonly tests: readonly string[];
  readonly questions: boolean;
  readonly look: Look | undefined;
  readonly seed: string | undefined;
}

const scope = globalThis as unknown as Scope<Order, unknown>;

scope.onmessage = ({ data: { program, tests, ...options } }) => {
  runTests(program, tests, (event) => scope.postMessage(event), options).catch((error: unknown) =>
    scope.postMessage({ event: "broken", why: String(error) }),
  );
};
