// Runs the tests of an exercise, compiled to WebAssembly with an answer, in this thread. Works in Node and in a
// browser's worker. The program reports as its native twin does: one JSON object a line (tests/support/runner.cpp);
// how it can end otherwise is told in the words of grading/run/run.cpp.
import {
  ConsoleStdout,
  File,
  OpenFile,
  PreopenDirectory,
  WASI,
  WASIProcExit,
} from "@bjorn3/browser_wasi_shim";

/** @typedef {{ asked: string, inputs: { name: string, text: string }[], got?: string, right?: string,
 *              allowed?: string, misconceptions?: string[], reason?: string }} Failure */
/** @typedef {Pick<Failure, 'asked' | 'inputs'>} Question */
/** @typedef {'passed' | 'failed' | 'not_attempted' | 'stopped'} Status */
/** @typedef {{ event: 'start', test: string }
 *   | { event: 'end', test: string, status: Status, seconds: number, failure?: Failure,
 *       finding?: Failure }
 *   | { event: 'question', failure: Question }
 *   | { event: 'look', test: string, look: unknown }
 *   | { event: 'printed', to: 'output' | 'errors', bytes: Uint8Array<ArrayBuffer> }
 *   | { event: 'afresh' }
 *   | { event: 'unstarted', reason: string }
 *   | { event: 'done' }} Event
 *  `question`: what is asked next, if questions are to be told; `look`: what a closer look has found so far; `afresh`: another instance begins; `unstarted`: the program dies before any test of
 *  those that are left begins. */
/** @typedef {{ seed?: string | undefined, outputLimit?: number, questions?: boolean,
 *              look?: 'inputs' | 'smaller' | undefined }} Options
 *  `outputLimit`: bytes that an answer may print; `questions`: tell each before it is asked; `look`: go on after a
 *  wrong answer, and tell which inputs are answered right, or also a smaller one (tests/support/runner.cpp) */

/** Bytes that a student's program may print, to each stream, before it is stopped. */
export const outputLimit = 1 << 20;

/** So much of it is told as it is printed; what is beyond comes in larger pieces. */
const promptOutput = 1 << 16;

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

/** An assertion that failed, as the page's C library tells it: what, in which file. */
const assertionLine = /^Assertion failed: (.*) \(([^()\n]*?): [^\n]*: \d+\)$/m;

/** The error output of a student's program, without the line that is already in the reason.
 * @param {string} errors */
export const withoutAssertion = (errors) =>
  errors
    .split(/(?<=\n)/)
    .filter((line) => !assertionLine.test(line.trimEnd()))
    .join("");

/**
 * Why the program aborted, from its last output: the message of an assertion or of an uncaught exception, as in a
 * native program.
 * @param {string} errors
 */
function abortText(errors) {
  const thrown =
    /libc\+\+abi: terminating due to uncaught exception(?: of type (.+?))?(?:: (.*))?$/m;
  const exception = thrown.exec(errors);
  if (exception) {
    const [, type = "an unknown type", what] = exception;
    const said = what === undefined ? "" : `   what():  ${what}`;
    return `aborted: terminate called after throwing an instance of '${type}'${said}`;
  }
  const assertion = assertionLine.exec(errors);
  if (!assertion) return undefined;
  const [, what = "", file = ""] = assertion;
  // Most assertions that a student meets are a library's own, about an index or an empty container.
  const whose = file.includes("/Eigen/")
    ? "Eigen found a wrong index or size: "
    : file.includes("/c++/")
      ? "the standard library found a wrong index or an empty container: "
      : "";
  return `aborted: ${whose}Assertion \`${what.slice(0, 400)}' failed.`;
}

const sentences = {
  memory:
    "segmentation fault: it touched memory that is not its own (an index out of range, an empty optional or " +
    "container, or a function that calls itself without end)",
  abort: "aborted: it called abort(), or an exception left a noexcept function",
  division: "arithmetic fault: an integer was divided by zero",
  output: "it printed without end and was stopped",
};

