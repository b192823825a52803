// Watches over the tests of an exercise from outside the thread that runs them, so that an endless loop can be
// ended. In Node (check.mjs) and in the page (page/web/src/cpp/run-worker.ts).
import { outputLimit, timeText, withoutAssertion } from "./test_program.mjs";

/** @typedef {import('./test_program.mjs').Event} Event */
/** @typedef {import('./test_program.mjs').Failure} Failure */
/** @typedef {{ name: string, status: import('./test_program.mjs').Status | 'skipped', seconds: number,
 *   failure?: Failure, finding?: Failure }} TestResult */
/** @typedef {{ name: string, seconds: number }} Timed a test and what it may take */
/** @typedef {'inputs' | 'smaller'} Look */
/** @typedef {{ tests: readonly string[], questions: boolean, look?: Look | undefined }} Order */
/** @typedef {(order: Order, tell: (event: Event) => void, fail: (error: Error) => void) => { end(): void }} Spawn
 *   starts the tests in a thread of its own, which `end` stops at once; `fail`: the thread itself broke */

/** How often the clock is looked at, in milliseconds. */
const tick = 25;

/** Beyond the limit of the first test: a program must be started before it can begin. */
const startSeconds = 10;

/**
 * A clock that counts only time in which this thread could look at it: neither a computer that sleeps, nor a tab
 * that the browser has frozen, nor a moment when everything else was busy counts against an answer.
 */
export class Patience {
  #counted = 0;
  #last;

  /** @param {number} now in milliseconds */
  constructor(now) {
    this.#last = now;
  }

  /** Seconds counted up to now. @param {number} now in milliseconds */
  seconds(now) {
    this.#counted += Math.min(Math.max(now - this.#last, 0), 4 * tick);
    this.#last = now;
    return this.#counted / 1000;
  }
}

/** As a check on the command line has it (grading/run/patience.cpp): after a test that ran out of time, each has this
 * share of its own time, and all that run out of it have this many seconds together. */
const shortShare = 0.25;
const restSeconds = 2;

/** The time of each test of one check. */
class Budget {
  #seconds;
  #late = 0;
  #spent = 0;

  /** @param {readonly Timed[]} tests */
  constructor(tests) {
    this.#seconds = new Map(tests.map(({ name, seconds }) => [name, seconds]));
  }

