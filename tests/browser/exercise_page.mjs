// An exercise in a page, as a reader's eyes and hands meet it: its buttons, its editor, what it says.
// Everything goes through the page's own DOM, the keyboard and the mouse.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { book, exerciseEntry, wrongAnswers } from "../../page/wasm/book.mjs";
import { gatherTrouble, require, root } from "./browser.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").Locator} Locator */
/** @typedef {import("playwright-core").BrowserContext} BrowserContext */

/** A first check on a busy machine: download, start, compile without the precompiled header. */
export const PATIENCE = 120_000;

/** @param {string[]} parts */
const read = (...parts) => fs.readFileSync(path.join(root, ...parts), "utf8");
/** @param {string} id NN_slug/NAME */
const file = (id) => `${path.basename(id)}.cpp`;

/** @param {string} id */
export const stubOf = (id) => read("exercises", id, file(id));
/** As it is shown: without its marks. @param {string} id */
export const solutionOf = (id) => read("solutions", id, file(id)).replace(/^ *\/\/\?.*\n/gm, "");

/** Every wrong answer of an exercise, with what its first lines promise. @param {string} id */
export function wrongAnswersOf(id) {
  return wrongAnswers(id).map((file) => {
    const text = read(file);
    const said = (/** @type {string} */ what) =>
      /** @type {string} */ (text.match(new RegExp(`^// ${what}: (.*)$`, "m"))?.[1]);
    const name = path.basename(file);
    return { name, text, misconception: said("misconception"), caughtBy: said("caught by") };
  });
}

/** The tests of an exercise in their order, with their points. @param {string} id */
export function testsOf(id) {
  return exerciseEntry(id).tests.map(({ name, points }) => ({ name, points }));
}

/** What a student reads of a misconception, as text. @param {string} id */
export function hintFor(id) {
  const hint = book().misconceptions[id]?.hint;
  assert.ok(hint, `no misconception ${id}`);
  return plain(hint);
}

