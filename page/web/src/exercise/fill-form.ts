// "Fill": the solution with gaps to type into.

import { html } from "../dom.ts";
import { colour } from "./colour.ts";
import { aroundGaps, type FormData, filledText } from "./form-data.ts";

export interface FillForm {
  readonly element: HTMLElement;
  readonly gaps: readonly string[];
  text(): string;
  /** A sentence about what is still empty. */
  missing(): string | undefined;
}

const MIN_WIDTH = 12;

export function fillForm(data: FormData, gaps: readonly string[], changed: () => void): FillForm {
  const [first, ...after] = aroundGaps(data);
  const code = html("pre");
  code.append(colour(first!));
  const fields = after.map((text, at) => {
    const field = html("input", {
      type: "text",
      "aria-label": `Gap ${at + 1} of ${after.length}`,
      autocapitalize: "off",
      autocomplete: "off",
      autocorrect: "off",
      spellcheck: "false",
    });
    field.value = gaps[at] ?? "";
    const fit = (): void => {
      field.style.width = `${Math.max(MIN_WIDTH, field.value.length + 1)}ch`;
    };
    field.addEventListener("input", () => {
      fit();
      changed();
    });
    fit();
    code.append(field, colour(text));
    return field;
  });
  const values = (): string[] => fields.map(({ value }) => value);
  return {
    element: html("div", { class: "highlight gaps" }, code),
    get gaps() {
      return values();
    },
    text: () => filledText(data, values()),
    missing() {
      const empty = fields.flatMap(({ value }, at) => (value.trim() ? [] : [at + 1]));
      if (empty.length === 0) return undefined;
      fields[empty[0]! - 1]!.focus();
      return empty.length === 1
        ? `Gap ${empty[0]} is still empty.`
        : `Gaps ${empty.join(", ")} are still empty.`;
    },
  };
}
