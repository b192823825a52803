// A number with its unit, committed before anything is revealed.

import type { Answer, Asker } from "./askers.ts";
import { html } from "./dom.ts";
import { pretty } from "./numbers.ts";
import { inUnit, parseQuantity, sameUnit } from "./quantity.ts";
import type { NumberKey, Predict } from "./question.ts";
import { escapeText } from "./shapes.ts";

export function unitNote(unit: string): string {
  return unit ? "a number and its unit" : "a number without a unit";
}

/** The key with its unit, as HTML. */
export function shownKey({ answer, unit }: NumberKey): string {
  return `${pretty(answer, 6)}${unit ? ` ${escapeText(unit)}` : ""}`;
}

/** What to say to a number that was typed. */
export function judgeNumber(text: string, key: NumberKey): Answer {
  const { answer, tolerance, unit, wrong = [] } = key;
  const close = (value: number, to: number): boolean => Math.abs(value - to) <= tolerance;
  const given = parseQuantity(text);
  if (!given) return { right: false, say: "Begin with a number, such as −1.5 or 3/4." };
  if (unit && !given.unit) {
    const missing = wrong.find((item) => item.answer === "unit")?.why;
    return { right: false, say: missing ?? "Give the unit too." };
  }
  const kept = text.trim();
  const value = inUnit(given, unit);
  if (value === undefined) {
    const say = unit
      ? `The unit ${escapeText(given.unit)} does not measure what is asked.`
      : "The answer has no unit: it is a plain number.";
    return { right: false, kept, say };
  }
  if (key.convert === false && !sameUnit(given.unit, unit))
    return { right: false, kept, say: `Give it in ${escapeText(unit)}.` };
  if (close(value, answer)) return { right: true, kept, say: `It is ${shownKey(key)}.` };
  const known = wrong.find((item) => typeof item.answer === "number" && close(value, item.answer));
  const sign = answer !== 0 && close(value, -answer);
  const say =
    known?.why ?? (sign ? "The size is right; look at the sign." : "It is another number.");
  return { right: false, kept, say };
}

/** Sends the answer when Enter is pressed in the field. */
export function sendByEnter(input: HTMLInputElement, send: () => void): void {
  input.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || input.readOnly) return;
    // The verdict moves the focus to a button, which this key must not press.
    event.preventDefault();
    send();
  });
}

export function predictAsker(question: Predict, labelId: string): Asker {
  const input = html("input", {
    type: "text",
    autocomplete: "off",
    spellcheck: "false",
    "aria-labelledby": labelId,
  });
  const element = html(
    "div",
    { class: "predict" },
    input,
    html("span", { class: "unit-note" }, unitNote(question.unit)),
  );
  return {
    element,
    check() {
      input.toggleAttribute("aria-invalid", !parseQuantity(input.value));
      return judgeNumber(input.value, question);
    },
    lock(locked) {
      input.readOnly = locked;
    },
    focus: () => input.select(),
    solution: () => `The answer is ${shownKey(question)}.`,
    onSubmit: (send) => sendByEnter(input, send),
  };
}