  /** Before the first test, what the longest may take. @param {string | undefined} test */
  of(test) {
    const own = test === undefined ? undefined : this.#seconds.get(test);
    return (own ?? Math.max(...this.#seconds.values())) * (this.#late === 0 ? 1 : shortShare);
  }

  /** A test ran out of time; why, in words. @param {string | undefined} test @param {number} waited */
  ranOut(test, waited) {
    const less = this.#late === 0 ? "" : lessTime;
    const text = timeText(this.of(test)) + less;
    if (this.#late > 0) this.#spent += waited;
    this.#late += 1;
    return text;
  }

  /** Why the rest is not run, if it is not. */
  get enough() {
    return this.#spent < restSeconds
      ? undefined
      : `not run, because ${this.#late} tests before it did not end; mend these first`;
  }
}

const lessTime = " (it had less time because a test before it did not end)";

/**
 * Runs some tests in one thread until they have ended or one of them takes too long.
 * @param {Spawn} spawn @param {Order} order @param {Budget} budget
 * @param {(event: Event) => void} tell
 * @returns {Promise<{ late?: string | undefined, waited: number, unstarted: boolean }>} `late`: the test that did
 *   not end in time
 */
function runOnce(spawn, order, budget, tell) {
  return new Promise((resolve, reject) => {
    /** @type {string | undefined} */
    let running;
    let begun = false;
    let over = false;
    let patience = new Patience(performance.now());
    const end = () => {
      over = true;
      clearInterval(timer);
      thread.end();
    };
    const finish = (/** @type {boolean} */ late) => {
      end();
      const waited = patience.seconds(performance.now());
      resolve({ late: late ? running : undefined, waited, unstarted: late && !begun });
    };
    const take = (/** @type {Event} */ event) => {
      if (over) return; // said before it was ended, heard after
      if (event.event === "done") return finish(false);
      if (event.event === "start") {
        running = event.test;
        begun = true;
        patience = new Patience(performance.now());
      }
      tell(event);
    };
    const thread = spawn(order, take, (error) => {
      end();
      reject(error);
    });
    const timer = setInterval(() => {
      const waited = patience.seconds(performance.now());
      if (waited > budget.of(running) + (begun ? 0 : startSeconds)) finish(true);
    }, tick);
  });
}

/** A question that is open this long is the one that has no answer. In seconds. */
const open = 0.5;
/** How long to look for it. */
const search = 3;

/**
 * Finds the question without an answer. The memory of a stuck thread cannot be read, so the test runs again and prints
 * each question before asking it. The last one printed is the one.
 * @param {Spawn} spawn @param {string} test
 * @returns {Promise<Failure | undefined>}
 */
function openQuestion(spawn, test) {
  return new Promise((resolve) => {
    /** @type {Failure | undefined} */
    let question;
    let since = new Patience(performance.now());
    const all = new Patience(performance.now());
    const finish = () => {
      clearInterval(timer);
      thread.end();
      resolve(question);
    };
    const take = (/** @type {Event} */ event) => {
      if (event.event === "question") {
        question = event.failure;
        since = new Patience(performance.now());
      } else if (event.event === "done") finish();
    };
    const thread = spawn({ tests: [test], questions: true }, take, finish);
    const timer = setInterval(() => {
      const now = performance.now();
      const waited = since.seconds(now);
      if (question && waited > open) return finish();
      if (all.seconds(now) <= search) return;
      // Still asking one question after the other: none of them is the one that never ends.
      question = undefined;
      finish();
    }, tick);
  });
}

/**
 * Runs all tests, each within its time; one that crashes or never ends costs itself only.
 * @param {Spawn} spawn
 * @param {readonly Timed[]} tests in the order of the exercise
 * @param {{ onStart?: ((test: string) => void) | undefined, onTest?: ((result: TestResult) => void) | undefined,
 *           look?: Look | undefined }} options `look`: a closer look at what fails
 * @returns {Promise<{ results: TestResult[], output: string, looks: Record<string, unknown> }>} results in order,
 *   without those of tests that the program does not have; what it printed; what the closer look at each test found
 */
export async function watchTests(spawn, tests, { onStart, onTest, look }) {
  /** @type {Map<string, TestResult>} */
  const results = new Map();
  /** @type {Record<string, unknown>} */
  const looks = {};
  const printed = new Printed();
  const budget = new Budget(tests);
  const settle = (/** @type {TestResult} */ result) => {
    results.set(result.name, result);
    onTest?.(result);
  };
  /** @type {Set<string>} tests that took too long, whose question is still looked for */
  const late = new Set();
  const left = () =>
    tests.map(({ name }) => name).filter((name) => !results.has(name) && !late.has(name));
  /** @type {Promise<void>[]} */
  const searches = [];
  const settleLeft = (
    /** @type {'stopped' | 'skipped'} */ status,
    /** @type {string} */ reason,
  ) => {
    for (const name of left())
      settle({ name, status, seconds: 0, failure: { asked: "", inputs: [], reason } });
  };
  while (left().length > 0) {
    const order = { tests: left(), questions: false, look };
    const run = await runOnce(spawn, order, budget, (event) => {
      if (event.event === "start") onStart?.(event.test);
      else if (event.event === "printed") printed[event.to].push(event.bytes);
      else if (event.event === "afresh") printed.turn();
      else if (event.event === "unstarted") settleLeft("stopped", event.reason);
      else if (event.event === "look") looks[event.test] = event.look;
      else if (event.event === "end") {
        const { test, status, seconds, failure, finding } = event;
        settle({
          name: test,
          status,
          seconds,
          ...(failure ? { failure } : {}),
          ...(finding ? { finding } : {}),
        });
      }
    });
    printed.turn();
    if (run.unstarted)
      settleLeft("stopped", `before the test began: ${budget.ranOut(undefined, run.waited)}`);
    if (run.late === undefined) break;
    const name = run.late;
    const reason = budget.ranOut(name, run.waited);
    late.add(name);
    // In parallel with the remaining tests: nothing waits for it.
    searches.push(
      openQuestion(spawn, name).then((question = { asked: "", inputs: [] }) =>
        settle({
          name,
          status: "stopped",
          seconds: run.waited,
          failure: { asked: question.asked, inputs: question.inputs, reason },
        }),
      ),
    );
    if (budget.enough) settleLeft("skipped", budget.enough);
  }
  await Promise.all(searches);
  const ordered = tests.flatMap(({ name }) => results.get(name) ?? []);
  return { results: ordered, output: printed.text, looks };
}

/** What the programs printed, one after the other, until that is enough. */
class Printed {
  /** @type {Uint8Array[]} */
  output = [];
  /** @type {Uint8Array[]} */
  errors = [];
  text = "";

  /** A program has ended. */
  turn() {
    if (this.text.length < outputLimit)
      this.text += decoded(this.output) + withoutAssertion(decoded(this.errors));
    this.output = [];
    this.errors = [];
  }
}

/** @param {Uint8Array[]} parts */
function decoded(parts) {
  const decoder = new TextDecoder();
  return parts.map((part) => decoder.decode(part, { stream: true })).join("") + decoder.decode();
}
