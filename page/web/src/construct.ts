// A construction: the reader moves the figure on the page until the book's own C++ says yes.

import type { Asker } from "./askers.ts";
import type { ContactFigure } from "./contact-figure.ts";
import { button, html } from "./dom.ts";
import type { Construct } from "./question.ts";

export function constructAsker(question: Construct): Asker {
  const status = html("p", { class: "goal" });
  const find = (): ContactFigure | null =>
    document.querySelector<ContactFigure>(`contact-figure[name="${CSS.escape(question.figure)}"]`);
  const go = button("Go to the figure", () => {
    const figure = find();
    figure?.scrollIntoView({ block: "center" });
    figure?.querySelector<HTMLElement>(".grip, input")?.focus({ preventScroll: true });
  });
  const element = html("div", {}, status, go);

  /** The goal as the C++ has it now; nothing while there is no live figure. */
  function goal(): number | undefined {
    const output = find()?.output;
    return output ? Number(output[question.goal]) : undefined;
  }
  function show(): void {
    const value = goal();
    status.classList.toggle("right", value !== undefined && value >= 1);
    status.textContent =
      value === undefined
        ? "Move the figure of this page until it does what is asked."
        : value >= 1
          ? "The figure does what is asked now."
          : "What is asked is not reached yet: change the figure.";
  }
  show();
  document.addEventListener("contact-change", (event) => {
    if (event.target === find()) show();
  });
  return {
    element,
    checkLabel: "Check the figure",
    check() {
      const value = goal();
      if (value === undefined)
        return {
          right: false,
          say: "The figure of this question is not loaded; scroll to it first.",
        };
      const right = value >= 1;
      return {
        right,
        kept: right,
        say: right ? "" : "What is asked is not reached yet: change the figure.",
      };
    },
    lock() {},
    focus: () => go.focus(),
    solution: () => "",
  };
}
