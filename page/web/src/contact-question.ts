// <contact-question><script type="application/json">{…}</script>…fallback…</contact-question>
//
// Asks, checks and remembers. An answer is locked when it is checked; the verdict, the hint for a
// recognised mistake and, once right or given up, the explanation follow. The script has the key; the
// words are the fallback's and those of a template, which without a script nobody sees.

import { type Answer, type Asker, chooseAsker } from "./askers.ts";
import { completeAsker } from "./complete.ts";
import { constructAsker } from "./construct.ts";
import { button, freshId, html } from "./dom.ts";
import { orderAsker } from "./order-list.ts";
import { predictAsker } from "./predict.ts";
import type { Question } from "./question.ts";
import { sayWhyAsker } from "./say-why.ts";
import { recall, remember } from "./storage.ts";

const KINDS = {
  predict: "Predict",
  choose: "Choose",
  order: "Put in order",
  construct: "Construct",
  complete: "Complete",
  "say-why": "Say why",
} as const;

function askerFor(question: Question, labelId: string): Asker {
  switch (question.kind) {
    case "predict":
      return predictAsker(question, labelId);
    case "choose":
      return chooseAsker(question, labelId);
    case "order":
      return orderAsker(question, labelId);
    case "construct":
      return constructAsker(question);
    case "complete":
      return completeAsker(question);
    case "say-why":
      return sayWhyAsker(question, labelId);
  }
}

export class ContactQuestion extends HTMLElement {
  /** What is asked, from when the element is in the page. */
  question?: Question;

  connectedCallback(): void {
    if (this.question) return;
    const data = this.querySelector<HTMLScriptElement>(':scope > script[type="application/json"]');
    if (!data?.textContent) return;
    this.question = { ...JSON.parse(data.textContent), ...this.#words() };
    this.#build(this.question as Question);
  }

  /** The texts, as HTML, from the fallback for readers without scripts and from the template. */
  #words() {
    const fallback = this.querySelector(":scope > .question");
    const after = this.querySelector<HTMLTemplateElement>(":scope > template")?.content;
    const inside = (from: ParentNode | null | undefined, selector: string) =>
      [...(from?.querySelectorAll(selector) ?? [])].map((part) => part.innerHTML);
    const choices = inside(fallback, ":scope > ul > li");
    return {
      text: inside(fallback, ":scope > .asked")[0] ?? "",
      explain: inside(after, ".explain")[0] ?? "",
      options: choices,
      items: choices,
      lines: fallback?.querySelector(":scope > .lines, :scope > .wide")?.outerHTML ?? "",
      criteria: inside(after, ".criteria > li"),
    };
  }

  #build(question: Question): void {
    const labelId = freshId("question");
    const asker = askerFor(question, labelId);
    const verdict = html("div", { class: "verdict", role: "status" });
    const explain = html("div", { class: "explain" });
    const check = button(asker.checkLabel ?? "Check", () => tryAnswer());
    const again = button(asker.againLabel ?? "Try again", () => retry());
    const give = button("Show the answer", () => giveUp());

    const say = (right: boolean | undefined, words: string): void => {
      verdict.replaceChildren();
      const paragraph = html("p");
      if (right !== undefined) {
        const mark = right ? "Right." : "Not yet.";
        paragraph.append(html("strong", { class: right ? "right" : "wrong" }, mark), " ");
      }
      const text = html("span");
      text.innerHTML = words;
      paragraph.append(text);
      verdict.append(paragraph);
    };
    const show = (state: "open" | "wrong" | "right" | "given"): void => {
      asker.lock(state !== "open");
      this.toggleAttribute("locked", state !== "open");
      check.hidden = state !== "open";
      again.hidden = state === "open";
      give.hidden = state !== "wrong";
      if (state === "right" || state === "wrong") this.setAttribute("result", state);
      else this.removeAttribute("result");
      const explained = state === "right" || state === "given";
      explain.innerHTML = explained ? question.explain : "";
      if (asker.below) asker.below.hidden = !explained;
    };
    const judge = (answer: Answer): void => {
      if (answer.kept === undefined) {
        say(undefined, answer.say);
        return;
      }
      const { kept, right, marks, say: words } = answer;
      const known = { kind: question.kind, answer: kept, right: right ?? false };
      remember(question.id, marks ? { ...known, marks } : known);
      say(right, words);
      show(right === undefined ? "given" : right ? "right" : "wrong");
      again.focus({ preventScroll: true });
    };
    const tryAnswer = (): void => judge(asker.check());
    const retry = (): void => {
      verdict.replaceChildren();
      show("open");
      asker.focus();
    };
    const giveUp = (): void => {
      say(undefined, asker.solution());
      show("given");
      again.focus({ preventScroll: true });
    };

    const asked = html("div", { class: "asked", id: labelId });
    asked.innerHTML = question.text;
    asker.onSubmit?.(tryAnswer);
    const answer = html("div", { class: "answer" }, asker.element);
    const buttons = html("div", { class: "buttons" }, check, again, give);
    const kindId = freshId("kind");
    const kind = html("p", { class: "kind", id: kindId }, KINDS[question.kind]);
    // Each question has a button "Check": a screen reader says of which question.
    this.setAttribute("role", "group");
    this.setAttribute("aria-labelledby", `${kindId} ${labelId}`);
    const script = this.querySelector("script")!;
    const below = asker.below ? [asker.below] : [];
    const address = this.getAttribute("embed");
    const title = "This question alone, to put into a page of yours";
    const alone = address
      ? [html("a", { class: "embed-link", href: address, title }, "Embed")]
      : [];
    this.replaceChildren(
      script,
      ...alone,
      kind,
      asked,
      answer,
      buttons,
      verdict,
      explain,
      ...below,
    );
    show("open");
    const before = recall(question.id);
    if (before?.right) say(undefined, "You have answered this one right before.");
    else if (before && question.kind === "say-why")
      say(undefined, "This is what you wrote before.");
  }
}
