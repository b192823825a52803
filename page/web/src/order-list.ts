// Steps to put in order: move buttons, arrow keys on a step, or dragging.

import { type Asker, spoken as wordsOf } from "./askers.ts";
import { button, html } from "./dom.ts";
import { moved, rightFromStart } from "./order.ts";
import type { Order } from "./question.ts";

export function orderAsker(question: Order, labelId: string): Asker {
  let order = question.items.map((_, i) => i);
  let locked = false;
  const spoken = html("p", { class: "unit-note", role: "status" });
  const list = html("ol", { class: "steps", "aria-labelledby": labelId });
  const rows = question.items.map((item, i) => step(item, i));
  const element = html("div", {}, list, spoken);

  function step(item: string, index: number): HTMLLIElement {
    const text = html("span", { class: "step" });
    text.innerHTML = item;
    const name = wordsOf(text);
    const up = button("↑", () => move(index, -1, up));
    const down = button("↓", () => move(index, 1, down));
    up.setAttribute("aria-label", `Move up: ${name}`);
    down.setAttribute("aria-label", `Move down: ${name}`);
    const row = html(
      "li",
      {},
      html("span", { class: "place", "aria-hidden": "true" }),
      text,
      up,
      down,
    );
    row.addEventListener("keydown", (event) => {
      const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
      if (!by || locked) return;
      event.preventDefault();
      event.stopPropagation();
      move(index, by, event.target as HTMLElement);
    });
    drag(row, index);
    return row;
  }

  function move(index: number, by: number, keepFocus: HTMLElement): void {
    const from = order.indexOf(index);
    const to = from + by;
    if (locked || to < 0 || to >= order.length) return;
    order = moved(order, from, to);
    show();
    keepFocus.focus();
    spoken.textContent = `Now step ${to + 1} of ${order.length}.`;
  }

  /** With the mouse or a pen; a finger scrolls, and has the buttons. */
  function drag(row: HTMLLIElement, index: number): void {
    row.addEventListener("pointerdown", (event) => {
      const onButton = (event.target as Element).closest("button");
      if (locked || onButton || event.button !== 0 || event.pointerType === "touch") return;
      event.preventDefault();
      row.setPointerCapture(event.pointerId);
      row.classList.add("held");
    });
    row.addEventListener("pointermove", (event) => {
      if (!row.classList.contains("held")) return;
      const over = rows.findIndex((other) => {
        const box = other.getBoundingClientRect();
        return other !== row && event.clientY > box.top && event.clientY < box.bottom;
      });
      if (over < 0) return;
      order = moved(order, order.indexOf(index), order.indexOf(over));
      show();
      row.setPointerCapture(event.pointerId);
    });
    const end = (): void => row.classList.remove("held");
    row.addEventListener("pointerup", end);
    row.addEventListener("pointercancel", end);
  }

  /** Puts the rows in order without taking the moved one out of the page, which would drop it. */
  function show(): void {
    for (const [place, index] of order.entries()) {
      const row = rows[index]!;
      row.querySelector(".place")!.textContent = `${place + 1}.`;
      if (list.children[place] === row) continue;
      const held = rows.find((other) => other.classList.contains("held"));
      if (held !== row || !held) list.insertBefore(row, list.children[place] ?? null);
      else
        for (const other of [...list.children].slice(place)) if (other !== row) list.append(other);
    }
    for (const [place, index] of order.entries()) {
      const [up, down] = rows[index]!.querySelectorAll("button");
      up!.disabled = locked || place === 0;
      down!.disabled = locked || place === order.length - 1;
    }
  }

  show();
  return {
    element,
    check() {
      const good = rightFromStart(order, question.answer);
      const right = good === order.length;
      const wrong = question.wrong?.find(
        ({ answer }) => Array.isArray(answer) && answer.join() === order.join(),
      );
      const start =
        good === 0
          ? "Another step comes first."
          : `The first ${good === 1 ? "step is" : `${good} steps are`} in place; then something else comes.`;
      return { right, kept: order, say: right ? "" : (wrong?.why ?? start) };
    },
    lock(now) {
      locked = now;
      show();
    },
    focus: () => list.querySelector<HTMLButtonElement>("button:not(:disabled)")?.focus(),
    solution() {
      const items = question.answer.map((index) => `<li>${question.items[index]}</li>`).join("");
      return `The order:<ol>${items}</ol>`;
    },
  };
}
