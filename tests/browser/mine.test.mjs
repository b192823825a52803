// "Try mine in the figure": a reader's function answers beside the book's for what is dragged, and
// nothing that it does takes the page with it.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { before, describe, test } from "node:test";
import { figuresOn, lessons, notRun, site } from "./browser.mjs";
import {
  axe,
  changed,
  exerciseOn,
  newReader,
  PATIENCE,
  pageOf,
  solutionOf,
  stubOf,
  visit,
} from "./exercise_page.mjs";
import { inBrowser } from "./in_browser.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {{ label: string, asked: string | null }} Row */
/** @typedef {{ id: string, figure: string, page: string, fields: string[], rows: Row[] }} Tied */

const skip = notRun();

/** @param {string} text */
const unescaped = (text) =>
  text.replaceAll("&quot;", '"').replaceAll("&gt;", ">").replaceAll("&lt;", "<");

/** Every exercise that a figure of its lesson calls, if this run has built the figure. @returns {Tied[]} */
function tied() {
  return lessons().flatMap((page) => {
    const built = new Set(figuresOn(page).flatMap(({ name, built }) => (built ? [name] : [])));
    const html = fs.readFileSync(path.join(site, page), "utf8");
    const ties = html.matchAll(/<contact-exercise name="([^"]+)"[^>]* mine="([^"]+)"/g);
    return [...ties].flatMap(([, id = "", said = ""]) => {
      const { figure, fields, rows } = JSON.parse(unescaped(said).replaceAll("&amp;", "&"));
      return built.has(figure) ? [{ id, figure, page, fields, rows }] : [];
    });
  });
}

/** An exercise and its figure. @param {Page} page @param {string} id @param {string} figure */
function trial(page, id, figure) {
  const exercise = exerciseOn(page, id);
  const panel = page.locator(`contact-figure[name="${figure}"] .mine`);
  const words = () => panel.locator(".mine-words").textContent();
  /** @param {RegExp} state */
  const until = async (state) => {
    const end = Date.now() + PATIENCE;
    for (;;) {
      const now = (await panel.getAttribute("state")) ?? "";
      if (now !== "busy" && state.test(now)) return;
      assert.ok(Date.now() < end, `${id} is ${now}: ${await words()}`);
      await page.waitForTimeout(50);
    }
  };
  /** @param {string} label */
  const row = (label) =>
    panel
      .locator("tbody tr")
      .filter({ has: page.getByRole("rowheader", { name: label, exact: true }) })
      .locator("td")
      .allTextContents();
  const press = () => exercise.press("Try mine in the figure");
  /** @param {Record<string, unknown>} fields */
  const set = (fields) =>
    page.evaluate(
      ([name, to]) => {
        const element = /** @type {any} */ (
          document.querySelector(`contact-figure[name="${name}"]`)
        );
        element.set(to);
      },
      /** @type {const} */ ([figure, fields]),
    );
  return { exercise, panel, words, until, row, press, set };
}

const collide = "13_collisions_1d/velocities_after";
const headOn = "13_collisions_1d/head_on";
const isBuilt = !skip && tied().some(({ id }) => id === collide);
const without = skip || (isBuilt ? false : `not run: ${headOn} is not built in this run`);