/** Without markup, and with one kind of quotation mark and space. @param {string} text */
export const plain = (text) =>
  text
    .replace(/[`*]|\\(?=")/g, "")
    .replace(/[“”]/g, '"')
    .replace(/[‘’]/g, "'")
    .replace(/\s+/g, " ")
    .trim();

/** A text with one part of it replaced, which must be there. @param {string} text @param {string} from @param {string} to */
export function changed(text, from, to) {
  assert.ok(text.includes(from), `no ${from} in\n${text}`);
  return text.replace(from, () => to);
}

/** The number of the line on which something stands. @param {string} text @param {string} part */
export function lineOf(text, part) {
  const at = text.indexOf(part);
  assert.ok(at >= 0, `no ${part} in\n${text}`);
  return text.slice(0, at).split("\n").length;
}

/** The page on which an exercise is. @param {string} id */
export const pageOf = (id) => `chapters/${path.dirname(id)}.html`;

/**
 * A page of a context that other pages share, and with them the toolchain that was downloaded.
 * @param {BrowserContext} context @param {string} origin @param {string} where
 */
export async function visit(context, origin, where) {
  const page = await context.newPage();
  const trouble = gatherTrouble(page, origin);
  await page.goto(`${origin}/${where}`, { waitUntil: "load" });
  return { page, trouble };
}

/** @param {Page} page @param {string} id */
export function exerciseOn(page, id) {
  const element = page.locator(`contact-exercise[name="${id}"]`);
  const content = element.locator(".code .cm-content");
  const attribute = (/** @type {string} */ name) => element.getAttribute(name);
  const button = (/** @type {string | RegExp} */ name) =>
    element.locator(".bench").getByRole("button", { name, exact: true });
  const press = (/** @type {string | RegExp} */ name) => button(name).click();

  /** Does something that ends in a verdict, and waits for it. @param {() => Promise<unknown>} act */
  async function untilDone(act) {
    // What a test that failed left behind.
    if (await button("Stop").isVisible()) await press("Stop");
    // The state is "done" from the last check as well: what counts is what it becomes after this one.
    const done = await element.evaluateHandle((node) => {
      const again = new Promise((resolve) => {
        let busy = false;
        new MutationObserver(() => {
          const state = node.getAttribute("state") ?? "";
          if (/loading|compiling|running/.test(state)) busy = true;
          else if (busy && state === "done") resolve(node.getAttribute("verdict"));
          else if (busy) resolve(`${state}: ${node.querySelector(".status")?.textContent}`);
        }).observe(node, { attributeFilter: ["state"] });
      });
      return { again };
    });
    await act();
    const verdict = done.evaluate(({ again }) => again);
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let timer;
    const late = new Promise((_, reject) => {
      timer = setTimeout(
        async () => reject(new Error(`no verdict: ${await attribute("state")}, ${await status()}`)),
        PATIENCE,
      );
    });
    try {
      return /** @type {string | null} */ (await Promise.race([verdict, late]));
    } finally {
      clearTimeout(timer);
      verdict.catch(() => {});
    }
  }

  /** Makes an editor of the code, as a click on it does, and puts the caret in it. */
  async function edit() {
    if (!(await content.count())) await element.locator(".code pre").first().click();
    await content.waitFor();
    await content.focus();
  }

  /** The code as the editor shows it. */
  async function text() {
    await content.waitFor();
    return (await content.locator(".cm-line").allTextContents()).join("\n");
  }

  /** Puts a whole file in the place of what is there. @param {string} source */
  async function paste(source) {
    await edit();
    await page.keyboard.press("ControlOrMeta+A");
    await page.evaluate((whole) => navigator.clipboard.writeText(whole), source);
    await page.keyboard.press("ControlOrMeta+V");
    assert.equal(await text(), source, "the editor holds what was pasted");
  }

  /** Selects a piece of the code with the mouse and types over it. @param {string} from @param {string} to */
  async function typeOver(from, to) {
    await edit();
    const line = content.locator(".cm-line").filter({ hasText: from }).first();
    await line.scrollIntoViewIfNeeded();
    await line.evaluate((node) => node.closest(".cm-scroller")?.scrollTo({ left: 0 }));
    const place = () =>
      line.evaluate((node, wanted) => {
        const start = (node.textContent ?? "").indexOf(wanted);
        const range = document.createRange();
        const walk = document.createTreeWalker(node, NodeFilter.SHOW_TEXT);
        let passed = 0;
        for (let piece = walk.nextNode(); piece; piece = walk.nextNode()) {
          const length = piece.textContent?.length ?? 0;
          if (start >= passed && start < passed + length) range.setStart(piece, start - passed);
          const end = start + wanted.length - passed;
          if (end > 0 && end <= length) range.setEnd(piece, end);
          passed += length;
        }
        const { left, right, top, bottom } = range.getBoundingClientRect();
        return { left, right, middle: (top + bottom) / 2 };
      }, from);
    /** A font that arrives, an editor that measures itself again, or a figure above that gets its height moves the text: like a reader, this waits until the text no longer moves, and if it has moved during the selection, selects again. */
    async function select() {
      let box = await place();
      for (let still = 0; still < 3; ) {
        await page.waitForTimeout(50);
        const now = await place();
        still = JSON.stringify(now) === JSON.stringify(box) ? still + 1 : 0;
        box = now;
      }
      await page.mouse.move(box.left + 0.5, box.middle);
      await page.mouse.down();
      await page.mouse.move(box.right - 0.5, box.middle, { steps: 5 });
      await page.mouse.up();
      return page.evaluate(() => String(getSelection()));
    }
    await page.evaluate(() => document.fonts.ready);
    let selected = await select();
    for (let again = 0; selected !== from && again < 4; ++again) {
      // What is selected would be dragged away, and a second press at once would take a whole word.
      await page.keyboard.press("ArrowRight");
      await page.waitForTimeout(1000);
      await line.scrollIntoViewIfNeeded();
      selected = await select();
    }
    assert.equal(selected, from, "the mouse selects what is to be replaced");
    await page.keyboard.type(to);
  }

  const status = async () => plain((await element.locator(".status").textContent()) ?? "");

  /** Each test's sentence with its mark. */
  const tests = () =>
    element.locator("ol.tests > li").evaluateAll((rows) =>
      rows.map((row) => ({
        status: row.getAttribute("data-status"),
        text: (row.textContent ?? "").replace(/\s+/g, " ").trim(),
      })),
    );

  /** What is said of a failure, as pairs of what it is and what it says, in the order of the page.
   * @param {Locator} where */
  const told = async (where) => {
    const pairs = await where
      .locator("dl")
      .evaluateAll((lists) =>
        lists.flatMap((list) =>
          [...list.querySelectorAll("dt")].map((term) => [
            term.textContent,
            term.nextElementSibling?.textContent,
          ]),
        ),
      );
    return pairs.map(([what, says]) => ({ what: plain(what ?? ""), says: plain(says ?? "") }));
  };
  /** The first failure, which is shown whole. */
  const failure = () => told(element.locator(".failure"));
  /** What is said of one test. @param {string} name */
  const failureOf = (name) => told(element.locator("ol.tests > li").filter({ hasText: name }));

  /** What the compiler said, as it is listed. */
  const messages = () =>
    element.locator(".messages > li").evaluateAll((rows) =>
      rows.map((row) => {
        const said = (/** @type {string} */ part) => row.querySelector(part)?.textContent ?? "";
        return {
          place: said(".place"),
          words: said(".words"),
          original: said("details > :not(summary)"),
          open: row.querySelector("details")?.open,
        };
      }),
    );

  /** The numbers of the lines that are marked in the editor, with what is marked. */
  const marks = () =>
    content.locator(".cm-line").evaluateAll((lines) =>
      lines.flatMap((line, index) => {
        const marked = [...line.querySelectorAll(".cm-lintRange, .cm-lintPoint")];
        return marked.length
          ? [{ line: index + 1, text: marked.map((mark) => mark.textContent).join("") }]
          : [];
      }),
    );

  return {
    page,
    element,
    content,
    attribute,
    button,
    press,
    untilDone,
    edit,
    text,
    paste,
    typeOver,
    status,
    tests,
    failure,
    failureOf,
    messages,
    marks,
    /** Presses Check and waits for the verdict. */
    check: () => untilDone(() => press("Check")),
    /** Pastes a whole file and checks it. @param {string} source */
    async submit(source) {
      await paste(source);
      return untilDone(() => press("Check"));
    },
    /** As it was given, without a trace of what was done. */
    async forget() {
      await page.evaluate(() => localStorage.clear());
      await page.reload({ waitUntil: "load" });
    },
  };
}

/** @typedef {ReturnType<typeof exerciseOn>} Exercise */

/** What axe has to say about an element. @param {Page} page @param {string} selector */
export async function axe(page, selector) {
  if (!(await page.evaluate(() => "axe" in globalThis)))
    await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
  return page.evaluate(async (where) => {
    const { violations } = await /** @type {any} */ (globalThis).axe.run(where, {
      resultTypes: ["violations"],
    });
    return violations.map((/** @type {any} */ rule) => ({
      rule: rule.id,
      where: rule.nodes.map((/** @type {any} */ node) => `${node.target} ${node.failureSummary}`),
    }));
  }, selector);
}

/**
 * A browser's context that has nothing yet.
 * @param {import("playwright-core").Browser} browser
 * @param {import("playwright-core").BrowserContextOptions} options
 */
export const newReader = (browser, options = {}) =>
  browser.newContext({
    viewport: { width: 1200, height: 900 },
    permissions: ["clipboard-read", "clipboard-write"],
    reducedMotion: "reduce",
    ...options,
  });

/** How often each file of the toolchain was asked for, by its name. @param {string[]} paths */
export function toolchainAsked(paths) {
  /** @type {Record<string, number>} */
  const times = {};
  for (const pathname of paths)
    if (/\/contact\/cpp\//.test(pathname) && !pathname.endsWith("manifest.json"))
      times[pathname] = (times[pathname] ?? 0) + 1;
  return times;
}
