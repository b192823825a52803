// The home page and the search: the map of the chapters by keyboard, on a phone and without a
// script; and what a reader finds by a word of a lesson or the name of a function.

import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { lessons, notRun, open } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";

const skip = notRun();
const phone = { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true };

describe("home and search", { skip }, () => {
  const { server, chromium } = inBrowser();
  const home = (options = {}) => open(chromium.browser, `${server.origin}/index.html`, options);

  test("a reader sees at once what this is, and a figure that moves", async () => {
    const { page, close } = await home({ viewport: { width: 1280, height: 900 } });
    assert.match((await page.locator("p.in-short").textContent()) ?? "", /collision detection/);
    const figure = page.locator("contact-figure");
    await figure.locator(".stage").waitFor();
    const box = await figure.locator(".stage").boundingBox();
    assert.ok(box && box.y + box.height <= 900, "the figure is on the first screen");
    const grip = figure.locator(".grip").first();
    const before = await figure.locator(".computed").textContent();
    await grip.focus();
    await page.keyboard.press("Shift+ArrowRight");
    await page.waitForFunction(
      (old) => document.querySelector("contact-figure .computed")?.textContent !== old,
      before,
    );
    await close();
  });

  for (const [name, options] of /** @type {const} */ ([
    ["on a wide screen", {}],
    ["on a phone", phone],
    ["without a script", { javaScriptEnabled: false }],
  ]))
    test(`the map names every lesson and cuts no name, ${name}`, async () => {
      const { page, trouble, close } = await home(options);
      const boxes = await page.locator(".chapter-map .box").evaluateAll((found) =>
        found.map((box) => {
          const words = /** @type {HTMLElement} */ (box.firstElementChild);
          const link = box.querySelector("a");
          const outer = box.getBoundingClientRect();
          // The text for readers who cannot see the lines takes no space.
          const inner = [...words.querySelectorAll(".number, a, .kind")].map((part) =>
            part.getBoundingClientRect(),
          );
          return {
            href: link?.getAttribute("href") ?? "",
            title: link?.textContent ?? "",
            cut: inner.some(
              (part) =>
                part.left < outer.left ||
                part.right > outer.right ||
                part.top < outer.top ||
                part.bottom > outer.bottom,
            ),
            tall: outer.height,
          };
        }),
      );
      const linked = boxes.map(({ href }) => href).filter((href) => href.startsWith("chapters/"));
      assert.deepEqual(linked.sort(), lessons().sort());
      for (const { title, cut, tall } of boxes) {
        assert.equal(cut, false, title);
        assert.ok(tall >= 44, `${title}: ${tall} pixels for a finger`);
      }
      assert.deepEqual(trouble, []);
      await close();
    });

  test("the map is walked by keyboard, and all of a box leads to its chapter", async () => {
    const { page, close } = await home();
    const first = page.locator(".chapter-map .box a").first();
    await first.focus();
    const count = await page.locator(".chapter-map .box a").count();
    for (let i = 1; i < count; ++i) await page.keyboard.press("Tab");
    const last = page.locator(".chapter-map .box").last();
    assert.ok(await last.evaluate((box) => box.contains(document.activeElement)));
    const outline = await last.evaluate((box) => getComputedStyle(box).outlineStyle);
    assert.equal(outline, "solid");
    const href = await last.locator("a").getAttribute("href");
    await last.click({ position: { x: 4, y: 4 } });
    await page.waitForURL(`**/${href}`);
    await close();
  });

  for (const [what, words, place] of /** @type {const} */ ([
    ["a word of a lesson", "watertight", "chapters/02_triangles.html"],
    ["the name of a function", "cross_plane", "api/02_triangles.html"],
  ]))
    test(`search finds ${what}: ${words}`, async () => {
      const { page, trouble, close } = await home();
      await page.locator("body").press("/");
      await page.keyboard.type(words);
      await page.keyboard.press("Enter");
      await page.waitForURL("**/search.html?q=*");
      const hit = page.locator(`#search-results li a[href*="${place}"]`).first();
      await hit.waitFor();
      await hit.click();
      await page.waitForURL(`**/${place}**`);
      assert.ok(((await page.locator("article").textContent()) ?? "").includes(words));
      assert.deepEqual(trouble, []);
      await close();
    });
});
