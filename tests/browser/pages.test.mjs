// The built pages as readers meet them: without errors, without strangers, without a script, on
// paper, on a phone, and through assistive technology.

import assert from "node:assert/strict";
import { after, afterEach, before, describe, test } from "node:test";
import { figuresOn, lessons, loadFigures, notRun, open, pages, require } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";
import { sample, wanted } from "./sample.mjs";

const skip = notRun();
const all = skip ? [] : pages().filter(wanted);

describe("pages", { skip }, () => {
  const { server, chromium } = inBrowser();
  const url = (/** @type {string} */ where) => `${server.origin}/${where}`;

  const schemes = /** @type {const} */ (["light", "dark"]);
  // Every third of these is now light and now dark, so each run has both.
  const seen = all.flatMap((where) => schemes.map((scheme) => ({ where, scheme })));
  const looked = sample(seen, 3, "pages with axe", {
    kind: "page",
    name: ({ where, scheme }) => `${where} ${scheme}`,
  });

  /** @param {string} scheme @param {string} where */
  const sameIn = (scheme, where) => (/** @type {{ where: string, scheme: string }} */ each) =>
    each.where === where && each.scheme === scheme;

  for (const where of all)
    describe(where, () => {
      // Most tests of a page share it, as it takes seconds to load; what they set is put back.
      const viewport = { width: 1200, height: 900 };
      /** @type {Awaited<ReturnType<typeof open>>} */
      let shown;
      before(async () => {
        shown = await open(chromium.browser, url(where), { viewport });
        await loadFigures(shown.page);
      });
      afterEach(async () => {
        await shown.page.setViewportSize(viewport);
        await shown.page.emulateMedia({ media: null, colorScheme: null, reducedMotion: null });
      });
      after(async () => {
        await shown.close();
      });

      test("no console error, no request off the origin", async () => {
        const { page, trouble } = shown;
        await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
        await page.waitForLoadState("networkidle");
        assert.deepEqual(trouble, []);
      });

      for (const { scheme: colorScheme } of looked.filter((each) => each.where === where))
        test(`axe finds nothing, ${colorScheme}`, async () => {
          const { page } = shown;
          await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
          const paper = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
          const [red = 0] = (paper.match(/\d+/g) ?? []).map(Number);
          assert.equal(red > 127, colorScheme === "light", paper);
          await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
          // Where a page is looked at in both, only colours differ.
          const again = colorScheme === "dark" && looked.some(sameIn("light", where));
          const found = await page.evaluate(
            async (rules) => {
              const { violations } = await /** @type {any} */ (globalThis).axe.run(document, {
                resultTypes: ["violations"],
                ...(rules.length > 0 ? { runOnly: rules } : {}),
              });
              return violations.map((/** @type {any} */ rule) => ({
                rule: rule.id,
                where: rule.nodes.map(
                  (/** @type {any} */ node) => `${node.target} ${node.failureSummary}`,
                ),
              }));
            },
            again ? ["color-contrast", "link-in-text-block"] : [],
          );
          assert.deepEqual(found, []);
        });

      test("nothing sticks out on a phone", async () => {
        const { page, close } = await open(chromium.browser, url(where), {
          viewport: { width: 360, height: 740 },
          isMobile: true,
          hasTouch: true,
        });
        await loadFigures(page);
        const width = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(width <= 360, `${width} pixels wide`);
        await close();
      });

      // Just above 63em, where the sidebar appears.
      if (looked.some((each) => each.where === where))
        test("nothing sticks out beside the sidebar", async () => {
          const viewport = { width: 1024, height: 740 };
          const { page } = shown;
          await page.setViewportSize(viewport);
          const found = await page.evaluate(() => ({
            width: document.documentElement.scrollWidth,
            unreached: [
              ...document.querySelectorAll("article div.highlight > pre, article div.wide"),
            ]
              .filter((box) => box.scrollWidth > box.clientWidth + 1)
              .filter((box) => getComputedStyle(box).overflowX === "auto")
              .filter(
                (box) =>
                  box.getAttribute("tabindex") !== "0" ||
                  !box.ariaLabel ||
                  !getComputedStyle(box).backgroundAttachment.includes("local"),
              )
              .map((box) => box.outerHTML.slice(0, 80)),
          }));
          assert.deepEqual(found, { width: viewport.width, unreached: [] });
        });

      test("paper shows no control and cuts nothing", async () => {
        // A sheet of A4 between its margins.
        const { page } = shown;
        await page.setViewportSize({ width: 658, height: 930 });
        await page.emulateMedia({ media: "print" });
        await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
        const found = await page.evaluate(() => {
          const seen = (/** @type {Element} */ node) => {
            const { width, height } = node.getBoundingClientRect();
            return node.checkVisibility({ visibilityProperty: true }) && width > 1 && height > 1;
          };
          const name = (/** @type {Element} */ node) =>
            `${node.parentElement?.tagName} > ${node.tagName}.${node.className} ${node.textContent?.trim().slice(0, 40)}`;
          const sheet = document.documentElement.clientWidth;
          const controls = "button, input, select, textarea, .grip .ring, details:not([open])";
          return {
            // A cell of a ladder's picture is only its number on paper.
            controls: [...document.querySelectorAll(controls)]
              .filter((node) => !node.closest("table.ladder-picture") && seen(node))
              .map(name),
            cut: [...document.querySelectorAll("article *")]
              .filter((node) => !node.closest(".katex-mathml, svg, .builds-on") && seen(node))
              .filter((node) => {
                const style = getComputedStyle(node);
                const clips = (/** @type {string} */ how) => /hidden|auto|scroll|clip/.test(how);
                return (
                  node.getBoundingClientRect().right > sheet + 1 ||
                  (clips(style.overflowX) && node.scrollWidth > node.clientWidth + 1) ||
                  (clips(style.overflowY) && node.scrollHeight > node.clientHeight + 1)
                );
              })
              .map(name),
          };
        });
        assert.deepEqual(found, { controls: [], cut: [] });
      });

      if (lessons().includes(where)) {
        test("complete without a script", async () => {
          const { page, trouble, close } = await open(chromium.browser, url(where), {
            javaScriptEnabled: false,
          });
          const pictures = await page.locator("contact-figure > img").all();
          const figures = figuresOn(where);
          assert.ok(figures.length >= 1);
          assert.equal(pictures.length, figures.filter(({ built }) => built).length);
          for (const picture of pictures) {
            await picture.scrollIntoViewIfNeeded();
            assert.ok(await picture.isVisible());
            assert.ok(((await picture.getAttribute("alt")) ?? "").length > 20);
          }
          const questions = await page.locator("contact-question").all();
          assert.ok(questions.length > 0);
          for (const question of questions) {
            const data = JSON.parse(
              (await question.locator(":scope > script").textContent()) ?? "",
            );
            const asked = await question.locator(".asked").textContent();
            assert.ok(asked.length > 10, data.id);
            const link = question.locator(".to-answer a");
            assert.ok(await link.isVisible(), data.id);
            assert.match((await link.getAttribute("href")) ?? "", /answers\.html#answer-/, data.id);
            assert.equal(await question.locator(".explain").count(), 0, data.id);
          }
          assert.ok(await page.locator("contact-ladder svg").first().isVisible());
          assert.ok(await page.locator("contact-ladder table").first().isVisible());
          assert.deepEqual(trouble, []);
          await close();
        });

        test("on paper, dark ink on white and nothing to press", async () => {
          const { page } = shown;
          await page.emulateMedia({ media: "print", colorScheme: "dark" });
          const first = figuresOn(where).find(({ built }) => built);
          if (first) {
            const figure = page.locator(`contact-figure[name="${first.name}"]`);
            assert.ok(await figure.locator(".stage").isVisible());
            assert.ok(await figure.locator(".computed").isVisible());
            assert.equal(await figure.locator(".buttons").isVisible(), false);
            assert.equal(await figure.locator(".inputs").isVisible(), false);
            const paper = await figure
              .locator(".live-parts")
              .evaluate((node) => getComputedStyle(node).backgroundColor);
            assert.equal(paper, "rgb(255, 255, 255)");
          }
          const pdf = await page.pdf();
          assert.ok(pdf.length > 20000);
        });
      }
    });
});
