// Hints one at a time. Those that were shown before are there again, folded.

import { html } from "../dom.ts";

export class Hints {
  readonly element = html("div", { class: "hints" });
  readonly #hints: readonly Node[][];
  #shown = 0;

  constructor(hints: readonly Node[][], shown: number) {
    this.#hints = hints;
    this.showUpTo(shown);
  }

  get left(): number {
    return this.#hints.length - this.#shown;
  }

  /** Those that were shown elsewhere are here too, folded. */
  showUpTo(number: number): void {
    while (this.#shown < Math.min(number, this.#hints.length)) this.#append(false);
  }

  /** Shows one more; says which it is. */
  more(): string {
    if (this.#hints.length === 0)
      return "This exercise has no hints: it is meant to be done without.";
    if (this.left === 0) {
      for (const folded of this.element.querySelectorAll("details")) folded.open = true;
      return "These are all the hints.";
    }
    this.#append(true);
    return `Hint ${this.#shown} of ${this.#hints.length} is below.`;
  }

  #append(open: boolean): void {
    const hint = this.#hints[this.#shown]!;
    this.#shown += 1;
    const label = `Hint ${this.#shown} of ${this.#hints.length}`;
    const folded = html("details", {}, html("summary", {}, label), ...hint);
    folded.open = open;
    this.element.append(folded);
  }
}
