// "Order": the lines of each function, shuffled, with some that do not belong: move buttons, arrow keys on a line, or
// dragging; a line can be left out.

import { button, html } from "../dom.ts";
import { moved } from "../order.ts";
import { colour } from "./colour.ts";
import { type FormData, fixedTexts, lineText, orderedText, type Put } from "./form-data.ts";

export interface OrderForm {
  readonly element: HTMLElement;
  readonly order: readonly (readonly Put[])[];
  text(): string;
  /** Shows below each line that does not belong and was not left out the question of its misconception. */
  ask(hints: Readonly<Record<string, string>>): void;
}

interface Row {
  readonly element: HTMLLIElement;
  readonly out: HTMLButtonElement;
  readonly asked: HTMLElement;
}

export function orderForm(
  data: FormData,
  kept: readonly (readonly Put[])[] | undefined,
  changed: () => void,
): OrderForm {
  const order = data.runs.map((run, at): Put[] => {
    const begin = run.map((_, line) => ({ line, out: false }));
    return kept?.[at]?.length === run.length ? [...kept[at]] : begin;
  });
  const spoken = html("p", { class: "moved", role: "status" });
  const element = html("div", { class: "ordering" });
  const rows = data.runs.map((run, at) => run.map((_, line) => makeRow(at, line)));
  const lists = rows.map((_, at) => html("ol", { "aria-label": listName(at) }));
  for (const [at, text] of fixedTexts(data).entries()) {
    const code = html("pre");
    code.append(colour(text.replace(/^\n+|\n+$/g, "")));
    element.append(html("div", { class: "highlight fixed" }, code));
    if (lists[at]) element.append(lists[at]);
  }
  element.append(spoken);
  for (const at of lists.keys()) show(at);

  function listName(at: number): string {
    return rows.length === 1 ? "Lines to put in order" : `Lines of function ${at + 1}`;
  }

  function makeRow(at: number, line: number): Row {
    const text = lineText(data, data.runs[at]![line]!);
    const code = html("pre");
    code.append(colour(text.replace(/\n$/, "")));
    const up = button("↑", () => move(at, line, -1, up));
    const down = button("↓", () => move(at, line, 1, down));
    const out = button("Leave out", () => leaveOut(at, line));
    const name = text.trim().replace(/\s+/g, " ");
    up.setAttribute("aria-label", `Move up: ${name}`);
    down.setAttribute("aria-label", `Move down: ${name}`);
    out.setAttribute("aria-label", `Leave out: ${name}`);
    const asked = html("div", { class: "asked" });
    asked.hidden = true;
    const moves = html("span", { class: "moves" }, up, down, out);
    const row = html("li", {}, code, moves, asked);
    row.addEventListener("keydown", (event) => {
      const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
      if (!by) return;
      event.preventDefault();
      move(at, line, by, event.target as HTMLElement);
    });
    drag(row, at, line);
    return { element: row, out, asked };
  }

  const position = (at: number, line: number): number =>
    order[at]!.findIndex((put) => put.line === line);

  function move(at: number, line: number, by: number, keepFocus: HTMLElement): void {
    const from = position(at, line);
    const to = from + by;
    if (to < 0 || to >= order[at]!.length) return;
    order[at] = moved(order[at]!, from, to);
    show(at);
    keepFocus.focus();
    spoken.textContent = `Now line ${to + 1} of ${order[at].length}.`;
    changed();
  }

  function leaveOut(at: number, line: number): void {
    const put = order[at]![position(at, line)]!;
    order[at]![position(at, line)] = { line, out: !put.out };
    show(at);
    spoken.textContent = put.out ? "The line is in the function." : "The line is left out.";
    changed();
  }

  /** With the mouse or a pen; a finger scrolls, and has the buttons. */
  function drag(row: HTMLLIElement, at: number, line: number): void {
    row.addEventListener("pointerdown", (event) => {
      const onButton = (event.target as Element).closest("button");
      if (onButton || event.button !== 0 || event.pointerType === "touch") return;
      event.preventDefault();
      row.setPointerCapture(event.pointerId);
      row.classList.add("held");
    });
    row.addEventListener("pointermove", (event) => {
      if (!row.classList.contains("held")) return;
      const over = rows[at]!.findIndex(({ element: other }) => {
        const box = other.getBoundingClientRect();
        return other !== row && event.clientY > box.top && event.clientY < box.bottom;
      });
      if (over < 0) return;
      order[at] = moved(order[at]!, position(at, line), position(at, over));
      show(at);
      changed();
    });
    const end = (): void => row.classList.remove("held");
    row.addEventListener("pointerup", end);
    row.addEventListener("pointercancel", end);
  }

  /** Puts the rows in order without taking a held one out of the page, which would drop it. */
  function show(at: number): void {
    const list = lists[at]!;
    const held = rows[at]!.find(({ element: row }) => row.classList.contains("held"))?.element;
    const wanted = order[at]!.map(({ line }) => rows[at]![line]!.element);
    const middle = held ? wanted.indexOf(held) : wanted.length;
    for (const row of wanted.slice(0, middle)) list.insertBefore(row, held ?? null);
    for (const row of wanted.slice(middle)) if (row !== held) list.append(row);
    for (const [place, { line, out }] of order[at]!.entries()) {
      const { element: row, out: toggle } = rows[at]![line]!;
      row.classList.toggle("out", out);
      toggle.textContent = out ? "Put back" : "Leave out";
      const name = toggle.getAttribute("aria-label")!.replace(/^[^:]*/, toggle.textContent);
      toggle.setAttribute("aria-label", name);
      const [up, down] = row.querySelectorAll("button");
      up!.setAttribute("aria-disabled", String(place === 0));
      down!.setAttribute("aria-disabled", String(place === order[at]!.length - 1));
    }
  }

  return {
    element,
    get order() {
      return order;
    },
    text: () => orderedText(data, order),
    ask(hints) {
      for (const [at, run] of order.entries())
        for (const { line, out } of run) {
          const distractor = data.runs[at]![line]![1];
          const id = distractor === undefined ? "" : data.distractors[distractor]!.misconception;
          const { asked } = rows[at]![line]!;
          asked.hidden = out || !hints[id];
          asked.innerHTML = asked.hidden ? "" : hints[id]!;
        }
    },
  };
}
