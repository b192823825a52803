// "Earlier versions": what was put aside, newest first, each with a button that brings it back.

import { button, html } from "../dom.ts";
import type { Version, Why } from "../work.ts";

const REASONS: Record<Why, string> = {
  checked: "as you checked it",
  reset: "before you began again",
  solution: "before you took the solution",
  import: "before an import",
  "other-tab": "from another tab",
};

/** A time as the reader's own clock has it. */
export function when(iso: string): string {
  const date = new Date(iso);
  if (Number.isNaN(date.getTime())) return "an unknown time";
  const sameDay = date.toDateString() === new Date().toDateString();
  const time = date.toLocaleTimeString("en-GB", { hour: "2-digit", minute: "2-digit" });
  if (sameDay) return `today at ${time}`;
  const day = date.toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" });
  return `${day} at ${time}`;
}

export class Versions {
  readonly element = html("details", { class: "versions" });
  readonly #bringBack: (version: Version) => void;

  constructor(bringBack: (version: Version) => void) {
    this.#bringBack = bringBack;
  }

  show(versions: readonly Version[], present: string): void {
    const others = versions.filter(({ text }) => text !== present);
    this.element.hidden = others.length === 0;
    const rows = others.map((version) => {
      const lines = version.text.trimEnd().split("\n").length;
      const words = `${when(version.at)}, ${REASONS[version.why] ?? "put aside"}: ${lines} lines `;
      const back = button("Bring back", () => this.#bringBack(version));
      back.setAttribute("aria-label", `Bring back the version of ${when(version.at)}`);
      return html("li", {}, words, back);
    });
    const summary = html("summary", {}, `Earlier versions (${others.length})`);
    const focused = this.element.contains(document.activeElement);
    this.element.replaceChildren(summary, html("ul", {}, ...rows));
    if (focused) summary.focus({ preventScroll: true });
  }
}
