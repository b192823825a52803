// The forms of an exercise: read, order, fill, write. What each keeps, the keyboard, and that order and fill go through
// the compiler and the tests.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { notRun } from "./browser.mjs";
import { changed, exerciseOn, newReader, pageOf, solutionOf, visit } from "./exercise_page.mjs";
import { inBrowser } from "./in_browser.mjs";

/** @typedef {import("./exercise_page.mjs").Exercise} Exercise */

const skip = notRun();
const segment = "01_planes/segment_plane";
/** Of the solution's lines, the one that each gap stands in for. */
const GAPS = [
  "plane.normal.dot(segment.start)",
  "d0 < 0 && d1 < 0",
  "d0 == d1",
  "d0 / (d0 - d1)",
  "segment.end - segment.start",
];

describe("the forms of an exercise", { skip }, () => {
  const { server, chromium } = inBrowser();
  /** @type {Exercise} */
  let exercise;
  /** @type {import("playwright-core").Page} */
  let page;
  before(async () => {
    const context = await newReader(chromium.browser);
    ({ page } = await visit(context, server.origin, pageOf(segment)));
    exercise = exerciseOn(page, segment);
  });
  after(() => page?.context().close());

  const tab = (/** @type {string} */ name) =>
    exercise.element.getByRole("tab", { name, exact: true });
  const rows = () => exercise.element.locator(".ordering li");
  const gaps = () => exercise.element.locator(".gaps input");
  const file = async () => (await exercise.element.locator(".assembled pre").textContent()) ?? "";
  const entry = () =>
    page.evaluate(
      (id) => JSON.parse(localStorage["contact-hours/1/progress"] ?? "{}").exercises?.[id] ?? {},
      segment,
    );
  const codes = (/** @type {string} */ text) =>
    text.split("\n").filter((line) => !/^\s*(\/\/.*)?$/.test(line));

  test("in the listing to write in, each line is beside its number", async () => {
    const listing = exercise.element.locator(".code .still");
    await listing.waitFor();
    const size = page.viewportSize();
    await page.setViewportSize({ width: 360, height: 900 });
    // The last number is that of the empty line after the text; lines that wrap make the text higher.
    const heights = await listing.evaluate((element) =>
      [...element.children].map((part) => {
        const range = document.createRange();
        range.selectNodeContents(part);
        return range.getBoundingClientRect().height;
      }),
    );
    if (size) await page.setViewportSize(size);
    const [numbers = 0, lines = 0] = heights;
    assert.ok(0 < lines && lines <= numbers, `${lines} px of text, ${numbers} px of numbers`);
  });

  test("the arrow keys go from form to form", async () => {
    await tab("Write").focus();
    await page.keyboard.press("ArrowLeft");
    await gaps().first().waitFor();
    assert.equal(await tab("Fill").getAttribute("aria-selected"), "true");
    assert.equal(await tab("Write").getAttribute("aria-selected"), "false");
    assert.equal(await exercise.element.locator(".code").isVisible(), false);
  });

  test("an empty gap is named, and nothing is compiled", async () => {
    await gaps()
      .nth(0)
      .fill(GAPS[0] ?? "");
    await exercise.press("Check");
    assert.equal(await exercise.status(), "Gaps 2, 3, 4, 5 are still empty.");
    assert.equal(await exercise.element.getAttribute("state"), "idle");
  });

  test("a line moves by keys, and is left out and put back by a button", async () => {
    await tab("Order").click();
    await rows().first().waitFor();
    const first = (await rows().first().locator("pre").textContent()) ?? "";
    await rows()
      .first()
      .getByRole("button", { name: /^Move down/ })
      .focus();
    await page.keyboard.press("ArrowDown");
    assert.equal(await rows().nth(1).locator("pre").textContent(), first);
    assert.ok((await file()).includes(first));
    await rows()
      .nth(1)
      .getByRole("button", { name: /^Leave out/ })
      .click();
    assert.ok(!(await file()).includes(first));
    await rows()
      .nth(1)
      .getByRole("button", { name: /^Put back/ })
      .click();
    assert.ok((await file()).includes(first));
  });

  test("each form keeps what was done in it, also for the next visit", async () => {
    const order = await rows().locator("pre").allTextContents();
    await tab("Fill").click();
    assert.equal(await gaps().nth(0).inputValue(), GAPS[0]);
    await page.reload();
    await gaps().first().waitFor();
    assert.equal(await gaps().nth(0).inputValue(), GAPS[0]);
    await tab("Order").click();
    await rows().first().waitFor();
    assert.deepEqual(await rows().locator("pre").allTextContents(), order);
  });

  test("the worked solution is shown on request, and the record says so", async () => {
    await tab("Read").click();
    const show = exercise.element.getByRole("button", { name: "Show the worked solution" });
    await show.waitFor();
    assert.equal((await entry()).solution_shown, undefined);
    await show.click();
    const pieces = exercise.element.locator(".worked .piece");
    const reasons = await pieces.locator("p").allTextContents();
    assert.ok(reasons.length >= 3 && reasons.every((reason) => /\.$/.test(reason)));
    assert.equal(await pieces.locator("p").first().isVisible(), false);
    await pieces.locator("summary").first().click();
    assert.equal(await pieces.locator("p").first().isVisible(), true);
    assert.equal((await entry()).solution_shown, true);
  });

  test("what was filled goes on in the editor, and the record knows its form", async () => {
    await tab("Fill").click();
    for (const [at, gap] of GAPS.entries()) await gaps().nth(at).fill(gap);
    assert.equal((await file()).trimEnd(), solutionOf(segment).trimEnd());
    await exercise.press("Continue in the editor");
    assert.equal(await tab("Write").getAttribute("aria-selected"), "true");
    const text = (await exercise.element.locator(".code pre").first().textContent()) ?? "";
    assert.deepEqual(codes(text), codes(solutionOf(segment)));
    assert.equal((await entry()).form, "fill");
    await exercise.press("Reset");
    assert.equal((await entry()).form, undefined);
  });

  describe("checked by the compiler and the tests", () => {
    test("filled gaps pass, and the record says that they were filled", async () => {
      await tab("Fill").click();
      await gaps().nth(4).fill("segment.start - segment.end");
      assert.equal(await exercise.check(), "failed");
      await gaps()
        .nth(4)
        .fill(GAPS[4] ?? "");
      assert.equal(await exercise.check(), "passed", await exercise.status());
      assert.deepEqual(Object.keys((await entry()).passed_as), ["fill"]);
    });

    test("a line that does not belong asks the question of its misconception", async () => {
      await tab("Order").click();
      await rows().first().waitFor();
      assert.notEqual(await exercise.check(), "passed");
      const asked = exercise.element.locator(".ordering .asked:visible");
      assert.ok((await asked.count()) > 0);
      assert.match((await asked.first().textContent()) ?? "", /\S/);
    });

    test("a text in the editor is recorded as written", async () => {
      await tab("Write").click();
      await exercise.paste(changed(solutionOf(segment), "d0 == d1", "d1 == d0"));
      assert.equal(await exercise.check(), "passed", await exercise.status());
      assert.deepEqual(Object.keys((await entry()).passed_as).sort(), ["fill", "write"]);
    });
  });
});
