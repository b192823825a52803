// The numbers that the C++ gave, named as in the text, beside the drawing.

import { html, symbol } from "./dom.ts";
import type { Value } from "./figure.ts";
import type { FigureModel } from "./model.ts";
import { pretty, prettyVector } from "./numbers.ts";

export function valueText({ value, unit }: Value): string {
  if (typeof value === "string") return value;
  const text = typeof value === "number" ? pretty(value) : prettyVector(value);
  return unit ? `${text} ${unit}` : text;
}

/** The figure's values; with a problem there are none. */
export function currentValues({ figure, input, output, problem }: FigureModel): Value[] {
  return problem ? [] : figure.values(input, output);
}

export function makeValues(model: FigureModel): { element: HTMLElement; refresh(): void } {
  const body = html("tbody");
  const caption = html("caption", {}, "Computed by the book’s C++");
  const element = html("table", { class: "computed" }, caption, body);
  const cells: HTMLElement[] = [];
  const meanings: HTMLElement[] = [];
  const refresh = (): void => {
    const values = currentValues(model);
    if (values.length === 0) {
      for (const cell of cells) cell.textContent = "–";
      return;
    }
    if (values.length !== cells.length) {
      cells.length = meanings.length = 0;
      body.replaceChildren(...values.map((value) => valueRow(value, cells, meanings)));
    }
    values.forEach((value, i) => {
      const cell = cells[i]!;
      cell.textContent = valueText(value);
      cell.className = value.role ? `t-${value.role}` : "";
      meanings[i]!.textContent = value.meaning;
    });
  };
  return { element, refresh };
}

function valueRow(value: Value, cells: HTMLElement[], meanings: HTMLElement[]): HTMLElement {
  const cell = html("td");
  const meaning = html("span", { class: "meaning" });
  cells.push(cell);
  meanings.push(meaning);
  // Apart in what a screen reader reads, too.
  const name = html("th", { scope: "row" }, symbol(value.name), " ", meaning);
  return html("tr", {}, name, cell);
}
