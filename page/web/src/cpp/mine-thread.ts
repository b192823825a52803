// Asks a reader's function in its own thread, one question at a time. While it works, only the
// latest question waits; when it does not answer in time, the thread is ended and a new one begun.

import type { Fields } from "../layout.ts";
import type { FromMine, ToMine } from "./mine-worker.ts";

export type MineAnswer = Exclude<FromMine, { kind: "ready" }> | { readonly kind: "late" };

/** What one call may take, and what it may take to load the thread and the program. */
export const ANSWER_SECONDS = 1;
const START_SECONDS = 10;

export interface MineQuestion {
  readonly numbers: readonly number[];
  /** What the book answers. */
  readonly book: Fields;
}

export class MineThread {
  readonly #script: string;
  readonly #program: WebAssembly.Module;
  readonly #answered: (answer: MineAnswer, book: Fields) => void;
  #worker: Worker | undefined;
  #ready = false;
  /** What is being answered. */
  #asked: MineQuestion | undefined;
  #next: MineQuestion | undefined;
  #clock: ReturnType<typeof setTimeout> | undefined;

  constructor(
    script: string,
    program: WebAssembly.Module,
    answered: (answer: MineAnswer, book: Fields) => void,
  ) {
    this.#script = script;
    this.#program = program;
    this.#answered = answered;
  }

  ask(question: MineQuestion): void {
    this.#next = question;
    if (!this.#worker) this.#start();
    else if (this.#ready && !this.#asked) this.#send();
  }

  end(): void {
    clearTimeout(this.#clock);
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#ready = false;
    this.#asked = this.#next = undefined;
  }

  #start(): void {
    const worker = new Worker(this.#script, { type: "module" });
    this.#worker = worker;
    worker.onmessage = ({ data }: MessageEvent<FromMine>) => this.#heard(data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.#over({ kind: "stopped", why: event.message || "a part of the page did not load" });
    };
    this.#limit(START_SECONDS);
    this.#post({ kind: "program", program: this.#program });
  }

  #post(message: ToMine): void {
    this.#worker?.postMessage(message);
  }

  #limit(seconds: number): void {
    clearTimeout(this.#clock);
    this.#clock = setTimeout(() => this.#over({ kind: "late" }), 1000 * seconds);
  }

  #send(): void {
    const question = this.#next;
    this.#next = undefined;
    if (!question) return;
    this.#asked = question;
    this.#limit(ANSWER_SECONDS);
    this.#post({ kind: "given", numbers: question.numbers });
  }

  #heard(message: FromMine): void {
    clearTimeout(this.#clock);
    const book = (this.#asked ?? this.#next)?.book ?? {};
    this.#asked = undefined;
    if (message.kind !== "ready") this.#answered(message, book);
    // Also after an early end: the worker makes a new instance for each question that follows.
    this.#ready = true;
    this.#send();
  }

  /** The thread is lost; a question that came meanwhile begins another. */
  #over(answer: MineAnswer): void {
    const next = this.#asked ? this.#next : undefined;
    const book = (this.#asked ?? this.#next)?.book ?? {};
    this.end();
    this.#answered(answer, book);
    if (next) this.ask(next);
  }
}
