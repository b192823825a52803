// What assistive technology is told: names, roles and live regions of a figure, a question, a ladder and an exercise, and
// that each can be used by keyboard alone.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { loadFigure, notRun, open, settle } from "./browser.mjs";
import { exerciseOn, newReader, pageOf, visit } from "./exercise_page.mjs";
import { inBrowser } from "./in_browser.mjs";

const skip = notRun();

/** @typedef {import("playwright-core").Locator} Locator */

/** The roles of which something must be known by its name. */
const NAMED =
  /^\s*- '?(button|slider|spinbutton|combobox|textbox|checkbox|radio|tab|link|table|region)\b(.*)$/;

/** What is operated in this part of the page has a name, and there is something. @param {Locator} part */
async function allNamed(part) {
  const operated = (await part.ariaSnapshot()).split("\n").filter((line) => NAMED.test(line));
  assert.ok(operated.length > 0);
  assert.deepEqual(
    operated.filter((line) => !/^ "/.test(NAMED.exec(line)?.[2] ?? "")),
    [],
  );
}

describe("a lesson through assistive technology", { skip }, () => {
  const { server, chromium } = inBrowser();
  /** @type {Awaited<ReturnType<typeof open>>} */
  let shown;
  before(async () => {
    const url = `${server.origin}/chapters/02_triangles.html`;
    shown = await open(chromium.browser, url, { reducedMotion: "reduce" });
    await settle(shown.page);
  });
  after(async () => {
    await shown?.close();
  });

  /** Presses Tab until what has the focus is this. @param {Locator} wanted @param {number} most */
  async function tabTo(wanted, most = 60) {
    for (let i = 0; i < most; i++) {
      if (await wanted.evaluate((node) => node === document.activeElement)) return;
      await shown.page.keyboard.press("Tab");
    }
    assert.fail(`not reached with ${most} presses of Tab: ${wanted}`);
  }

  describe("a figure", () => {
    /** @type {Locator} */
    let figure;
    before(async () => {
      figure = shown.page.locator('contact-figure[name="02_triangles/ray_triangle"]');
      await loadFigure(figure);
    });

    test("everything in it that is operated has a name", async () => {
      await allNamed(figure);
    });

    test("its points are sliders in a group with the figure's title, and say where they are", async () => {
      const stage = figure.getByRole("group").first();
      assert.ok(((await stage.getAttribute("aria-label")) ?? "").length > 10);
      const grips = await stage.getByRole("slider").all();
      assert.ok(grips.length > 0);
      for (const grip of grips)
        assert.match((await grip.getAttribute("aria-valuetext")) ?? "", /\d/);
    });

    test("a computed number's name and what it means are words apart", async () => {
      const rows = await figure.getByRole("rowheader").all();
      assert.ok(rows.length > 0);
      for (const row of rows) {
        const name = (await row.locator("var, .word").first().textContent()) ?? "";
        const told = (await row.textContent()) ?? "";
        if (told.length > name.length) assert.match(told.slice(name.length), /^\s/, told);
      }
    });

    test("a point that is moved by keyboard is told in a live region", async () => {
      const live = figure
        .locator('[role="status"], [aria-live="polite"]')
        .filter({ hasText: /\w/ });
      const grip = figure.locator(".grip").first();
      await grip.focus();
      await shown.page.keyboard.press("ArrowRight");
      const sentence = (await figure.locator(".sentence").textContent()) ?? "";
      await live
        .filter({ hasText: sentence.trim().slice(0, 30) })
        .first()
        .waitFor({ state: "attached" });
    });

    test("Tab leads from the first point to the button that sets it back", async () => {
      await figure.locator(".grip").first().focus();
      await tabTo(figure.getByRole("button", { name: "Reset", exact: true }));
    });
  });

  describe("a question", () => {
    test("is a group that is named after its kind and what is asked", async () => {
      for (const question of await shown.page.locator("contact-question").all()) {
        const asked = ((await question.locator(".asked").textContent()) ?? "").trim();
        const kind = (await question.locator(".kind").textContent()) ?? "";
        const ids = (await question.getAttribute("aria-labelledby")) ?? "";
        const told = await shown.page.evaluate(
          (all) =>
            all.split(" ").map((one) => document.getElementById(one)?.textContent?.trim() ?? ""),
          ids,
        );
        assert.deepEqual(told, [kind, asked]);
        assert.equal(await question.getAttribute("role"), "group");
      }
    });

    test("everything in them that is operated has a name", async () => {
      for (const question of await shown.page.locator("contact-question").all())
        await allNamed(question);
    });

    test("is answered by keyboard; the verdict is told, and the focus is not lost", async () => {
      const question = shown.page
        .locator("contact-question")
        .filter({ has: shown.page.getByRole("radio") })
        .first();
      await question.getByRole("radio").first().focus();
      await shown.page.keyboard.press("Space");
      await tabTo(question.getByRole("button", { name: "Check", exact: true }), 3);
      await shown.page.keyboard.press("Enter");
      const verdict = question.getByRole("status");
      assert.match((await verdict.textContent()) ?? "", /^(Right|Not yet)\./);
      const again = question.getByRole("button", { name: "Try again", exact: true });
      assert.ok(await again.evaluate((node) => node === document.activeElement));
    });
  });

  describe("a ladder", () => {
    test("everything in it that is operated has a name", async () => {
      const ladder = shown.page.locator("contact-ladder").first();
      await allNamed(ladder);
    });

    test("its cells are buttons that say number, method and inputs", async () => {
      const ladder = shown.page.locator("contact-ladder").first();
      const cells = await ladder.locator("td button").all();
      assert.ok(cells.length > 10);
      const names = await Promise.all(cells.map((cell) => cell.getAttribute("aria-label")));
      assert.equal(new Set(names).size, names.length);
    });
  });
});

describe("an exercise through assistive technology", { skip }, () => {
  const { server, chromium } = inBrowser();
  const id = "01_planes/segment_plane";
  /** @type {Awaited<ReturnType<typeof visit>>["page"]} */
  let page;
  /** @type {ReturnType<typeof exerciseOn>} */
  let exercise;
  before(async () => {
    const context = await newReader(chromium.browser);
    ({ page } = await visit(context, server.origin, pageOf(id)));
    exercise = exerciseOn(page, id);
  });
  after(() => page?.context().close());

  test("everything in it that is operated has a name", async () => {
    await exercise.element.scrollIntoViewIfNeeded();
    await exercise.element.getByRole("tab", { name: "Write" }).waitFor();
    await allNamed(exercise.element);
  });

  test("a check is started from the code by keyboard, and its state and verdict are told", async () => {
    await exercise.element
      .getByRole("textbox", { name: /^Your code/ })
      .first()
      .focus();
    await exercise.untilDone(() => page.keyboard.press("Control+Enter"));
    const told = await exercise.element.getByRole("status").allTextContents();
    assert.ok(
      told.some((text) => text.includes("contact::todo()")),
      told.join(" | "),
    );
  });

  test("Esc and then Tab leaves the code", async () => {
    const code = exercise.element.getByRole("textbox", { name: /^Your code/ }).first();
    await code.focus();
    await page.keyboard.press("Escape");
    await page.keyboard.press("Tab");
    assert.equal(await code.evaluate((node) => node.contains(document.activeElement)), false);
  });
});
