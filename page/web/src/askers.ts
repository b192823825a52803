// What each kind of question has in common for the element that asks it, and the simplest kind.

import { html } from "./dom.ts";
import type { Choose } from "./question.ts";
import type { Answered } from "./storage.ts";

export interface Answer {
  /** Left out where only the reader can judge. */
  readonly right?: boolean;
  /** HTML that answers the reader. */
  readonly say: string;
  /** What to remember; left out when there was no answer to judge. */
  readonly kept?: Answered["answer"];
  readonly marks?: readonly boolean[];
}

export interface Asker {
  readonly element: HTMLElement;
  readonly checkLabel?: string;
  readonly againLabel?: string;
  /** What stands below the explanation. */
  readonly below?: HTMLElement;
  check(): Answer;
  lock(locked: boolean): void;
  focus(): void;
  /** HTML of the right answer. */
  solution(): string;
  /** Registers what to do when the answer is sent from inside, as with Enter. */
  onSubmit?(send: () => void): void;
}

/** What an option says, for a name made of mathematics alone, which axe and some readers pass over. */
export function spoken(option: HTMLElement): string {
  const copy = option.cloneNode(true) as HTMLElement;
  for (const part of copy.querySelectorAll(".katex-html")) part.remove();
  return (copy.textContent ?? "").replace(/\s+/g, " ").trim();
}

export function chooseAsker(question: Choose, labelId: string): Asker {
  const inputs: HTMLInputElement[] = [];
  const element = html("fieldset", { role: "radiogroup", "aria-labelledby": labelId });
  for (const [i, option] of question.options.entries()) {
    const input = html("input", { type: "radio", name: labelId, value: String(i) });
    const text = html("span");
    text.innerHTML = option;
    if (text.querySelector("math")) input.setAttribute("aria-label", spoken(text));
    inputs.push(input);
    element.append(html("label", { class: "option" }, input, text));
  }
  return {
    element,
    check() {
      const chosen = inputs.findIndex((input) => input.checked);
      if (chosen < 0) return { right: false, say: "Choose one first." };
      const right = chosen === question.answer;
      const why = question.wrong?.find(({ answer }) => answer === chosen)?.why;
      return { right, kept: chosen, say: right ? "" : (why ?? "Another one is right.") };
    },
    lock(locked) {
      for (const input of inputs) input.disabled = locked;
    },
    focus: () => (inputs.find((input) => input.checked) ?? inputs[0])?.focus(),
    solution: () => `The answer: ${question.options[question.answer]}`,
  };
}
