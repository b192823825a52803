// <contact-exercise name="NN_slug/NAME" base="…/_static/contact/">…listings, points, hints…</…>
//
// Makes the bench of what the page has without a script. `state` says what goes on (idle, loading,
// compiling, running, done), `verdict` what the last check came to.

import { Bench } from "./exercise/bench.ts";
import { readParts } from "./exercise/parts.ts";

export class ContactExercise extends HTMLElement {
  #bench: Bench | undefined;

  connectedCallback(): void {
    if (this.#bench) return;
    const parts = readParts(this);
    if (parts) this.#bench = new Bench(this, parts);
  }
}