/** @param {number} seconds */
export const timeText = (seconds) =>
  `no answer after ${seconds} ${seconds === 1 ? "second" : "seconds"}: an endless loop, or far too much work`;

/**
 * What a trap means, in words, whichever browser tells it.
 * @param {unknown} error @param {string} errors what the program printed there
 */
export function trapText(error, errors = "") {
  const text = String(error instanceof Error ? error.message : error);
  const aborted = abortText(errors);
  if (aborted) return aborted;
  if (/zero|unrepresentable/i.test(text)) return sentences.division;
  // Unreachable: where a null pointer would be followed. What aborts says so by its exit code.
  if (
    /unreachable|call stack|recursion|bounds|memory access|table|indirect|null|signature/i.test(
      text,
    )
  )
    return sentences.memory;
  if (/exception/i.test(text)) return "aborted: an exception was thrown and not caught";
  return `stopped: ${text}`;
}

/** The exit code of a program that aborts (128 and the signal's number). */
const abortCode = 134;

/** @typedef {{ memory: WebAssembly.Memory, __stack_pointer: WebAssembly.Global,
 *              contact_spare_stack(): number, contact_last_words(): number }} Exports */

/** A program in this thread, from its start to its end. */
class Run {
  /** @type {string | undefined} the test that has begun and not ended */
  running;
  /** Tests that have ended. @type {Set<string>} */
  ended = new Set();
  done = false;
  /** @type {number | undefined} */
  exitCode;
  tooMuch = false;
  /** The end of what was printed on standard error. */
  errors = "";
  /** Each tells what is held back of what was printed. @type {(() => void)[]} */
  flushes = [];
  #started = 0;
  /** It is being asked for its last words. */
  #dead = false;
  /** @type {Exports | undefined} */
  #exports;
  /** The question that was open when the program died. @type {Question} */
  #question = { asked: "", inputs: [] };

  /** @param {(event: Event) => void} tell @param {Options} options */
  constructor(tell, options) {
    this.tell = tell;
    this.options = options;
  }

