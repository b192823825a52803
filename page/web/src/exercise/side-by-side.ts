// Shows the contract beside the code on a screen without space for it beside the book's columns: on request these are
// hidden. One choice for all exercises, stored.

import { button } from "../dom.ts";

const KEY = "contact-hours/1/side-by-side";
const WIDE = "side-by-side";

function kept(): boolean {
  try {
    return localStorage.getItem(KEY) === "1";
  } catch {
    return false;
  }
}

function keep(wide: boolean): void {
  try {
    localStorage.setItem(KEY, wide ? "1" : "0");
  } catch {
    // The choice holds for this page alone.
  }
}

/** A switch for one bench; it is shown only where it does something (exercise.css). */
export function sideBySideSwitch(): HTMLButtonElement {
  const { classList } = document.body;
  classList.toggle(WIDE, kept());
  const label = "Contract beside the code";
  const element = button(label, () => {
    const before = element.getBoundingClientRect().top;
    const wide = classList.toggle(WIDE);
    keep(wide);
    for (const other of document.querySelectorAll("contact-exercise .beside"))
      other.setAttribute("aria-pressed", String(wide));
    // The whole page has new lines; what the reader looked at stays where it was.
    scrollBy({ top: element.getBoundingClientRect().top - before, behavior: "instant" });
  });
  element.classList.add("beside");
  element.setAttribute("aria-pressed", String(classList.contains(WIDE)));
  return element;
}
