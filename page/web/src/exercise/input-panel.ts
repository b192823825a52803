// "Your input as numbers": fields for what each function of an exercise that breaks code returns. A button writes them
// into the editor as the body of that function, so that what is checked is always the code.

import type { ContactFigure } from "../contact-figure.ts";
import { button, html } from "../dom.ts";
import { parseNumber, type Vec2 } from "../numbers.ts";
import { bodyOf, type Member, type Value, withBody } from "./input-code.ts";
import { Pad } from "./input-pad.ts";

type Numbers = number | readonly number[] | readonly (readonly number[])[];

/** One of exercise.toml's [[inputs]], as the page has it. */
export interface InputSpec {
  readonly function: string;
  readonly says: string;
  /** What the fields begin with; it has the shape of the result. */
  readonly start: Numbers | Readonly<Record<string, Numbers>>;
  /** A figure of the page, NN_slug/NAME, and its fields: of the points, or by member. */
  readonly figure: string;
  readonly from: readonly string[] | Readonly<Record<string, string>>;
}

/** The editor's text, and what to say. */
export interface PanelHost {
  text(): string;
  replace(text: string): void;
  say(words: string): void;
}

type Changing = string | string[] | string[][];

const typed = (value: Numbers): Changing =>
  typeof value === "number" ? String(value) : (value.map((part) => typed(part)) as Changing);
const isList = (value: Changing | undefined): value is string[][] =>
  Array.isArray(value) && Array.isArray(value[0]);
const AXES = ["x", "y", "z"];

class Field {
  readonly element = html("fieldset");
  readonly #spec: InputSpec;
  readonly #host: PanelHost;
  readonly #members: Map<string, Changing>;
  readonly #body = html("div", { class: "members" });
  /** Whether the code has these numbers: Check sees the code only. */
  readonly #unwritten = html("span", { class: "unwritten" });

