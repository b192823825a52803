// The buttons and sentences about keeping the book, for the page of the reader's work.

import { button, html } from "../dom.ts";
import { Replaced } from "./keep.ts";
import { type OfflineBook, type Standing, sizeText, transferOf, whyNot } from "./offline.ts";

const day = (time: string): string =>
  new Date(time).toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" });

/** Why it broke off, for the reader. */
function inWords(error: unknown): string {
  if (error instanceof Replaced) return error.message;
  const name = error instanceof Error ? error.name : "";
  if (name === "AbortError")
    return "Stopped. What has arrived is kept, and will not be fetched again.";
  if (name === "QuotaExceededError")
    return "There is no more room for this site in this browser. What has arrived is kept; free some space, or leave the compiler out.";
  return "The network broke off. What has arrived is kept; try again, and it goes on from there.";
}

function whatIsKept({ whole, kept, list, compiler }: Standing): string {
  const weighs = `${kept.files} ${kept.files === 1 ? "file" : "files"}, ${sizeText(kept.bytes)}`;
  const tools =
    compiler && compiler.missing.length === 0 && compiler.all.length > 0
      ? ` The compiler is kept, too (${sizeText(transferOf(compiler.all))}).`
      : "";
  if (kept.files === 0) return `Nothing of the book is kept for offline reading.${tools}`;
  if (!whole) return `The pages that you have visited are kept (${weighs}).${tools}`;
  const newer = list && list.version !== whole.version ? " There is a newer version of it." : "";
  return `The whole book is kept since ${day(whole.at)} (${weighs}).${newer}${tools}`;
}

/** That it is done, and what was left out. */
export function doneWords(compiler: Standing["compiler"]): string {
  return compiler && compiler.missing.length > 0
    ? "Done, without the compiler: the book can be read without a network, but Check will not work offline."
    : "Done: everything is kept, and can be read without a network.";
}

/** The controls, and how to make them look again at what is kept. */
export function offlineControls(book: OfflineBook): { element: HTMLElement; look: () => void } {
  const status = html("p", { role: "status" });
  const kept = html("p", { class: "kept" });
  const withCompiler = html("input", { type: "checkbox" });
  const compilerLabel = html("label", { class: "option" }, withCompiler, html("span"));
  const bar = html("progress", { "aria-label": "What has arrived" });
  const arrivedText = html("span", { class: "arrived" });
  const progress = html("div", { class: "progress" }, bar, arrivedText);
  let stopping = new AbortController();
  const keep = button("", () => void start());
  const stop = button("Stop", () => stopping.abort());
  const forget = button("Forget it", () => void remove());
  const buttons = html("div", { class: "buttons" }, keep, stop, forget);
  const box = html("div", { class: "offline" }, kept, compilerLabel, buttons, progress, status);
  let now: Standing | undefined;
  let chosen = false;

  const wanted = (): { transfer: number }[] => [
    ...(now?.book ?? []),
    ...(withCompiler.checked ? (now?.compiler?.missing ?? []) : []),
  ];

  function offer(): void {
    if (!now) return;
    const size = transferOf(wanted());
    const missing = now.compiler?.missing ?? [];
    compilerLabel.hidden = missing.length === 0;
    compilerLabel.lastElementChild!.textContent = `With the compiler, so that Check works offline (${sizeText(transferOf(missing))})`;
    keep.hidden = size === 0;
    const what = now.whole
      ? now.book.length > 0
        ? "Bring it up to date"
        : "Keep the compiler as well"
      : "Keep the whole book for offline reading";
    keep.textContent = `${what} (${sizeText(size)})`;
    forget.hidden = now.kept.files === 0;
  }

  async function look(): Promise<void> {
    now = await book.standing();
    // A reader who checks exercises here also needs the checker offline: only little is missing then, mainly the tests
    // of exercises.
    if (!chosen) withCompiler.checked = now.compiler?.inUse ?? false;
    kept.textContent = whatIsKept(now);
    offer();
    if (!now.list)
      status.textContent = "What the book consists of could not be read. Are you offline?";
  }

  function working(on: boolean): void {
    keep.disabled = on;
    forget.disabled = on;
    withCompiler.disabled = on;
    stop.hidden = !on;
    progress.hidden = !on;
  }

  async function start(): Promise<void> {
    stopping = new AbortController();
    const total = transferOf(wanted());
    let received = 0;
    const tell = (): void => {
      bar.value = Math.min(received, total);
      arrivedText.textContent = `${sizeText(Math.min(received, total))} of ${sizeText(total)}`;
    };
    bar.max = total;
    tell();
    working(true);
    stop.focus({ preventScroll: true });
    status.textContent = "Keeping the book …";
    let failure: string | undefined;
    try {
      await book.keep(
        withCompiler.checked,
        (bytes) => {
          received += bytes;
          tell();
        },
        stopping.signal,
      );
    } catch (error) {
      failure = inWords(error);
    }
    working(false);
    await look();
    status.textContent = failure ?? doneWords(now?.compiler);
    (keep.hidden ? forget : keep).focus({ preventScroll: true });
  }

  async function remove(): Promise<void> {
    working(true);
    await book.forget();
    working(false);
    await look();
    status.textContent = "Forgotten. Your own work is untouched.";
    keep.focus({ preventScroll: true });
  }

  withCompiler.addEventListener("change", () => {
    chosen = true;
    offer();
  });
  working(false);
  keep.hidden = true;
  forget.hidden = true;
  compilerLabel.hidden = true;
  const why = whyNot();
  if (why) kept.textContent = why;
  const lookAgain = (): void => {
    if (!why) void look();
  };
  lookAgain();
  return { element: box, look: lookAgain };
}
