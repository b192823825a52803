// An answer in the reader's own words. Only the reader judges it: by the model answer, which follows,
// and by three criteria. What was written and marked is remembered and counts as nothing.

import type { Asker } from "./askers.ts";
import { html } from "./dom.ts";
import type { SayWhy } from "./question.ts";
import { mark, recall } from "./storage.ts";

export function sayWhyAsker(question: SayWhy, labelId: string): Asker {
  const before = recall(question.id);
  let compared = typeof before?.answer === "string" ? before.answer : "";
  const input = html("textarea", { rows: "4", "aria-labelledby": labelId });
  input.value = compared;
  const boxes = question.criteria.map((criterion, i) => {
    const box = html("input", { type: "checkbox" });
    box.checked = before?.marks?.[i] ?? false;
    box.addEventListener("change", () => mark(question.id, marks()));
    const text = html("span");
    text.innerHTML = criterion;
    return { box, row: html("label", { class: "option" }, box, text) };
  });
  const marks = () => boxes.map(({ box }) => box.checked);
  const below = html(
    "fieldset",
    { class: "criteria" },
    html("legend", {}, "Which of these does your answer say?"),
    ...boxes.map(({ row }) => row),
  );
  return {
    element: input,
    below,
    checkLabel: "Compare with a model answer",
    againLabel: "Change your answer",
    check() {
      const text = input.value.trim();
      if (text.split(/\s+/).length < 3) return { say: "Write a sentence first." };
      if (text !== compared) for (const { box } of boxes) box.checked = false;
      compared = text;
      return { kept: text, marks: marks(), say: "A model answer, to compare yours with:" };
    },
    lock(locked) {
      input.readOnly = locked;
    },
    focus: () => input.focus(),
    solution: () => "",
  };
}
