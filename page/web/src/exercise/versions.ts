// "Earlier versions": what was put aside, newest first, each with a button that brings it back.

import { button, html } from "../dom.ts";
import { MAX_VERSIONS, type Said, type Version, type Why } from "../work.ts";
import { number } from "./points.ts";

const REASONS: Record<Why, string> = {
  checked: "as you checked it",
  reset: "before Reset",
  solution: "before you took the solution",
  form: "before you continued from another form",
  import: "before an import",
  "other-tab": "from one of two tabs",
};

const MOST = `At most ${MAX_VERSIONS} are kept, always with the last that passed and the one with the most points.`;

/** A time as the reader's own clock has it. */
export function when(iso: string, seconds = false): string {
  const date = new Date(iso);
  if (Number.isNaN(date.getTime())) return "an unknown time";
  const sameDay = date.toDateString() === new Date().toDateString();
  const time = date.toLocaleTimeString("en-GB", {
    hour: "2-digit",
    minute: "2-digit",
    ...(seconds ? { second: "2-digit" } : {}),
  });
  if (sameDay) return `today at ${time}`;
  const day = date.toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" });
  return `${day} at ${time}`;
}

function judgement({ verdict, points, max_points }: Said): string {
  if (verdict === "passed") return "passed";
  if (verdict === "does_not_compile") return "does not compile";
  if (verdict === "not_attempted") return "not attempted";
  return `${number(points)} of ${number(max_points)} points`;
}

function size(text: string): string {
  const lines = text.trimEnd().split("\n").length;
  return lines === 1 ? "1 line" : `${lines} lines`;
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
    const minutes = others.map(({ at }) => when(at));
    const rows = others.map((version, row) => {
      const shared = minutes.some((minute, other) => other !== row && minute === minutes[row]);
      const time = when(version.at, shared);
      const what = version.said ? judgement(version.said) : size(version.text);
      const words = `${time}, ${REASONS[version.why] ?? "put aside"}: ${what} `;
      const back = button("Bring back", () => this.#bringBack(version));
      back.setAttribute("aria-label", `Bring back the version of ${time}`);
      return html("li", {}, words, back);
    });
    const summary = html("summary", {}, `Earlier versions (${others.length})`);
    const focused = this.element.contains(document.activeElement);
    const most = html("p", {}, MOST);
    this.element.replaceChildren(summary, html("ul", {}, ...rows), most);
    if (focused) summary.focus({ preventScroll: true });
  }
}
