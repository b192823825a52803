// An answer's verdict from its WebAssembly program, in Node, with a time limit for each test.
import { Worker } from "node:worker_threads";

/** @typedef {import('./test_program.mjs').Event} Event */
/** @typedef {{ test: string, status: import('./test_program.mjs').Status,
 *              failure?: import('./test_program.mjs').Failure }} Verdict */

/**
 * @param {Uint8Array} program @param {string[]} tests in the order of the file
 * @param {{ seconds?: number, seed?: string }} [options] `seconds`: the limit for one test
 * @returns {Promise<Verdict[]>} one for each test, in order
 */
export async function check(program, tests, { seconds = 5, seed } = {}) {
  /** @type {Map<string, Verdict>} */
  const verdicts = new Map();
  let left = tests;
  while (left.length > 0) {
    const late = await run(program, left, seconds, seed, (verdict) =>
      verdicts.set(verdict.test, verdict),
    );
    if (late !== undefined) {
      const got = `took longer than ${seconds} s`;
      verdicts.set(late, {
        test: late,
        status: "stopped",
        failure: { asked: "", inputs: [], got, right: "" },
      });
    }
    left = left.filter((test) => !verdicts.has(test));
    if (late === undefined && left.length > 0)
      throw new Error(`the program did not run these tests: ${left.join("; ")}`);
  }
  return tests.map((test) => /** @type {Verdict} */ (verdicts.get(test)));
}

/**
 * @param {Uint8Array} program @param {string[]} tests @param {number} seconds
 * @param {string | undefined} seed @param {(verdict: Verdict) => void} tell
 * @returns {Promise<string | undefined>} the test that ran out of time, if one did
 */
function run(program, tests, seconds, seed, tell) {
  return new Promise((resolve, reject) => {
    const worker = new Worker(new URL("test_worker.mjs", import.meta.url), {
      workerData: { program, tests, ...(seed === undefined ? {} : { seed }) },
    });
    /** @type {NodeJS.Timeout | undefined} */
    let clock;
    worker.on("message", (message) => {
      const event = /** @type {Event} */ (message);
      clearTimeout(clock);
      if (event.event === "start") {
        clock = setTimeout(() => {
          void worker.terminate();
          resolve(event.test);
        }, seconds * 1000);
      } else if (event.event === "end") {
        const { test, status, failure } = event;
        tell({ test, status, ...(failure ? { failure } : {}) });
      }
    });
    worker.on("error", (error) => {
      clearTimeout(clock);
      reject(error);
    });
    worker.on("exit", () => {
      clearTimeout(clock);
      resolve(undefined);
    });
  });
}
