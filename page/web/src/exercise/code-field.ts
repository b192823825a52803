// The reader's code: a listing until it is first clicked or focused, then an editor. Both look the same and have the
// same position.

import type { Diagnostic } from "../cpp/types.ts";
import { html } from "../dom.ts";
import { colour } from "./colour.ts";
import type { Editor } from "./editor.ts";

export interface FieldOptions {
  readonly text: string;
  readonly file: string;
  readonly title: string;
  readonly describedBy: string;
  readonly changed: () => void;
  readonly check: () => void;
  /** The editor could not be loaded. */
  readonly notLoaded: () => void;
}

export class CodeField {
  readonly element = html("div", { class: "code highlight" });
  readonly #options: FieldOptions;
  readonly #still = html("pre", { tabindex: "0", role: "textbox", "aria-multiline": "true" });
  readonly #numbers = html("div", { class: "numbers", "aria-hidden": "true" });
  #text: string;
  #editor: Editor | undefined;
  #loading: Promise<Editor> | undefined;
  #marks: readonly Diagnostic[] = [];

  constructor(options: FieldOptions) {
    this.#options = options;
    this.#text = options.text;
    this.#still.setAttribute("aria-label", `Your code: ${options.title}`);
    this.#still.setAttribute("aria-describedby", options.describedBy);
    this.#show();
    this.element.append(html("div", { class: "still" }, this.#numbers, this.#still));
    // The page has keys of its own: / searches, and the arrows turn to other chapters.
    this.element.addEventListener("keydown", (event) => event.stopPropagation());
    this.#still.addEventListener("focus", () => this.#wake());
    this.#still.addEventListener("click", ({ clientX: x, clientY: y }) => this.#wake({ x, y }));
  }

  get text(): string {
    return this.#editor?.text() ?? this.#text;
  }

  set text(text: string) {
    if (text === this.text) return;
    if (this.#editor) {
      this.#editor.replace(text);
      return;
    }
    this.#text = text;
    this.#show();
    this.#options.changed();
  }

  get inUse(): boolean {
    return this.element.contains(document.activeElement);
  }

  /** Marks what the compiler said; in a listing, as soon as it becomes an editor. */
  mark(messages: readonly Diagnostic[]): void {
    this.#marks = messages;
    this.#editor?.mark(messages);
  }

  /** Makes an editor of the listing, without taking the focus. */
  open(): void {
    void this.#open();
  }

  goTo(message: Diagnostic): void {
    void this.#open().then((editor) => editor.goTo(message));
  }

  #show(): void {
    this.#still.replaceChildren(colour(this.#text));
    this.#numbers.textContent = this.#text
      .split("\n")
      .map((_, index) => index + 1)
      .join("\n");
  }

  #open(): Promise<Editor> {
    this.#loading ??= this.#load();
    return this.#loading;
  }

  async #load(): Promise<Editor> {
    const { makeEditor } = await import("./editor.ts");
    const { file, title, describedBy, changed, check } = this.#options;
    const label = `Your code: ${title}`;
    const focused = this.inUse;
    const editor = makeEditor({ text: this.#text, file, label, describedBy, changed, check });
    this.#editor = editor;
    this.element.replaceChildren(editor.dom);
    editor.mark(this.#marks);
    if (focused) editor.focus();
    return editor;
  }

  #wake(at?: { x: number; y: number }): void {
    this.#open().then(
      (editor) => editor.focus(at),
      () => {
        // The next click tries again.
        this.#loading = undefined;
        this.#options.notLoaded();
      },
    );
  }
}
