// The thread in which an answer's tests run, so that an endless loop can be ended from outside.
import { parentPort, workerData } from "node:worker_threads";
import { runTests } from "./test_program.mjs";

/** @typedef {{ program: Uint8Array<ArrayBuffer>, tests: string[], options: import('./test_program.mjs').Options
 *           }} Order */

const { program, tests, options } = /** @type {Order} */ (workerData);
const module = await WebAssembly.compile(program);
await runTests(module, tests, (event) => parentPort?.postMessage(event), options);
