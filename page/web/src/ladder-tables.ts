// The tables of a ladder: the book's numbers, and the reader's own beside them.

import { html } from "./dom.ts";
import { type LadderResult, type LadderRow, methodName, withoutPeers } from "./ladder-data.ts";
import { pretty } from "./numbers.ts";

const ns = (value: number): string => pretty(value, 3);
const times = (row: LadderRow): string =>
  `${ns(row.ns_median)} (${ns(row.ns_q1)}–${ns(row.ns_q3)})`;
const count = ({ wrong, n }: LadderRow): string =>
  `${wrong.toLocaleString("en")} of ${n.toLocaleString("en")}`;

function names(result: LadderResult, row: LadderRow): string[] {
  const family = result.families.find(({ id }) => id === row.family);
  const method = result.methods.find(({ id }) => id === row.method);
  return [family?.title ?? row.family, method ? methodName(method) : row.method];
}

function table(caption: string, heads: readonly string[], rows: readonly string[][]): HTMLElement {
  const line = (kind: "th" | "td", texts: readonly string[]): HTMLElement =>
    html("tr", {}, ...texts.map((text) => html(kind, kind === "th" ? { scope: "col" } : {}, text)));
  return html(
    "table",
    { class: "docutils" },
    html("caption", {}, caption),
    html("thead", {}, line("th", heads)),
    html("tbody", {}, ...rows.map((row) => line("td", row))),
  );
}

/** All that was measured for the book. Errors have columns only if the ladder measures errors. */
export function bookNumbers(result: LadderResult): HTMLElement {
  const errors = (["error_median", "error_max"] as const).filter((key) =>
    result.results.some((row) => row[key] !== null),
  );
  const error = (value: number | null): string => (value === null ? "–" : pretty(value, 2));
  const heads = {
    error_median: "Median error",
    error_max: "Largest error",
  };
  return table(
    result.question,
    [
      "Inputs",
      "Method",
      "Wrong answers",
      ...errors.map((key) => heads[key]),
      "Time, ns: median (quartiles)",
    ],
    result.results.map((row) => [
      ...names(result, row),
      count(row),
      ...errors.map((key) => error(row[key])),
      times(row),
    ]),
  );
}

/** What was measured in the reader's browser. */
export function ownNumbers(result: LadderResult, rows: readonly LadderRow[]): HTMLElement {
  const body = rows.map((row) => {
    const book = withoutPeers(result).results.find(
      (other) => other.method === row.method && other.family === row.family,
    );
    return [...names(result, row), count(row), times(row), book ? ns(book.ns_median) : "–"];
  });
  const heads = ["Inputs", "Method", "Wrong", "Here, ns: median (quartiles)", "In the book, ns"];
  const peers = result.methods.some(({ peer }) => peer);
  return table(`WebAssembly${peers ? " and JavaScript" : ""} in this browser`, heads, body);
}
