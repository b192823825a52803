// The same verdicts from the native program: the tests as CMake compiled them, linked with an answer as `contact
// check` links it (build/dev/exercises.json says how).
import { execFile } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { promisify } from "node:util";
import { inRoot, shown } from "./paths.mjs";

const run = promisify(execFile);

/** @typedef {import('./check.mjs').Verdict} Verdict */
/** @typedef {{ compiler: string, compile_flags: string[], include: string[], pch?: string, link_flags: string[],
 *              support_libs: string[], exercises: Record<string, { test_object: string }> }} Description */

export const descriptionFile = inRoot("build", "dev", "exercises.json");

/** @param {string} file @returns {Description} */
export function readDescription(file) {
  if (!fs.existsSync(file))
    throw new Error(
      `${shown(file)} is missing: build the exercises first (cmake --build build/dev)`,
    );
  return JSON.parse(fs.readFileSync(file, "utf8"));
}

/**
 * Compiles and links one answer. @param {Description} build @param {string} exercise NN_slug/NAME
 * @param {string} answer its .cpp @param {string} folder where the results go
 * @returns {Promise<string>} the program
 */
export async function nativeProgram(build, exercise, answer, folder) {
  const object = path.join(folder, "answer.o");
  const program = path.join(folder, "tests");
  const entry = build.exercises[exercise];
  if (!entry || !fs.existsSync(entry.test_object))
    throw new Error(`the native tests of ${exercise} are not built (cmake --build build/dev)`);
  const includes = [inRoot("exercises", exercise), ...build.include].map((dir) => `-I${dir}`);
  const prelude = build.pch ? ["-include", build.pch] : [];
  await run(build.compiler, [
    ...build.compile_flags,
    ...prelude,
    ...includes,
    "-w",
    "-c",
    answer,
    "-o",
    object,
  ]);
  await run(build.compiler, [
    "-o",
    program,
    object,
    entry.test_object,
    ...build.support_libs,
    ...build.link_flags,
  ]);
  return program;
}

/** Catch2 reads these as parts of a pattern. @param {string} name */
const escaped = (name) => name.replace(/[\\,[\]*"~]/g, (sign) => `\\${sign}`);

/**
 * @param {string} program @param {string[]} tests @param {string} folder for the file of events
 * @param {{ seconds?: number }} [options]
 * @returns {Promise<Verdict[]>}
 */
export async function nativeCheck(program, tests, folder, { seconds = 5 } = {}) {
  /** @type {Map<string, Verdict>} */
  const verdicts = new Map();
  const events = path.join(folder, "events");
  for (let left = tests; left.length > 0; left = left.filter((test) => !verdicts.has(test))) {
    const args = ["-r", `contact::out=${events}`, left.map(escaped).join(",")];
    // It ends with a failure's code whenever a test fails; what counts is what it reported.
    await run(program, args, { timeout: seconds * 1000 * left.length, maxBuffer: 1 << 26 }).catch(
      () => {},
    );
    /** @type {string | undefined} */
    let running;
    for (const line of fs.readFileSync(events, "utf8").split("\n").filter(Boolean)) {
      const event = /** @type {import('./test_program.mjs').Event} */ (JSON.parse(line));
      if (event.event === "start") running = event.test;
      if (event.event !== "end") continue;
      running = undefined;
      const { test, status, failure } = event;
      verdicts.set(test, { test, status, ...(failure ? { failure } : {}) });
    }
    if (running !== undefined) verdicts.set(running, { test: running, status: "stopped" });
    if (!left.some((test) => verdicts.has(test)))
      throw new Error(`${shown(program)} ran none of these tests: ${left.join("; ")}`);
  }
  return tests.map((test) => /** @type {Verdict} */ (verdicts.get(test)));
}
