// What the reader's function answers, beside the book's, under the numbers of a figure.

import { button, freshId, html } from "../dom.ts";
import type { Fields } from "../layout.ts";
import { pretty, prettyVector } from "../numbers.ts";
import { booksOwn, type Found, same, type Tie } from "./mine-program.ts";

const SPEAK_AFTER = 600;

function textOf(found: Found): string {
  if (!found) return "none";
  const [first = Number.NaN] = found.numbers;
  if (found.kind === "truth") return first ? "yes" : "no";
  return found.numbers.length === 1 ? pretty(first) : prettyVector(found.numbers);
}

/** With all their digits, if fewer would make two that differ look the same. */
function exactText(found: Found): string {
  if (found?.kind !== "numbers") return textOf(found);
  const texts = found.numbers.map((value) => String(value).replace("-", "\u2212"));
  return texts.length === 1 ? texts[0]! : `(${texts.join(", ")})`;
}

export class MinePanel {
  readonly element: HTMLElement;
  readonly #tie: Tie;
  readonly #body = html("tbody");
  readonly #table: HTMLTableElement;
  readonly #words = html("p", { class: "mine-words" });
  readonly #spoken = html("p", { class: "spoken", "aria-live": "polite" });
  #speaking: ReturnType<typeof setTimeout> | undefined;

  constructor(tie: Tie, title: string, toCode: () => void, back: () => void) {
    this.#tie = tie;
    const heading = html("p", { class: "mine-title", id: freshId("mine") }, "Your code, ");
    heading.append(html("span", {}, title), ", beside the book’s");
    const head = html("tr", {}, html("td"));
    for (const words of ["Yours", "The book’s"]) head.append(html("th", { scope: "col" }, words));
    this.#table = html("table", {}, html("thead", {}, head), this.#body);
    const call = html("code", {}, tie.call);
    const buttons = html("div", { class: "buttons" });
    buttons.append(button("To my code", toCode), button("The book’s alone", back));
    this.element = html("div", { class: "mine", role: "group", "aria-labelledby": heading.id });
    this.element.tabIndex = -1;
    this.element.append(heading, html("p", { class: "mine-call" }, call), this.#table);
    this.element.append(this.#words, buttons, this.#spoken);
    this.#table.hidden = true;
  }

  /** A sentence in the place of numbers. */
  say(words: string, state: "busy" | "trouble"): void {
    this.#table.hidden = true;
    this.element.setAttribute("state", state);
    this.#tell(words);
  }

  show(rows: readonly Found[], output: Fields): void {
    const differing: string[] = [];
    let compared = 0;
    const lines = this.#tie.rows.map((row, i) => {
      if (row.asked && !output[row.asked]) {
        const line = html("tr", {}, html("th", { scope: "row" }, row.label));
        line.append(html("td", {}, "–"), html("td", {}, "–"));
        return line;
      }
      compared++;
      const mine = rows[i];
      const book = booksOwn(row, output, mine?.kind ?? "numbers");
      const equal = same(mine, book);
      if (!equal) differing.push(row.label);
      const alike = !equal && textOf(mine) === textOf(book);
      const text = alike ? exactText : textOf;
      const own = html("td", {}, text(mine));
      if (!equal) own.append(" ", html("strong", { class: "differs" }, "≠"));
      const line = html("tr", {}, html("th", { scope: "row" }, row.label), own);
      line.append(html("td", {}, text(book)));
      line.classList.toggle("different", !equal);
      return line;
    });
    if (compared === 0) {
      const words =
        "Your answer is not compared here: the figure’s own is rounded, or about another case.";
      this.say(words, "trouble");
      return;
    }
    this.#body.replaceChildren(...lines);
    this.#table.hidden = false;
    this.element.setAttribute("state", differing.length > 0 ? "different" : "same");
    this.#tell(
      differing.length > 0
        ? `Your answer differs from the book’s: ${differing.join("; ")}.`
        : "Your answer agrees with the book’s here: no number differs by more than 10⁻⁹, or by more than 10⁻⁹ of its size.",
    );
  }

  /** At once for the eyes; aloud only when the figure rests. */
  #tell(words: string): void {
    if (this.#words.textContent !== words) this.#words.textContent = words;
    clearTimeout(this.#speaking);
    this.#speaking = setTimeout(() => {
      if (this.#spoken.textContent !== words) this.#spoken.textContent = words;
    }, SPEAK_AFTER);
  }
}
