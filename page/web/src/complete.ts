// A derivation or a table with gaps. Each gap is checked by itself, and what is right stays.

import type { Asker } from "./askers.ts";
import { html } from "./dom.ts";
import { judgeNumber, sendByEnter, shownKey, unitNote } from "./predict.ts";
import type { Complete } from "./question.ts";
import { escapeText } from "./shapes.ts";

export function completeAsker(question: Complete): Asker {
  const element = html("div", { class: "complete" });
  element.innerHTML = question.lines;
  const fields = question.gaps.map((gap) => {
    const input = html("input", {
      type: "text",
      autocomplete: "off",
      spellcheck: "false",
      placeholder: gap.unit ? "with unit" : "number",
      "aria-label": `${gap.label}: ${unitNote(gap.unit)}`,
    });
    element.querySelector(`.gap-${gap.id}`)?.replaceChildren(input);
    return { gap, input, right: false };
  });
  const left = () => fields.filter(({ right }) => !right);
  return {
    element,
    check() {
      const filled = left().filter(({ input }) => input.value.trim() !== "");
      if (filled.length === 0) return { right: false, say: "Fill a gap first." };
      const said: string[] = [];
      let wrong = false;
      for (const field of filled) {
        const { right = false, kept, say } = judgeNumber(field.input.value, field.gap);
        field.right = right;
        field.input.classList.toggle("right", right);
        if (right) field.input.removeAttribute("aria-invalid");
        else field.input.setAttribute("aria-invalid", "true");
        field.input.readOnly = right;
        wrong ||= !right && kept !== undefined;
        if (!right) said.push(`<em>${escapeText(field.gap.label)}:</em> ${say}`);
      }
      const kept = fields.map(({ input }) => input.value.trim());
      const open = left().length;
      if (open === 0) return { right: true, kept, say: "" };
      if (wrong) return { right: false, kept, say: said.join("<br>") };
      said.push(open === 1 ? "One gap is left." : `${open} gaps are left.`);
      left()[0]?.input.focus();
      return { right: false, say: said.join("<br>") };
    },
    lock(locked) {
      for (const { input, right } of fields) input.readOnly = locked || right;
    },
    focus: () => left()[0]?.input.select(),
    solution: () =>
      question.gaps
        .map((gap) => `<em>${escapeText(gap.label)}:</em> ${shownKey(gap)}`)
        .join("<br>"),
    onSubmit(send) {
      for (const { input } of fields) sendByEnter(input, send);
    },
  };
}