  /** @param {string} line */
  #event(line) {
    // What destructors say while an exit or an ended print leaves the program is no news.
    if (this.tooMuch || this.exitCode !== undefined) return;
    const event = /** @type {Event} */ (JSON.parse(line));
    if (event.event === "start") {
      this.running = event.test;
      this.#started = performance.now();
    } else if (event.event === "end") {
      this.running = undefined;
      this.ended.add(event.test);
    } else if (event.event === "done") {
      this.done = true;
      return;
    }
    this.tell(event);
  }

  /** @param {'output' | 'errors'} to */
  #stream(to) {
    const decoder = new TextDecoder();
    const limit = this.options.outputLimit ?? outputLimit;
    let length = 0;
    /** @type {Uint8Array[]} */
    let held = [];
    let holds = 0;
    const flush = () => {
      if (holds === 0) return;
      const bytes = new Uint8Array(holds);
      let at = 0;
      for (const part of held) {
        bytes.set(part, at);
        at += part.length;
      }
      held = [];
      holds = 0;
      this.tell({ event: "printed", to, bytes });
    };
    this.flushes.push(flush);
    return new ConsoleStdout((bytes) => {
      // What last words let go of beyond the limit is not wanted, and must not end them.
      if (this.#dead && this.tooMuch) return;
      length += bytes.length;
      held.push(bytes.slice());
      holds += bytes.length;
      if (to === "errors")
        this.errors = (this.errors + decoder.decode(bytes, { stream: true })).slice(-4000);
      // At once, because this thread may never come back; but not line by line without end.
      if (length < promptOutput || holds > 4096) flush();
      if (length > limit) {
        if (!this.tooMuch) {
          this.tooMuch = true;
          this.#hearLastWords();
        }
        throw new Error(sentences.output);
      }
    });
  }

  /** Runs the tests until the program ends, one way or another; says why, or nothing if all is well.
   * @param {WebAssembly.Module} program @param {readonly string[]} tests
   * @returns {Promise<string | undefined>} */
  async start(program, tests) {
    const events = new PipeFile(lines((line) => this.#event(line)));
    const { seed, questions, look } = this.options;
    const wasi = new WASI(
      ["tests", "-r", "contact::out=/events", tests.map(escaped).join(",")],
      [
        ...(seed === undefined ? [] : [`CONTACT_SEED=${seed}`]),
        ...(questions ? ["CONTACT_TELL_QUESTIONS=1"] : []),
        ...(look === undefined ? [] : [`CONTACT_LOOK=${look}`]),
      ],
      [
        new OpenFile(new File([])),
        this.#stream("output"),
        this.#stream("errors"),
        new PreopenDirectory("/", new Map([["events", events]])),
      ],
      { debug: false },
    );
    // Remembered here: on its way out the error passes code that may turn it into an abort.
    wasi.wasiImport["proc_exit"] = (/** @type {number} */ code) => {
      if (this.exitCode === undefined) this.#hearLastWords();
      this.exitCode ??= code;
      throw new WASIProcExit(code);
    };
    try {
      const instance = await WebAssembly.instantiate(program, {
        wasi_snapshot_preview1: wasi.wasiImport,
      });
      this.#exports = /** @type {any} */ (instance.exports);
      // The types of the shim ask for what only a running program can have.
      wasi.start(/** @type {any} */ (instance));
    } catch (error) {
      if (!this.tooMuch) this.#hearLastWords();
      return this.#why(error);
    } finally {
      for (const flush of this.flushes) flush();
    }
    return this.done ? undefined : this.#why(undefined);
  }

  /**
   * Asks a program that has died which question was open, and lets it print what it had not printed yet: its memory
   * is still there (page/wasm/last_words.cpp). It gets a stack of its own, the program's may be used up.
   */
  #hearLastWords() {
    const exports = this.#exports;
    if (!exports || this.running === undefined) return;
    const stack = exports.__stack_pointer.value;
    this.#dead = true;
    try {
      exports.__stack_pointer.value = exports.contact_spare_stack();
      const place = exports.contact_last_words();
      const memory = new Uint8Array(exports.memory.buffer);
      const text = new TextDecoder().decode(memory.slice(place, memory.indexOf(0, place)));
      this.#question = JSON.parse(text);
    } catch {
      // Its memory may be in any state: then nothing is known.
    } finally {
      this.#dead = false;
      exports.__stack_pointer.value = stack;
    }
  }

  /** @param {unknown} error */
  #why(error) {
    if (this.tooMuch) return sentences.output;
    if (this.exitCode === abortCode) return abortText(this.errors) ?? sentences.abort;
    if (this.exitCode !== undefined || error === undefined)
      return `the program ended by itself (exit code ${this.exitCode ?? 0}): does your code call exit()?`;
    return trapText(error, this.errors);
  }

  /** The running test ends here. @param {string} reason */
  stop(reason) {
    const test = this.running;
    if (test === undefined) return;
    const seconds = (performance.now() - this.#started) / 1000;
    const failure = { ...this.#question, reason };
    this.running = undefined;
    this.ended.add(test);
    this.tell({ event: "end", test, status: "stopped", seconds, failure });
  }
}

/**
 * Runs the named tests, in the order of the program. A test in which the program dies is "stopped", and those
 * after it run in a fresh instance. A test that the program does not have is not told of.
 * @param {WebAssembly.Module} program
 * @param {readonly string[]} tests
 * @param {(event: Event) => void} tell
 * @param {Options} [options]
 */
export async function runTests(program, tests, tell, options = {}) {
  for (let left = tests; left.length > 0; ) {
    const run = new Run(tell, options);
    const reason = await run.start(program, left);
    if (reason === undefined) break;
    run.stop(reason);
    if (run.ended.size === 0) {
      tell({ event: "unstarted", reason: `before the test began: ${reason}` });
      break;
    }
    left = left.filter((name) => !run.ended.has(name));
    tell({ event: "afresh" });
  }
  tell({ event: "done" });
}
