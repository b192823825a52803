// In which form an exercise is answered: read the worked solution, order its lines, fill its gaps, or write it. What
// order and fill make is C++, and is checked like a text that was written.

import type { ExerciseData, VerdictJson } from "../cpp/types.ts";
import { button, freshId, html } from "../dom.ts";
import { type Form, fingerprint, Work } from "../work.ts";
import { colour } from "./colour.ts";
import type { FillForm } from "./fill-form.ts";
import type { FormData } from "./form-data.ts";
import type { OrderForm } from "./order-form.ts";

const NAMES = ["read", "order", "fill", "write"] as const;
export type FormName = (typeof NAMES)[number];

const ABOUT: Record<FormName, string> = {
  read: "The book's solution, with the reason of each step on demand.",
  order: "Put the lines in order, and leave out those that do not belong. Then check.",
  fill: "Fill the gaps with C++. Then check.",
  write: "Write the function from the stub.",
};

export interface FormOptions {
  readonly id: string;
  readonly load: () => Promise<ExerciseData>;
  readonly failed: (error: unknown, again: () => void) => void;
  /** Another form, or another text in the present one. */
  readonly changed: () => void;
  readonly check: () => void;
  /** The text goes on in the editor. */
  readonly write: (text: string, form: Form) => void;
  /** Whether the solution may be shown without asking. */
  readonly solutionIsOpen: () => boolean;
  readonly solutionShown: () => void;
}

export class Forms {
  readonly tabs = html("div", { class: "forms", role: "tablist", "aria-label": "How to answer" });
  readonly panel = html("div", { class: "form", role: "tabpanel" });
  readonly #options: FormOptions;
  readonly #about = html("p", { class: "about" });
  readonly #body = html("div");
  readonly #file = html("details", { class: "assembled" });
  readonly #listing = html("pre", { tabindex: "0", role: "region", "aria-label": "The file" });
  readonly #buttons = new Map<FormName, HTMLButtonElement>();
  #form: FormName;
  #data: FormData | undefined;
  #order: OrderForm | undefined;
  #fill: FillForm | undefined;

