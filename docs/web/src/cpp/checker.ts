// Checks an answer in the page. One checker serves all exercises of a page: one download, one compiler.

import {
  CheckerError,
  type CheckOptions,
  type ExerciseData,
  type Judge,
  type Size,
  type Tell,
  type VerdictJson,
} from "./types.ts";

export class Checker {
  static readonly #all = new Map<string, Checker>();
  readonly #base: string;

  private constructor(base: string) {
    this.#base = base;
  }

  /** The checker of a page; `base` is the address of …/_static/contact/. */
  static for(base: string): Checker {
    const address = new URL(base, document.baseURI).href;
    const known = Checker.#all.get(address) ?? new Checker(address);
    Checker.#all.set(address, known);
    return known;
  }

  /** What is still to be downloaded. Never downloads the toolchain. */
  size(): Promise<Size> {
    return Promise.reject(new CheckerError(`Nothing can be checked at ${this.#base} yet.`));
  }

  /** Downloads and starts what a check needs, so that the first check is quick. */
  prepare(_tell: Tell, _signal?: AbortSignal): Promise<void> {
    return Promise.reject(new CheckerError(`Nothing can be checked at ${this.#base} yet.`));
  }

  check(
    _data: ExerciseData,
    _source: string,
    _tell: Tell,
    _options: CheckOptions = {},
  ): Promise<VerdictJson> {
    return Promise.reject(new CheckerError(`Nothing can be checked at ${this.#base} yet.`));
  }

  /** The judge alone (about 100 kB), without the compiler. */
  judge(_data: ExerciseData): Promise<Judge> {
    return Promise.reject(new CheckerError(`Nothing can be checked at ${this.#base} yet.`));
  }
}
