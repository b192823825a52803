// Every live figure of every lesson: taken hold of by pointer, finger and keyboard, typed into,
// reset, linked to; and its numbers are those of the same C++ compiled natively, to the last bit.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, describe, test } from "node:test";
import { fieldsOf, launch, lessons, loadFigure, notRun, open, serve, site } from "./browser.mjs";
import { inputsLike, native } from "./native.mjs";
import { sample } from "./sample.mjs";

const skip = notRun();
/** Which figures there are, read from the built pages. */
const figures = skip
  ? []
  : lessons().flatMap((page) => {
      const html = fs.readFileSync(path.join(site, page), "utf8");
      return [...html.matchAll(/<contact-figure name="([^"]+)"/g)].map(([, name]) => ({
        page,
        name: /** @type {string} */ (name),
      }));
    });

test("there are figures to test", { skip }, () => assert.ok(figures.length >= 4));

describe("figures", { skip }, () => {
  /** @type {Awaited<ReturnType<typeof serve>>} */
  let server;
  /** @type {Awaited<ReturnType<typeof launch>>} */
  let chromium;
  before(async () => {
    server = await serve();
    chromium = await launch();
  });
  after(async () => {
    await chromium.close();
    server.close();
  });

  /** @param {{ page: string, name: string }} figure @param {string} hash */
  async function show({ page: where, name }, hash = "", options = {}) {
    const { page, trouble, close } = await open(
      chromium.browser,
      `${server.origin}/${where}${hash}`,
      { reducedMotion: "reduce", ...options },
    );
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

  for (const each of sample(figures, 6)) {
    test(`${each.name}: dragged by pointer`, async () => {
      const shown = await show(each);
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
      await shown.close();
    });

    test(`${each.name}: moved by keyboard, in larger and smaller steps`, async () => {
      const shown = await show(each);
      const grip = shown.figure.locator(".grip").first();
      const field = /** @type {string} */ (await grip.getAttribute("data-field"));
      const size = async (/** @type {string} */ keys) => {
        const start = [(await shown.input())[field]].flat();
        await grip.focus();
        await shown.page.keyboard.press(keys);
        const now = [(await shown.input())[field]].flat();
        return Math.hypot(...now.map((value, i) => value - start[i]));
      };
      const step = await size("ArrowRight");
      assert.ok(step > 0);
      // Ten times as large, one way or the other; less only if the whole range is smaller.
      const left = await size("Shift+ArrowLeft");
      const right = await size("Shift+ArrowRight");
      const larger = Math.max(left, right);
      const range = await size("Shift+ArrowLeft");
      assert.ok(Math.abs(larger - 10 * step) < 1e-9 || (larger > 2 * step && larger === range));
      assert.ok(Math.abs((await size("Alt+ArrowUp")) - step / 10) < 1e-9);
      await agrees(each.name, shown);
      assert.match(/** @type {string} */ (await grip.getAttribute("aria-valuetext")), /\d/);
      await shown.close();
    });

    test(`${each.name}: typed`, async () => {
      const shown = await show(each);
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
          document.querySelector(`contact-figure[name="${name}"] .spoken`)?.textContent === wanted,
        [each.name, words],
      );
      await shown.close();
    });

    test(`${each.name}: the same numbers as native C++ in 400 states`, async () => {
      const shown = await show(each);
      const inputs = inputsLike(await shown.input(), 400, 7);
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
      await shown.close();
    });

    test(`${each.name}: a link brings the state back`, async () => {
      const shown = await show(each);
      const grip = shown.figure.locator(".grip").first();
      await grip.focus();
      await shown.page.keyboard.press("ArrowRight");
      await shown.page.keyboard.press("ArrowUp");
      await shown.figure.getByRole("button", { name: "Copy link" }).click();
      await shown.figure.locator(".buttons .status").filter({ hasText: /link/i }).waitFor();
      const state = await shown.input();
      const { hash } = new URL(shown.page.url());
      await shown.close();
      const again = await show(each, hash);
      assert.deepStrictEqual(await again.input(), state);
      await agrees(each.name, again);
      await again.figure.getByRole("button", { name: "Reset" }).click();
      assert.notDeepStrictEqual(await again.input(), state);
      assert.equal(new URL(again.page.url()).hash, "");
      assert.deepEqual(again.trouble, []);
      await again.close();
    });

    test(`${each.name}: a finger drags a grip; grips are large enough`, async () => {
      const phone = { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true };
      const shown = await show(each, "", phone);
      const grip = shown.figure.locator(".grip").first();
      const reach = await grip.locator(".reach").boundingBox();
      assert.ok(reach && reach.width >= 24 && reach.height >= 24, JSON.stringify(reach));
      const start = await shown.input();
      const session = await shown.page.context().newCDPSession(shown.page);
      const [x, y] = [reach.x + reach.width / 2, reach.y + reach.height / 2];
      const touch = (/** @type {string} */ type, /** @type {any[]} */ touchPoints) =>
        session.send("Input.dispatchTouchEvent", { type: /** @type {any} */ (type), touchPoints });
      const scrolled = await shown.page.evaluate(() => scrollY);
      await touch("touchStart", [{ x, y }]);
      for (const by of [6, 12, 18, 24]) await touch("touchMove", [{ x: x + by, y: y + by }]);
      await touch("touchEnd", []);
      assert.notDeepStrictEqual(await shown.input(), start);
      assert.equal(await shown.page.evaluate(() => scrollY), scrolled);
      await agrees(each.name, shown);
      await shown.close();
    });
  }

  test("a figure in space is turned by pointer and by buttons, and its numbers stay", async () => {
    const shown = await show(figures[0]);
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

  test("a figure whose C++ does not load leaves its picture and says so", async () => {
    const context = await chromium.browser.newContext();
    const page = await context.newPage();
    await page.route("**/*.wasm", (route) => route.abort());
    const { page: where, name } = figures[0];
    await page.goto(`${server.origin}/${where}`);
    const figure = page.locator(`contact-figure[name="${name}"]`);
    await figure.scrollIntoViewIfNeeded();
    await figure.getByText("could not be loaded").waitFor();
    assert.ok(await figure.locator("img").isVisible());
    await context.close();
  });
});
