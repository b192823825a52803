// A number with its unit, committed before anything is revealed.

import type { Asker } from "./askers.ts";
import { html } from "./dom.ts";
import { pretty } from "./numbers.ts";
import { parseQuantity, sameUnit } from "./order.ts";
import type { Predict } from "./question.ts";
import { escapeText } from "./shapes.ts";

export function predictAsker(question: Predict, labelId: string): Asker {
  const { answer, tolerance } = question;
  const unit = question.unit ?? "";
  const input = html("input", {
    type: "text",
    autocomplete: "off",
    spellcheck: "false",
    "aria-labelledby": labelId,
  });
  const words = unit ? "a number and its unit" : "a number without a unit";
  const element = html(
    "div",
    { class: "predict" },
    input,
    html("span", { class: "unit-note" }, words),
  );
  const close = (value: number, to: number): boolean => Math.abs(value - to) <= tolerance;
  return {
    element,
    check() {
      const given = parseQuantity(input.value);
      input.toggleAttribute("aria-invalid", !given);
      if (!given) return { right: false, say: "Begin with a number, such as −1.5 or 3/4." };
      if (unit && !given.unit) {
        const missing = question.wrong?.find((wrong) => wrong.answer === "unit")?.why;
        return { right: false, say: missing ?? "Give the unit too." };
      }
      const kept = input.value.trim();
      if (!sameUnit(given.unit, unit)) {
        const say = unit
          ? `The unit ${escapeText(given.unit)} does not measure what is asked.`
          : "The answer has no unit: it is a plain number.";
        return { right: false, kept, say };
      }
      if (close(given.value, answer)) return { right: true, kept, say: `It is ${shown()}.` };
      const wrong = question.wrong?.find(
        (item) => typeof item.answer === "number" && close(given.value, item.answer),
      );
      const sign = answer !== 0 && close(given.value, -answer);
      const say =
        wrong?.why ?? (sign ? "The size is right; look at the sign." : "It is another number.");
      return { right: false, kept, say };
    },
    lock(locked) {
      input.readOnly = locked;
    },
    focus: () => input.select(),
    solution: () => `The answer is ${shown()}.`,
    onSubmit(send) {
      input.addEventListener("keydown", (event) => {
        if (event.key !== "Enter" || input.readOnly) return;
        // The verdict moves the focus to a button, which this key must not press.
        event.preventDefault();
        send();
      });
    },
  };

  function shown(): string {
    return `${pretty(answer, 6)}${unit ? ` ${escapeText(unit)}` : ""}`;
  }
}
