// Every question of a third of the lessons, another third in each turn, is answered wrong, then right, by the means its
// kind has. With CONTACT_ALL=1 it is every question of the book.

import assert from "node:assert/strict";
import { describe, test } from "node:test";
import {
  chapterOf,
  fieldsOf,
  lessons,
  loadFigure,
  notRun,
  open,
  openBoxes,
  settle,
} from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";
import { inputsLike, native } from "./native.mjs";
import { chaptersTaken, ofAll } from "./sample.mjs";

const skip = notRun();

describe("questions", { skip }, () => {
  const { server, chromium } = inBrowser();

  /** @typedef {import("playwright-core").Locator} Locator */
  // By the keyboard: a click of the mouse is lost if its button moves between press and release.
  const press = (/** @type {Locator} */ element, /** @type {string} */ name) =>
    element.getByRole("button", { name, exact: true }).press("Enter");

  const asked = (/** @type {Locator} */ element) =>
    element.evaluate((/** @type {any} */ it) => it.question);

  /** Sorts the steps with their buttons. @param {Locator} element @param {any} question @param {number[]} wanted */
  async function sort(element, question, wanted) {
    const text = (/** @type {Locator} */ row) => row.locator(".step").innerHTML();
    for (const [place, index] of wanted.entries()) {
      for (;;) {
        const rows = await element.locator("ol.steps > li").all();
        const html = await Promise.all(rows.map(text));
        const items = await element.evaluate((_, list) => {
          const box = document.createElement("span");
          return list.map((/** @type {string} */ item) => {
            box.innerHTML = item;
            return box.innerHTML;
          });
        }, question.items);
        const at = html.indexOf(items[index]);
        if (at === place) break;
        await /** @type {Locator} */ (rows[at])
          .getByRole("button", { name: /^Move up/ })
          .press("Enter");
      }
    }
  }

  /**
   * States that trying at random would not find, by figure and goal.
   * @type {Record<string, Record<string, Record<string, unknown>>>}
   */
  const known = {
    // A curve of 31 numbers with a given area.
    "12_momentum/force_time": {
      stops_gently: { drawn: Array(31).fill(0.8), duration: 8, mass: 0.5, speed: 12.4, beside: 0 },
    },
    // A stiff contact with little damping.
    "16_penalty/soft_to_rigid": {
      hard_bounce: { hardness: 0.8, ratio: 0.05, time: 0, release: 0 },
    },
    // Steps below the stability limit: of semi-implicit Euler, and of implicit Euler without a damper.
    "16_penalty/step_and_energy": {
      gains: { step: 0.06, stiffness: 1000, ratio: 0, scheme: 1, phase: 0.05 },
      damps_itself: { step: 0.02, stiffness: 1000, ratio: 0, scheme: 3, phase: 0.5 },
    },
  };
  /** A state of the figure for which its C++ says yes, found by trying: a few first, since some figures take long. */
  function winning(
    /** @type {string} */ name,
    /** @type {string} */ goal,
    /** @type {any} */ like,
  ) {
    const state = known[name]?.[goal];
    if (state) return state;
    for (let seed = 1; seed <= 20; ++seed) {
      const inputs = inputsLike(like, 5000, seed);
      for (let from = 0, count = 40; from < inputs.length; from += count, count *= 3) {
        const some = inputs.slice(from, from + count);
        const found = native(name, some).findIndex((output) => Number(output[goal]) >= 1);
        if (found >= 0) return some[found];
      }
    }
    throw new Error(`no state of ${name} reaches ${goal}`);
  }

  const answers = {
    /** @param {Locator} element @param {any} question @param {boolean} right */
    async predict(element, question, right) {
      const wrong = question.answer + 1 + 10 * question.tolerance;
      const value = right ? question.answer : wrong;
      await element.locator('input[type="text"]').fill(`${value} ${question.unit}`);
      await press(element, "Check");
    },
    /** @param {Locator} element @param {any} question @param {boolean} right */
    async choose(element, question, right) {
      const index = right ? question.answer : (question.answer + 1) % question.options.length;
      await element.getByRole("radio").nth(index).press("Space");
      await press(element, "Check");
    },
    /** @param {Locator} element @param {any} question @param {boolean} right */
    async order(element, question, right) {
      await sort(element, question, right ? question.answer : [...question.answer].reverse());
      await press(element, "Check");
    },
    /** @param {Locator} element @param {any} question @param {boolean} right */
    async construct(element, question, right) {
      const figure = element.page().locator(`contact-figure[name="${question.figure}"]`);
      await loadFigure(figure);
      if (right) {
        const like = await fieldsOf(figure, "input");
        const state = winning(question.figure, question.goal, like);
        await figure.evaluate((/** @type {any} */ it, fields) => it.set(fields), state);
        await element.getByText("does what is asked now").waitFor();
      } else await figure.evaluate((/** @type {any} */ it) => it.reset());
      await press(element, "Check the figure");
    },
  };

  /** @param {any} gap */
  const key = (gap) => `${gap.answer} ${gap.unit}`.trim();
  const kinds = [...Object.keys(answers), "complete", "say-why"];

  /** Fills all gaps, the last one wrong, then it alone, for the right ones stay.
   * @param {Locator} element @param {any} question */
  async function complete(element, question) {
    const gap = (/** @type {any} */ { id }) => element.locator(`.gap-${id} input`);
    for (const each of question.gaps) await gap(each).fill(key(each));
    const last = question.gaps.at(-1);
    await gap(last).fill(`${last.answer + 1 + 10 * last.tolerance} ${last.unit}`);
    await gap(last).press("Enter");
    assert.equal(await element.getAttribute("result"), "wrong", question.id);
    await press(element, "Try again");
    for (const each of question.gaps)
      assert.equal(await gap(each).isEditable(), each === last, question.id);
    await gap(last).fill(key(last));
    await press(element, "Check");
    assert.equal(await element.getAttribute("result"), "right", question.id);
  }

  /** Writes, compares and marks; nothing of it is right or wrong.
   * @param {Locator} element @param {any} question */
  async function sayWhy(element, question) {
    const box = element.locator("textarea");
    const compare = "Compare with a model answer";
    assert.equal(await element.locator(".criteria").isVisible(), false);
    await press(element, compare);
    await element.getByText("Write a sentence first.").waitFor();
    await box.fill("It is so because of that.");
    await press(element, compare);
    assert.equal(await element.getAttribute("result"), null, question.id);
    assert.equal(await box.isEditable(), false);
    await element.getByRole("checkbox").nth(1).press("Space");
    assert.equal(await element.getByRole("checkbox").count(), 3);
  }

  const remembered = (/** @type {any} */ page, /** @type {string} */ id) =>
    page.evaluate(
      (/** @type {string} */ name) =>
        JSON.parse(localStorage.getItem("contact-hours/1/questions") ?? "{}")[name],
      id,
    );

  const taken = chaptersTaken("page", "chapters with questions");
  for (const where of skip ? [] : lessons().filter((page) => taken.includes(chapterOf(page))))
    test(`${where}: every question, wrong then right`, async () => {
      const { page, trouble, close } = await open(chromium.browser, `${server.origin}/${where}`);
      await page.evaluate(() => customElements.whenDefined("contact-question"));
      await settle(page);
      const all = await page.locator("contact-question").all();
      assert.ok(all.length > 0);
      for (const element of all) {
        const question = await asked(element);
        const explain = element.locator(".explain");
        if (question.kind === "complete" || question.kind === "say-why") {
          if (question.kind === "complete") await complete(element, question);
          else await sayWhy(element, question);
          assert.ok((await explain.textContent()).length > 10, question.id);
          const kept = await remembered(page, question.id);
          assert.equal(kept.right, question.kind === "complete", question.id);
          if (question.kind === "complete") assert.deepEqual(kept.answer, question.gaps.map(key));
          else assert.deepEqual(kept.marks, [false, true, false], question.id);
          continue;
        }
        const answer = answers[/** @type {keyof typeof answers} */ (question.kind)];
        await answer(element, question, false);
        assert.equal(await element.getAttribute("result"), "wrong", question.id);
        assert.equal((await explain.innerHTML()).trim(), "", question.id);
        await press(element, "Try again");
        assert.equal(await element.getAttribute("result"), null);
        await answer(element, question, true);
        assert.equal(await element.getAttribute("result"), "right", question.id);
        assert.ok((await explain.textContent()).length > 10, question.id);
        const kept = await remembered(page, question.id);
        assert.equal(kept.right, true);
        assert.equal(kept.tries, 2);
      }
      assert.deepEqual(trouble, []);
      await close();
    });

  ofAll("the book has questions of each kind, and no other", async () => {
    const found = new Set();
    for (const where of lessons()) {
      const { page, close } = await open(chromium.browser, `${server.origin}/${where}`);
      await page.evaluate(() => customElements.whenDefined("contact-question"));
      for (const element of await page.locator("contact-question").all())
        found.add((await asked(element)).kind);
      await close();
    }
    assert.deepEqual([...found].sort(), kinds.sort());
  });

  /** The first question of a kind, with what it says. @param {string} kind */
  async function first(kind) {
    for (const where of lessons()) {
      const shown = await open(chromium.browser, `${server.origin}/${where}`);
      await shown.page.evaluate(() => customElements.whenDefined("contact-question"));
      for (const element of await shown.page.locator("contact-question").all()) {
        const question = await asked(element);
        if (question.kind !== kind) continue;
        await settle(shown.page);
        return { ...shown, element, question };
      }
      await shown.close();
    }
    throw new Error(`no question to ${kind}`);
  }

  ofAll("a prediction without its unit is not judged, and nonsense is refused", async () => {
    const { page, element, question, close } = await first("predict");
    const box = element.locator('input[type="text"]');
    await box.fill("soon");
    await page.keyboard.press("Tab");
    await press(element, "Check");
    await element.getByText("Begin with a number").waitFor();
    assert.equal(await element.getAttribute("result"), null);
    if (question.unit) {
      await box.fill(String(question.answer));
      await box.press("Enter");
      assert.equal(await element.getAttribute("result"), null);
    }
    await box.fill(`${question.answer + 100} ${question.unit}`);
    await box.press("Enter");
    assert.equal(await element.getAttribute("result"), "wrong");
    assert.equal(await box.isEditable(), false);
    await press(element, "Show the answer");
    assert.ok((await element.locator(".explain").textContent()).length > 10);
    await close();
  });

  ofAll("what is right so far stays, and gaps that are left are not wrong", async () => {
    const { element, question, close } = await first("complete");
    const gap = element.locator(`.gap-${question.gaps[0].id} input`);
    await press(element, "Check");
    await element.getByText("Fill a gap first.").waitFor();
    await gap.fill(key(question.gaps[0]));
    await gap.press("Enter");
    await element.getByText(/gaps? (is|are) left\./).waitFor();
    assert.equal(await element.getAttribute("result"), null);
    assert.equal(await gap.isEditable(), false);
    await close();
  });

  ofAll("what was written is there when the reader comes back, and never counts", async () => {
    const { page, element, question, close } = await first("say-why");
    await sayWhy(element, question);
    await press(element, "Change your answer");
    assert.equal(await element.locator("textarea").isEditable(), true);
    assert.equal(await element.locator(".explain").textContent(), "");
    await page.reload();
    await openBoxes(page);
    const again = page.locator(`contact-question#question-${question.id.split("/")[1]}`);
    await again.getByText("This is what you wrote before.").waitFor();
    assert.equal(await again.locator("textarea").inputValue(), "It is so because of that.");
    await press(again, "Compare with a model answer");
    assert.equal(await again.getByRole("checkbox").nth(1).isChecked(), true);
    const kept = await remembered(page, question.id);
    assert.deepEqual([kept.right, kept.marks], [false, [false, true, false]]);
    await close();
  });

  ofAll("steps are moved by arrow keys and by dragging", async () => {
    const { page, element, close } = await first("order");
    const rows = element.locator("ol.steps > li");
    const order = () => rows.locator(".step").allTextContents();
    const start = await order();
    await element.scrollIntoViewIfNeeded();
    await rows
      .nth(0)
      .getByRole("button", { name: /^Move down/ })
      .focus();
    await page.keyboard.press("ArrowDown");
    const [first0, second0, ...rest] = start;
    assert.deepEqual(await order(), [second0, first0, ...rest]);
    assert.ok(
      await rows
        .nth(1)
        .getByRole("button", { name: /^Move down/ })
        .evaluate((node) => node === document.activeElement || node.matches(":disabled")),
    );
    const from = await rows.nth(1).locator(".step").boundingBox();
    const to = await rows.nth(0).locator(".step").boundingBox();
    assert.ok(from && to);
    await page.mouse.move(from.x + 5, from.y + from.height / 2);
    await page.mouse.down();
    await page.mouse.move(to.x + 5, to.y + to.height / 2, { steps: 6 });
    await page.mouse.up();
    assert.deepEqual(await order(), start);
    await close();
  });
});
