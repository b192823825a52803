// "Read": the solution piece by piece, each with its reason on demand.

import { button, html } from "../dom.ts";
import { colour } from "./colour.ts";
import { type FormData, isPiece } from "./form-data.ts";

export function readForm(data: FormData): HTMLElement {
  const rows = data.parts.map((part) => {
    const code = html("pre");
    code.append(colour(part.text.replace(/^\n+|\n+$/g, "")));
    if (!isPiece(part)) return html("div", { class: "fixed" }, code);
    const reason = html("details", {}, html("summary", {}, "Why?"), html("p", {}, part.reason));
    return html("div", { class: "piece" }, code, reason);
  });
  const reasons = rows.flatMap((row) => [...row.querySelectorAll("details")]);
  const all = button("Show every reason", () => {
    const open = reasons.some((reason) => !reason.open);
    for (const reason of reasons) reason.open = open;
    all.textContent = open ? "Hide every reason" : "Show every reason";
  });
  const code = html("div", { class: "highlight worked" }, ...rows);
  return html("div", {}, html("div", { class: "buttons" }, all), code);
}
