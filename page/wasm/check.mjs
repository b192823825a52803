// An answer's verdict from its WebAssembly program, in Node, with a time limit for each test.
import { Worker } from "node:worker_threads";
import { watchTests } from "./test_watch.mjs";

/** @typedef {import('./test_program.mjs').Event} Event */
/** @typedef {{ test: string, status: import('./test_watch.mjs').TestResult['status'],
 *              failure?: import('./test_program.mjs').Failure }} Verdict */

/**
 * @param {Uint8Array} program @param {string[]} tests in the order of the file
 * @param {{ seconds?: number, seed?: string }} [options] `seconds`: what each test may take
 * @returns {Promise<Verdict[]>} one for each test, in order
 */
export async function check(program, tests, { seconds = 5, seed } = {}) {
  const timed = tests.map((name) => ({ name, seconds }));
  const { results } = await watchTests(spawn(program, seed), timed, {});
  return tests.map((test) => {
    const result = results.find(({ name }) => name === test);
    // As the judge says it (grading/verdict/verdict.cpp).
    const failure = { asked: "", inputs: [], reason: "this test did not run" };
    if (!result) return { test, status: "stopped", failure };
    const { status } = result;
    return { test, status, ...(result.failure ? { failure: result.failure } : {}) };
  });
}

/**
 * @param {Uint8Array} program @param {string | undefined} seed
 * @returns {import('./test_watch.mjs').Spawn}
 */
function spawn(program, seed) {
  return ({ tests, questions, look }, tell, fail) => {
    const workerData = { program, tests, options: { seed, questions, look } };
    const worker = new Worker(new URL("test_worker.mjs", import.meta.url), { workerData });
    worker.on("message", tell);
    worker.on("error", fail);
    return { end: () => void worker.terminate() };
  };
}