  constructor(spec: InputSpec, host: PanelHost) {
    this.#spec = spec;
    this.#host = host;
    const { start } = spec;
    const members: [string, Numbers][] =
      typeof start === "object" && !Array.isArray(start)
        ? Object.entries(start as Readonly<Record<string, Numbers>>)
        : [["", start as Numbers]];
    this.#members = new Map(members.map(([name, value]) => [name, typed(value)]));
    const buttons = html("div", { class: "buttons" });
    buttons.append(button("Write them into the code", () => this.#write()));
    if (spec.figure) buttons.append(button("Take them from the figure", () => void this.#take()));
    buttons.append(this.#unwritten);
    this.element.append(html("legend", {}, spec.says), this.#body, buttons);
    this.#draw();
  }

  get #value(): Value {
    const alone = this.#members.get("");
    return (alone ?? Object.fromEntries(this.#members)) as Value;
  }

  #changed(): void {
    this.#unwritten.textContent = "Changed, and not in the code yet.";
  }

  #draw(): void {
    const parts = [...this.#members].map(([name, value]) =>
      isList(value) ? this.#points(name, value) : this.#row(name, value as string | string[]),
    );
    this.#body.replaceChildren(...parts);
  }

  #number(label: string, value: string, changed: (text: string) => void): HTMLInputElement {
    const input = html("input", { type: "text", inputmode: "decimal", "aria-label": label });
    input.value = value;
    input.autocomplete = "off";
    input.addEventListener("input", () => {
      changed(input.value);
      this.#changed();
    });
    return input;
  }

  /** A number or a vector; a list of numbers, which is alone, may grow and shrink. */
  #row(name: string, value: string | string[]): HTMLElement {
    const line = html("div", { class: "row" });
    if (name) line.append(html("code", {}, name));
    if (typeof value === "string") {
      line.append(this.#number(name, value, (text) => void this.#members.set(name, text)));
      return line;
    }
    for (const [i, part] of value.entries()) {
      const label = name ? `${name}, ${AXES[i] ?? i}` : `number ${i}`;
      line.append(
        this.#number(label, part, (text) => {
          value[i] = text;
        }),
      );
    }
    if (name) return line;
    const remove = button("Remove the last", () => this.#change(value, () => value.pop()));
    remove.disabled = value.length === 1;
    const add = button("Add a number", () => this.#change(value, () => value.push("0")));
    line.append(remove, add);
    return line;
  }

  #points(name: string, value: string[][]): HTMLElement {
    const size = value[0]?.length ?? 2;
    const rows = html("div", { class: "rows" });
    const box = html("div", { class: "points" });
    let pad: Pad | undefined;
    const inputs: HTMLInputElement[][] = value.map((point, i) =>
      point.map((part, axis) =>
        this.#number(`${name} point ${i}, ${AXES[axis] ?? axis}`.trim(), part, (text) => {
          point[axis] = text;
          pad?.refresh();
        }),
      ),
    );
    for (const [i, cells] of inputs.entries()) {
      const remove = button("−", () => this.#change(value, () => value.splice(i, 1)));
      remove.setAttribute("aria-label", `Remove point ${i}`);
      remove.disabled = value.length === 1;
      rows.append(html("div", { class: "row" }, html("code", {}, String(i)), ...cells, remove));
    }
    const copy = (): string[] => [...(value.at(-1) ?? Array<string>(size).fill("0"))];
    const add = button("Add a point", () => this.#change(value, () => value.push(copy())));
    rows.append(add);
    if (name) box.append(html("code", {}, name));
    if (size === 2) {
      const at = (point: readonly string[]): Vec2 => [
        parseNumber(point[0] ?? "") ?? Number.NaN,
        parseNumber(point[1] ?? "") ?? Number.NaN,
      ];
      pad = new Pad({
        label: `${this.#spec.says}: points to be dragged`,
        points: () => value.map(at),
        moved: (i, to) => {
          for (const axis of [0, 1] as const) {
            value[i]![axis] = String(to[axis]);
            inputs[i]![axis]!.value = String(to[axis]);
          }
          this.#changed();
        },
      });
      box.append(pad.element as unknown as Node);
    }
    box.append(rows);
    return box;
  }

  #change(value: unknown[], change: () => void): void {
    change();
    this.#changed();
    const at = this.#body.querySelectorAll("button").length;
    this.#draw();
    const buttons = this.#body.querySelectorAll("button");
    buttons[Math.min(at, buttons.length) - 1]?.focus({ preventScroll: true });
    this.#host.say(`${value.length} in the list.`);
  }

  #write(): void {
    const name = this.#spec.function;
    let body: string;
    try {
      body = bodyOf(this.#value);
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      this.#host.say(`“${error.message}” is not a number. Write it like 0.25, -1e-9 or 0x1p-53.`);
      return;
    }
    const text = withBody(this.#host.text(), name, body);
    if (text === undefined) {
      this.#host.say(`Your code does not define ${name}() any more. Reset brings it back.`);
      return;
    }
    this.#host.replace(text);
    this.#unwritten.textContent = "";
    this.#host.say(`${name}() returns these numbers now. Check tells whether they break the code.`);
  }

  async #take(): Promise<void> {
    const { figure, from } = this.#spec;
    const element = document.querySelector<ContactFigure>(
      `contact-figure[name="${CSS.escape(figure)}"]`,
    );
    try {
      await element?.ready;
    } catch {
      // The figure says itself why it is not there.
    }
    const input = element?.input;
    if (!input) {
      this.#host.say("The figure is not loaded. Scroll to it first.");
      return;
    }
    const of = (field: string): Member => typed(input[field] as Numbers) as Member;
    if (Array.isArray(from)) this.#members.set("", from.map(of) as string[][]);
    else
      for (const [name, field] of Object.entries(from as Readonly<Record<string, string>>))
        this.#members.set(name, of(field) as Changing);
    this.#draw();
    this.#changed();
    this.#host.say("These are the figure's numbers as it shows them now.");
  }
}

/** The panel, folded until it is wanted. */
export function inputPanel(specs: readonly InputSpec[], host: PanelHost): HTMLElement {
  const panel = html("details", { class: "input-panel", open: "" });
  panel.append(html("summary", {}, "Your input as numbers"));
  for (const spec of specs) panel.append(new Field(spec, host).element);
  return panel;
}