  constructor(options: FormOptions) {
    this.#options = options;
    this.panel.id = freshId("form");
    for (const name of NAMES) {
      const label = name[0]!.toUpperCase() + name.slice(1);
      const tab = button(label, () => void this.choose(name));
      tab.setAttribute("role", "tab");
      tab.id = freshId("tab");
      tab.setAttribute("aria-controls", this.panel.id);
      tab.addEventListener("keydown", (event) => this.#turn(event, name));
      this.#buttons.set(name, tab);
      this.tabs.append(tab);
    }
    this.#file.append(
      html("summary", {}, "The whole file, as it is checked"),
      html("div", { class: "highlight" }, this.#listing),
    );
    this.panel.append(this.#about, this.#body, this.#file);
    // The page has keys of its own: / searches, and the arrows turn to other chapters.
    this.panel.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey)) return;
      event.preventDefault();
      options.check();
    });
    this.#form = "write";
    this.#show();
    const kept = Work.forms(options.id)?.form;
    const name = NAMES.find((one) => one === kept);
    if (name && name !== "write") void this.choose(name);
  }

  get form(): FormName {
    return this.#form;
  }

  /** The C++ of the form that is chosen; undefined if that is the editor's, or none. */
  text(): string | undefined {
    if (this.#form === "order") return this.#order?.text();
    return this.#form === "fill" ? this.#fill?.text() : undefined;
  }

  /** A sentence about what must be done before a check. */
  missing(): string | undefined {
    if (this.#form === "read") return "There is nothing to check here: choose another form.";
    return this.#form === "fill" ? this.#fill?.missing() : undefined;
  }

  async choose(name: FormName): Promise<void> {
    if (name === this.#form) return;
    try {
      if (name !== "write") await this.#load();
    } catch (error) {
      this.#options.failed(error, () => void this.choose(name));
      return;
    }
    this.#form = name;
    this.#keep();
    this.#show();
    if (name === "read") await this.#read();
    if (name === "order") await this.#makeOrder();
    if (name === "fill") await this.#makeFill();
    this.#changed();
  }

  /** Shows where the compiler points, in the file that was put together. */
  goTo(line: number): void {
    this.#file.open = true;
    this.#listing.querySelectorAll(".line")[line - 1]?.scrollIntoView({ block: "center" });
    this.#listing.focus({ preventScroll: true });
  }

  judged(verdict: VerdictJson, data: ExerciseData | undefined): void {
    if (this.#form !== "order" || !data) return;
    this.#order?.ask(verdict.verdict === "passed" ? {} : data.misconceptions);
  }

  /** The arrow keys go from tab to tab. */
  #turn(event: KeyboardEvent, name: FormName): void {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    const next = NAMES[(NAMES.indexOf(name) + by + NAMES.length) % NAMES.length]!;
    this.#buttons.get(next)!.focus();
    void this.choose(next);
  }

  async #load(): Promise<void> {
    const { form } = await this.#options.load();
    if (!form) throw new Error("the exercise has no forms");
    this.#data = form;
  }

  #show(): void {
    for (const [name, tab] of this.#buttons) {
      const chosen = name === this.#form;
      tab.setAttribute("aria-selected", String(chosen));
      tab.tabIndex = chosen ? 0 : -1;
      if (chosen) this.panel.setAttribute("aria-labelledby", tab.id);
    }
    this.#about.textContent = ABOUT[this.#form];
    this.#body.replaceChildren();
    this.#file.hidden = this.#form === "read" || this.#form === "write";
  }

  async #read(): Promise<void> {
    const { readForm } = await import("./read-form.ts");
    const worked = (): void => {
      if (this.#form === "read") this.#body.replaceChildren(readForm(this.#data!));
    };
    if (this.#options.solutionIsOpen()) {
      worked();
      return;
    }
    const words = "This shows the book's solution, and your record says that you have seen it.";
    const show = button("Show the worked solution", () => {
      this.#options.solutionShown();
      worked();
      this.#body.querySelector("button")?.focus();
    });
    this.#body.replaceChildren(html("p", {}, words), html("div", { class: "buttons" }, show));
  }

  async #makeOrder(): Promise<void> {
    const { orderForm } = await import("./order-form.ts");
    this.#order ??= orderForm(this.#data!, this.#kept()?.order, () => this.#changed());
    if (this.#form === "order") this.#body.replaceChildren(this.#order.element, this.#below());
  }

  async #makeFill(): Promise<void> {
    const { fillForm } = await import("./fill-form.ts");
    this.#fill ??= fillForm(this.#data!, this.#kept()?.gaps ?? [], () => this.#changed());
    if (this.#form === "fill") this.#body.replaceChildren(this.#fill.element, this.#below());
  }

  #below(): HTMLElement {
    const form = this.#form as Form;
    const go = button("Continue in the editor", () => {
      const text = this.text() ?? "";
      void this.choose("write").then(() => this.#options.write(text, form));
    });
    const again = button("Start this form again", () => {
      if (form === "order") this.#order = undefined;
      else this.#fill = undefined;
      Work.setForms(this.#options.id, { ...this.#state(), [form === "order" ? form : "gaps"]: [] });
      void (form === "order" ? this.#makeOrder() : this.#makeFill()).then(() => this.#changed());
    });
    return html("div", { class: "buttons" }, go, again);
  }

  /** What the browser keeps of this exercise's forms, unless the book has changed them. */
  #kept(): ReturnType<typeof Work.forms> {
    const kept = Work.forms(this.#options.id);
    return kept?.of === this.#of() ? kept : undefined;
  }

  #of(): string {
    return this.#data ? fingerprint(JSON.stringify(this.#data)) : "";
  }

  #state(): Parameters<typeof Work.setForms>[1] {
    const kept = this.#kept();
    return {
      form: this.#form,
      of: this.#of(),
      order: this.#order?.order ?? kept?.order ?? [],
      gaps: this.#fill?.gaps ?? kept?.gaps ?? [],
    };
  }

  #keep(): void {
    if (this.#data) Work.setForms(this.#options.id, this.#state());
  }

  #changed(): void {
    this.#keep();
    const text = this.text();
    if (text !== undefined) {
      const lines = text.split("\n").map((line) => {
        const row = html("span", { class: "line" });
        row.append(colour(line), "\n");
        return row;
      });
      this.#listing.replaceChildren(...lines);
    }
    this.#options.changed();
  }
}