describe("the reader's function in a figure", { skip: without }, () => {
  const { server, chromium } = inBrowser();
  /** @type {Page} */
  let page;
  /** @type {string[]} */
  let trouble;
  /** @type {ReturnType<typeof trial>} */
  let mine;
  before(async () => {
    const context = await newReader(chromium.browser);
    ({ page, trouble } = await visit(context, server.origin, pageOf(collide)));
    mine = trial(page, collide, headOn);
  });

  /** @param {string} body */
  const written = (body) =>
    changed(stubOf(collide).replace(/\/\*(\w+)\*\//g, "$1"), "contact::todo();", body);

  test("what is not written yet is said to be so", async () => {
    await mine.press();
    await mine.until(/trouble/);
    assert.match((await mine.words()) ?? "", /contact::todo\(\)/);
  });

  test("a wrong answer stands beside the book's, and differs where the figure is dragged to", async () => {
    // The two keep their velocities, which is right until they approach.
    await mine.exercise.paste(written("return {first.velocity, second.velocity};"));
    await mine.until(/different|same/);
    await mine.set({ mass_1: 2, mass_2: 2, v_1: 3, v_2: -1, e: 1, tested: 1 });
    await mine.until(/different/);
    await page.waitForFunction(
      (name) =>
        document.querySelector(`contact-figure[name="${name}"] .mine td`)?.textContent === "" &&
        /first/.test(
          document.querySelector(`contact-figure[name="${name}"] .mine-words`)?.textContent ?? "",
        ),
      headOn,
    );
    assert.deepEqual(await mine.row("first, m/s"), ["3 ≠", "−1"]);
    assert.deepEqual(await mine.row("second, m/s"), ["−1 ≠", "3"]);
    assert.match((await mine.words()) ?? "", /differs from the book’s: first, m\/s; second, m\/s/);
    await mine.set({ v_1: -2 });
    await mine.until(/same/);
    assert.deepEqual(await mine.row("first, m/s"), ["−2", "−2"]);
  });

  test("dragging a point of the figure asks again", async () => {
    await mine.set({ v_1: 3 });
    await mine.until(/different/);
    const first = await mine.row("first, m/s");
    const grip = page.locator(`contact-figure[name="${headOn}"] .grip`).first();
    await grip.scrollIntoViewIfNeeded();
    const box = await grip.boundingBox();
    assert.ok(box);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 12, y, { steps: 3 });
    await page.mouse.move(x - 25, y, { steps: 3 });
    await page.mouse.up();
    await page.waitForTimeout(500);
    assert.notDeepEqual(await mine.row("first, m/s"), first);
  });

  test("in light and dark it has no fault that axe finds", async () => {
    for (const theme of ["light", "dark"]) {
      await page.evaluate((name) => {
        document.body.dataset["theme"] = name;
      }, theme);
      assert.deepEqual(await axe(page, `contact-figure[name="${headOn}"]`), [], theme);
    }
    await page.evaluate(() => {
      document.body.dataset["theme"] = "light";
    });
  });

  test("an endless loop is stopped, and the page and the next question go on", async () => {
    const loop = "if (first.velocity > 2) for (volatile int i = 0;; i = 0) {}\n";
    await mine.exercise.paste(written(`${loop}  return {first.velocity, second.velocity};`));
    await mine.set({ v_1: 3 });
    await mine.until(/trouble/);
    assert.match((await mine.words()) ?? "", /no answer within 1 second: an endless loop/);
    await mine.set({ v_1: 1, v_2: 2 });
    await mine.until(/same/);
  });

  test("a crash and an exception are told, and the next question goes on", async () => {
    const crash = "if (first.velocity > 2) __builtin_trap();\n";
    const thrown = '  if (first.velocity < 0) throw std::runtime_error("too slow");\n';
    const rest = "  return {first.velocity, second.velocity};";
    await mine.exercise.paste(written(crash + thrown + rest));
    await mine.until(/same/);
    await mine.set({ v_1: 3 });
    await mine.until(/trouble/);
    assert.match((await mine.words()) ?? "", /stopped for these numbers/);
    await mine.set({ v_1: -1 });
    await page.waitForFunction(
      (name) =>
        /threw an exception for these numbers: too slow/.test(
          document.querySelector(`contact-figure[name="${name}"] .mine-words`)?.textContent ?? "",
        ),
      headOn,
    );
    await mine.set({ v_1: 1 });
    await mine.until(/same/);
  });

  test("what does not compile is explained with its line, and mending it goes on", async () => {
    const broken = written("return {first.velocity, second.velocit};");
    await mine.exercise.paste(broken);
    await mine.until(/trouble/);
    const line = broken.slice(0, broken.indexOf("velocit}")).split("\n").length;
    assert.match(
      (await mine.words()) ?? "",
      new RegExp(`does not compile, line ${line}: .*velocit`),
    );
    await mine.exercise.paste(solutionOf(collide));
    await mine.until(/same/);
  });

  test("a press goes back to the book's alone", async () => {
    await mine.panel.getByRole("button", { name: "The book’s alone" }).click();
    assert.equal(await mine.panel.count(), 0);
    assert.equal(
      await page.evaluate(() => document.activeElement?.textContent),
      "Try mine in the figure",
    );
    assert.deepEqual(trouble, []);
  });

  test("on a phone the panel fits", async () => {
    await page.setViewportSize({ width: 360, height: 740 });
    await mine.press();
    await mine.until(/same|different/);
    const wide = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    assert.ok(wide <= 0, `${wide} px too wide`);
  });

  for (const { id, figure, page: where, fields, rows } of skip ? [] : tied())
    test(`the book's solution of ${id} agrees with figure ${figure}`, async () => {
      await page.setViewportSize({ width: 1280, height: 800 });
      await page.goto(`${server.origin}/${where}`, { waitUntil: "load" });
      const one = trial(page, id, figure);
      await one.exercise.paste(solutionOf(id));
      await one.press();
      await one.until(/same|different|trouble/);
      assert.match((await one.words()) ?? "", /agrees with the book’s/);
      if (!rows.every(({ asked }) => asked === "whole")) return;
      // The solution is right for all numbers, the figure's own answer only for whole ones.
      const input = await page.evaluate(
        (name) =>
          /** @type {any} */ (document.querySelector(`contact-figure[name="${name}"]`)).input,
        figure,
      );
      const moved = fields.filter((field) => Array.isArray(input[field]));
      const off = (/** @type {any} */ value) =>
        Array.isArray(value) ? value.map(off) : value + 0.013;
      await one.set(Object.fromEntries(moved.map((field) => [field, off(input[field])])));
      await one.until(/trouble|different/);
      assert.match((await one.words()) ?? "", /is not compared here/);
    });
});
