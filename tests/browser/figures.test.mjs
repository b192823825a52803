// Every live figure of every lesson: taken hold of by pointer, finger and keyboard, typed into,
// reset, linked to; and its numbers are those of the same C++ compiled natively, to the last bit.

import assert from "node:assert/strict";
import { after, before, beforeEach, describe, test } from "node:test";
import { chapterOf, fieldsOf, figuresOn, lessons, loadFigure, notRun, open } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";
import { inputsLike, native } from "./native.mjs";
import { chaptersTaken, ofAll } from "./sample.mjs";

const skip = notRun();
const taken = chaptersTaken("figures", "chapters with figures in a browser");
/** The figures of these chapters, read from the built pages. */
const figures = skip
  ? []
  : lessons()
      .filter((page) => taken.includes(chapterOf(page)))
      .flatMap((page) => figuresOn(page).map(({ name, built }) => ({ page, name, built })));

test("there are figures to test, and all of them are built", { skip }, () => {
  assert.ok(figures.length >= (taken.length > 0 ? 1 : 0));
  assert.deepEqual(
    figures.filter(({ built }) => !built),
    [],
  );
});

describe("figures", { skip }, () => {
  const { server, chromium } = inBrowser();

  /** @param {{ page: string, name: string }} each @param {string} hash */
  async function show(each, hash = "") {
    const url = `${server.origin}/${each.page}${hash}`;
    return on(await open(chromium.browser, url, { reducedMotion: "reduce" }), each);
  }

  /** @param {Awaited<ReturnType<typeof open>>} opened @param {{ name: string }} each */
  async function on({ page, trouble, close }, { name }) {
    const figure = page.locator(`contact-figure[name="${name}"]`);
    await loadFigure(figure);
    await figure.locator(".stage").scrollIntoViewIfNeeded();
    const input = () => fieldsOf(figure, "input");
    const output = () => fieldsOf(figure, "output");
    return { page, figure, input, output, trouble, close };
  }

  /** The page's numbers are the native program's. @param {string} name @param {any} shown */
  async function agrees(name, shown) {
    const [wanted] = native(name, [await shown.input()]);
    assert.deepStrictEqual(await shown.output(), wanted);
  }

  for (const where of new Set(figures.map(({ page }) => page)))
    describe(where, () => {
      // Loading a page takes seconds, so its figures share one on a desk, and one on a phone.
      /** @type {Awaited<ReturnType<typeof open>>} */
      let desk;
      /** @type {Awaited<ReturnType<typeof open>>} */
      let phone;
      before(async () => {
        const url = `${server.origin}/${where}`;
        desk = await open(chromium.browser, url, { reducedMotion: "reduce" });
        const held = { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true };
        phone = await open(chromium.browser, url, { reducedMotion: "reduce", ...held });
      });
      after(async () => {
        await desk.close();
        await phone.close();
      });
      for (const each of figures.filter(({ page }) => page === where))
        describe(each.name, () => {
          /** @type {Awaited<ReturnType<typeof on>>} */
          let shown;
          before(async () => {
            shown = await on(desk, each);
          });
          // What went wrong in one figure is not told of the next.
          after(() => {
            desk.trouble.length = 0;
          });
          beforeEach(() => shown.figure.evaluate((/** @type {any} */ it) => it.reset()));

          test("dragged by pointer", async () => {
            for (const grip of await shown.figure.locator(".grip").all()) {
              if (!(await grip.isVisible())) continue;
              const field = /** @type {string} */ (await grip.getAttribute("data-field"));
              const start = await shown.input();
              await grip.locator(".knob").scrollIntoViewIfNeeded();
              const box = await grip.locator(".knob").boundingBox();
              assert.ok(box);
              const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
              await shown.page.mouse.move(x, y);
              await shown.page.mouse.down();
              await shown.page.mouse.move(x + 14, y - 9, { steps: 4 });
              await shown.page.mouse.up();
              const moved = await shown.input();
              // Grips may lie on one another; then the upper one is what is taken.
              const changed = Object.keys(start).filter(
                (name) => JSON.stringify(start[name]) !== JSON.stringify(moved[name]),
              );
              assert.equal(changed.length, 1, `dragging ${field} changed ${changed}`);
              await agrees(each.name, shown);
              await shown.figure.getByRole("button", { name: "Reset" }).click();
              assert.deepStrictEqual(await shown.input(), start);
            }
            assert.deepEqual(shown.trouble, []);
          });

          test("moved by keyboard, in larger and smaller steps", async () => {
            const grip = shown.figure.locator(".grip").first();
            const field = /** @type {string} */ (await grip.getAttribute("data-field"));
            const size = async (/** @type {string} */ keys) => {
              const start = [(await shown.input())[field]].flat();
              await grip.focus();
              await shown.page.keyboard.press(keys);
              const now = [(await shown.input())[field]].flat();
              return Math.hypot(...now.map((value, i) => value - start[i]));
            };
            // Left and right lead along a curve that is drawn by hand.
            const drawn = /stroke/.test(/** @type {string} */ (await grip.getAttribute("class")));
            const [more, less] = drawn ? ["ArrowUp", "ArrowDown"] : ["ArrowRight", "ArrowLeft"];
            const step = await size(more);
            assert.ok(step > 0);
            // Ten times as large, one way or the other; less only if the whole range is smaller.
            const left = await size(`Shift+${less}`);
            const right = await size(`Shift+${more}`);
            const larger = Math.max(left, right);
            const range = await size(`Shift+${less}`);
            assert.ok(
              Math.abs(larger - 10 * step) < 1e-9 || (larger > 2 * step && larger === range),
            );
            assert.ok(Math.abs((await size("Alt+ArrowUp")) - step / 10) < 1e-9);
            await agrees(each.name, shown);
            assert.match(/** @type {string} */ (await grip.getAttribute("aria-valuetext")), /\d/);
          });

          test("typed", async () => {
            const box = shown.figure.locator('input[type="number"]').first();
            const field = /** @type {string} */ (await box.getAttribute("data-field"));
            const index = Number(await box.getAttribute("data-index"));
            await box.fill("0.12345678901234568");
            assert.equal([(await shown.input())[field]].flat()[index], 0.12345678901234568);
            await agrees(each.name, shown);
            await box.fill("");
            assert.equal([(await shown.input())[field]].flat()[index], 0.12345678901234568);
            await box.blur();
            assert.equal(await box.inputValue(), String(0.12345678901234568));
            const words = await shown.figure.locator(".sentence").textContent();
            assert.ok(words && words.length > 20);
            await shown.page.waitForFunction(
              ([name, wanted]) =>
                document.querySelector(`contact-figure[name="${name}"] .spoken`)?.textContent ===
                wanted,
              [each.name, words],
            );
          });

          test("the same numbers as native C++ in 100 states", async () => {
            const inputs = inputsLike(await shown.input(), 100, 7);
            const got = await shown.figure.evaluate(
              (/** @type {any} */ figure, /** @type {any} */ states) => {
                return states.map((/** @type {any} */ state) => {
                  figure.set(state);
                  return Object.fromEntries(Object.entries(figure.output));
                });
              },
              inputs,
            );
            const wanted = native(each.name, inputs);
            got.forEach((/** @type {any} */ output, /** @type {number} */ i) => {
              assert.deepStrictEqual(output, wanted[i], JSON.stringify(inputs[i]));
            });
            assert.ok(got.some((/** @type {any} */ output) => output.problem === 0));
            assert.deepEqual(shown.trouble, []);
          });

          test("a link brings the state back", async () => {
            const grip = shown.figure.locator(".grip").first();
            await grip.focus();
            await shown.page.keyboard.press("ArrowRight");
            await shown.page.keyboard.press("ArrowUp");
            await shown.figure.getByRole("button", { name: "Copy link" }).click();
            await shown.figure.locator(".buttons .status").filter({ hasText: /link/i }).waitFor();
            const state = await shown.input();
            const { hash } = new URL(shown.page.url());
            const again = await show(each, hash);
            assert.deepStrictEqual(await again.input(), state);
            await agrees(each.name, again);
            await again.figure.getByRole("button", { name: "Reset" }).click();
            assert.notDeepStrictEqual(await again.input(), state);
            assert.equal(new URL(again.page.url()).hash, "");
            assert.deepEqual(again.trouble, []);
            await again.close();
          });

          test("a finger drags a grip; grips are large enough", async () => {
            const held = await on(phone, each);
            const grip = held.figure.locator(".grip").first();
            const reach = await grip.locator(".reach").boundingBox();
            assert.ok(reach && reach.width >= 24 && reach.height >= 24, JSON.stringify(reach));
            const start = await held.input();
            const session = await held.page.context().newCDPSession(held.page);
            const [x, y] = [reach.x + reach.width / 2, reach.y + reach.height / 2];
            const touch = (/** @type {string} */ type, /** @type {any[]} */ touchPoints) =>
              session.send("Input.dispatchTouchEvent", {
                type: /** @type {any} */ (type),
                touchPoints,
              });
            const scrolled = await held.page.evaluate(() => scrollY);
            await touch("touchStart", [{ x, y }]);
            for (const by of [6, 12, 18, 24]) await touch("touchMove", [{ x: x + by, y: y + by }]);
            await touch("touchEnd", []);
            assert.notDeepStrictEqual(await held.input(), start);
            // A page that still settles above the figure moves it by a pixel; a finger that scrolls, by many.
            const by = (await held.page.evaluate(() => scrollY)) - scrolled;
            assert.ok(Math.abs(by) <= 2, `the page went by ${by} pixels`);
            await agrees(each.name, held);
          });
        });
    });

  /** A figure whose curve is drawn by hand. */
  const sketch = { page: "chapters/12_momentum.html", name: "12_momentum/force_time" };
  /** A figure in space. */
  const solid = { page: "chapters/02_triangles.html", name: "02_triangles/ray_triangle" };
  /** A figure whose points move in a section, with buttons for states. */
  const section = { page: "chapters/05_meshes.html", name: "05_meshes/inside" };
  /** Draws through points of the sheet, given as shares of its width and height. */
  async function draw(/** @type {any} */ shown, /** @type {[number, number][]} */ points) {
    const sheet = await shown.figure.locator(".sheet").boundingBox();
    const at = (/** @type {[number, number]} */ [u, v]) =>
      /** @type {const} */ ([sheet.x + u * sheet.width, sheet.y + v * sheet.height]);
    const [first, ...others] = points;
    await shown.page.mouse.move(...at(/** @type {[number, number]} */ (first)));
    await shown.page.mouse.down();
    for (const point of others) await shown.page.mouse.move(...at(point));
    await shown.page.mouse.up();
  }

  ofAll("a curve is drawn in one stroke, either way, and only where the stroke goes", async () => {
    const shown = await show(sketch);
    const drawn = async () => /** @type {number[]} */ ((await shown.input())["drawn"]);
    const start = await drawn();
    // Two moves, far apart: what lies between is on the line that the hand went.
    await draw(shown, [
      [0.01, 0.5],
      [0.5, 0.2],
      [0.99, 0.5],
    ]);
    const there = await drawn();
    for (const [i, value] of there.entries()) {
      const mirrored = there[there.length - 1 - i];
      assert.ok(Math.abs(value - mirrored) < 0.05, `${i}: ${value} and ${mirrored}`);
      if (i > 0 && i < there.length - 1)
        assert.ok(
          Math.abs(there[i - 1] - 2 * value + there[i + 1]) < (i === 15 ? 0.5 : 0.02),
          `${i}`,
        );
    }
    await agrees(sketch.name, shown);
    await shown.figure.getByRole("button", { name: "Reset" }).click();
    await draw(shown, [
      [0.99, 0.5],
      [0.5, 0.2],
      [0.01, 0.5],
    ]);
    (await drawn()).forEach((value, i) => {
      assert.ok(Math.abs(value - there[i]) < 0.02, `${i}: ${value} and ${there[i]}`);
    });
    await shown.figure.getByRole("button", { name: "Reset" }).click();
    await draw(shown, [
      [0.01, 0.9],
      [0.4, 0.9],
    ]);
    const part = await drawn();
    assert.ok(
      part.slice(0, 11).every((value) => value < 0 && value === part[0]),
      `${part}`,
    );
    assert.deepStrictEqual(part.slice(14), start.slice(14));
    await shown.close();
  });

  ofAll("a curve stays within its sheet, and keys draw it too", async () => {
    const shown = await show(sketch);
    await draw(shown, [
      [0.5, 0.5],
      [0.5, -0.4],
    ]);
    const before = /** @type {number[]} */ ((await shown.input())["drawn"]);
    assert.equal(before[15], 4.2);
    for (const key of ["ArrowLeft", "ArrowLeft", "ArrowDown"]) await shown.page.keyboard.press(key);
    const after = /** @type {number[]} */ ((await shown.input())["drawn"]);
    const moved = after.map((value, i) => Math.round((before[i] - value) * 1000) / 1000);
    assert.deepStrictEqual(
      moved.slice(8, 19),
      [0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.04, 0.03, 0.02, 0.01, 0],
    );
    assert.match(
      /** @type {string} */ (await shown.figure.locator(".grip").getAttribute("aria-valuetext")),
      /point 14 of 31/,
    );
    await shown.close();
  });

  ofAll("what a value means follows the state", async () => {
    const shown = await show(sketch);
    const row = shown.figure.locator(".computed tr").last();
    const before = await row.locator(".meaning").textContent();
    await shown.figure.evaluate((/** @type {any} */ it) => it.set({ speed: 3 }));
    assert.notEqual(await row.locator(".meaning").textContent(), before);
    await shown.close();
  });

  ofAll("a figure in space is turned by pointer and by buttons, and its numbers stay", async () => {
    const shown = await show(solid);
    const stage = shown.figure.locator(".stage");
    const picture = () => shown.figure.locator(".drawing").innerHTML();
    const numbers = await shown.output();
    const start = await picture();
    await shown.figure.getByRole("button", { name: "Turn the view left" }).click();
    await shown.page.waitForTimeout(50);
    const turned = await picture();
    assert.notEqual(turned, start);
    const box = await stage.boundingBox();
    assert.ok(box);
    await shown.page.mouse.move(box.x + 8, box.y + 8);
    await shown.page.mouse.down();
    await shown.page.mouse.move(box.x + 90, box.y + 8, { steps: 5 });
    await shown.page.mouse.up();
    await shown.page.waitForTimeout(50);
    assert.notEqual(await picture(), turned);
    assert.deepStrictEqual(await shown.output(), numbers);
    await shown.figure.getByRole("button", { name: "Reset" }).click();
    await shown.page.waitForTimeout(50);
    assert.equal(await picture(), start);
    await shown.close();
  });

  ofAll("a button puts a figure into a state, and leaves the rest as it is", async () => {
    const shown = await show(section);
    const start = await shown.input();
    await shown.figure.getByLabel("Coordinates").selectOption("divided by 10");
    await shown.figure.getByRole("button", { name: "a vertex" }).click();
    const state = await shown.input();
    assert.notDeepStrictEqual(state["direction"], start["direction"]);
    assert.equal(state["divided"], 10);
    await agrees(section.name, shown);
    await shown.close();
  });

  ofAll("a point that is not shown has no grip", async () => {
    const queue = { page: "chapters/21_events.html", name: "21_events/queue" };
    const shown = await show(queue);
    const grips = shown.figure.locator(".grip:visible");
    assert.equal(await grips.count(), 14);
    await shown.figure.locator('input[type="number"]').first().fill("3");
    await shown.page.waitForTimeout(50);
    assert.equal(await grips.count(), 0);
    await shown.figure.getByRole("button", { name: "the start" }).click();
    await shown.page.waitForTimeout(50);
    assert.equal(await grips.count(), 14);
    await shown.close();
  });

  ofAll("a point that moves vertically stays in its section", async () => {
    const shown = await show(section);
    const start = /** @type {number[]} */ ((await shown.input())["p"]);
    const box = await shown.figure.locator('.grip[data-field="p"] .knob').boundingBox();
    assert.ok(box);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await shown.page.mouse.move(x, y);
    await shown.page.mouse.down();
    await shown.page.mouse.move(x + 40, y + 30, { steps: 4 });
    await shown.page.mouse.up();
    const end = /** @type {number[]} */ ((await shown.input())["p"]);
    assert.equal(end[1], start[1]);
    assert.ok(/** @type {number} */ (end[0]) > /** @type {number} */ (start[0]));
    assert.ok(/** @type {number} */ (end[2]) < /** @type {number} */ (start[2]));
    await shown.close();
  });

  ofAll("a figure whose C++ does not load leaves its picture and says so", async () => {
    const context = await chromium.browser.newContext();
    const page = await context.newPage();
    await page.route("**/*.wasm", (route) => route.abort());
    const { page: where, name } = solid;
    await page.goto(`${server.origin}/${where}`);
    const figure = page.locator(`contact-figure[name="${name}"]`);
    await figure.scrollIntoViewIfNeeded();
    await figure.getByText("could not be loaded").waitFor();
    assert.ok(await figure.locator("img").isVisible());
    await context.close();
  });
});
