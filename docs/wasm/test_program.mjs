// Runs the tests of an exercise, compiled to WebAssembly with an answer, in this thread. Works in Node and in a
// browser's worker. The program reports as its native twin does: one JSON object a line (tests/support/runner.cpp).
import { ConsoleStdout, File, OpenFile, PreopenDirectory, WASI } from "@bjorn3/browser_wasi_shim";

/** @typedef {{ asked: string, inputs: { name: string, text: string }[], got: string, right: string,
 *              allowed?: string, misconception?: string }} Failure */
/** @typedef {'passed' | 'failed' | 'not_attempted' | 'stopped'} Status */
/** @typedef {{ event: 'start', test: string }
 *   | { event: 'end', test: string, status: Status, seconds: number, failure?: Failure }
 *   | { event: 'done' }} Event */

/** Writes through to a function instead of keeping the bytes. */
class Pipe extends OpenFile {
  /** @param {File} file @param {(bytes: Uint8Array) => void} write */
  constructor(file, write) {
    super(file);
    this.write = write;
  }
  /** @override @param {Uint8Array} data */
  fd_write(data) {
    this.write(data);
    return { ret: 0, nwritten: data.byteLength };
  }
}

class PipeFile extends File {
  /** @param {(bytes: Uint8Array) => void} write */
  constructor(write) {
    super(new Uint8Array());
    this.write = write;
  }
  /** @override */
  path_open() {
    return { ret: 0, fd_obj: new Pipe(this, this.write) };
  }
}

/** Cuts a stream of bytes into lines. @param {(line: string) => void} take */
function lines(take) {
  const decoder = new TextDecoder();
  let rest = "";
  return (/** @type {Uint8Array} */ bytes) => {
    const parts = (rest + decoder.decode(bytes, { stream: true })).split("\n");
    rest = /** @type {string} */ (parts.pop());
    for (const part of parts) take(part);
  };
}

/** Catch2 reads these as parts of a pattern. @param {string} name */
const escaped = (name) => name.replace(/[\\,[\]*"~]/g, (sign) => `\\${sign}`);

/** The last things that the code under test printed: shown if it stops. */
const keptOutput = 4000;

/**
 * What a trap means, in words. @param {unknown} error
 */
export function trapText(error) {
  const text = String(error instanceof Error ? error.message : error);
  if (/call stack|stack overflow/i.test(text))
    return "crashed: the stack overflowed (endless recursion?)";
  if (/out of bounds|memory access/i.test(text))
    return "crashed: it used memory that is not its own";
  if (/divide by zero|remainder by zero/i.test(text))
    return "crashed: an integer was divided by zero";
  if (/unreachable/i.test(text))
    return "crashed: the program ended itself (abort, assertion or broken rule)";
  return `crashed: ${text}`;
}

/**
 * Runs the named tests, each in the order given. A test in which the program dies is "stopped", and those after
 * it run in a fresh instance.
 * @param {WebAssembly.Module} program
 * @param {string[]} tests
 * @param {(event: Event) => void} tell
 * @param {{ seed?: string }} [options]
 */
export async function runTests(program, tests, tell, { seed } = {}) {
  let left = [...tests];
  while (left.length > 0) {
    /** @type {string | undefined} */
    let running;
    let started = 0;
    let output = "";
    const printed = () =>
      new ConsoleStdout((bytes) => {
        output = (output + new TextDecoder().decode(bytes)).slice(-keptOutput);
      });
    const events = new PipeFile(
      lines((line) => {
        const event = /** @type {Event} */ (JSON.parse(line));
        if (event.event === "start") {
          running = event.test;
          started = performance.now();
          left = left.filter((name) => name !== event.test);
        } else if (event.event === "end") {
          running = undefined;
        } else {
          return;
        }
        tell(event);
      }),
    );
    const stop = (/** @type {string} */ why) => {
      const test = running ?? left.shift();
      if (test === undefined) return;
      if (running === undefined) tell({ event: "start", test });
      const got = output.trim() === "" ? why : `${why}\n${output.trim()}`;
      const seconds = running === undefined ? 0 : (performance.now() - started) / 1000;
      tell({
        event: "end",
        test,
        status: "stopped",
        seconds,
        failure: { asked: "", inputs: [], got, right: "" },
      });
      running = undefined;
    };
    const before = left.length;
    const wasi = new WASI(
      ["tests", "-r", "contact::out=/events", left.map(escaped).join(",")],
      seed === undefined ? [] : [`CONTACT_SEED=${seed}`],
      [
        new OpenFile(new File([])),
        printed(),
        printed(),
        new PreopenDirectory("/", new Map([["events", events]])),
      ],
      { debug: false },
    );
    try {
      const instance = await WebAssembly.instantiate(program, {
        wasi_snapshot_preview1: wasi.wasiImport,
      });
      // The types of the shim ask for what only a running program can have.
      wasi.start(/** @type {any} */ (instance));
      if (running !== undefined) stop("ended the program");
    } catch (error) {
      stop(trapText(error));
    }
    if (left.length === before) {
      // Nothing ran and nothing died: these names are not in the program.
      for (const test of left) {
        running = undefined;
        output = "";
        left = [test];
        stop("this test is not in the program");
      }
      left = [];
    }
  }
  tell({ event: "done" });
}
