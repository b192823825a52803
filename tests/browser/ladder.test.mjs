// A ladder in the page: its picture, its cells, and "Run it here". Every third ladder is run and every third stopped,
// others in each turn. (What each computes: page/wasm/loader.test.mjs; what the picture says: page/web/test.)

import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { chapterOf, completeLessons, lessons, notRun, open, require } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";
import { chaptersTaken, ofAll, sample, wanted } from "./sample.mjs";

const skip = notRun();

/** @typedef {{ input: number, error: number, figure?: string, fields?: Record<string, number[]> }} Failure */
/** @typedef {{ method: string, family: string, n: number, wrong: number, failure?: Failure }} Row */
/** @typedef {{ id: string, title: string, scalar: string, exact: boolean, recommended: boolean }} Method */
/** @typedef {{ ladder: string, families: { id: string }[], methods: Method[], results: Row[] }} Result */

/** The measurements on a page, with the failing inputs from their file. @param {any} ladder @returns {Promise<Result>} */
async function measured(ladder) {
  const data = JSON.parse((await ladder.locator(":scope > script").textContent()) ?? "");
  const failing = await ladder.evaluate(async (/** @type {HTMLElement} */ element) =>
    (await fetch(element.getAttribute("failures") ?? "")).json(),
  );
  for (const row of data.results) {
    row.failure = failing[`${row.family} ${row.method}`];
    assert.equal(row.fails ?? false, row.failure !== undefined, `${row.method}, ${row.family}`);
  }
  return data;
}

/** How many libraries in JavaScript a ladder asks. @type {Record<string, number>} */
const PEERS = { "04_rays": 2, "05_meshes": 1, "06_triangle_pairs": 2 };

/** The cell of a row. @param {any} ladder @param {Row} row */
const cellOf = (ladder, { method, family }) =>
  ladder.locator(`tr[data-method="${method}"] td[data-family="${family}"] button`);

/**
 * What a figure's output shows if the method fails on the input there. Only where the figure runs the method itself.
 * @type {Record<string, (output: any, method: Method, row: Row) => boolean>}
 */
const fails = {
  ray_triangle(output, { id, scalar }) {
    const ways = ["edges", "dropping", "moller-trumbore", "watertight"];
    const way = ways.indexOf(id.replace(/-(float|double)$/, ""));
    return output[scalar === "float" ? "hit_in_float" : "hit_in_double"][way] !== output.hit;
  },
  wrapping: (output) => output.right === 0,
  close_calls(output, { id }) {
    const rows = { formula: "by_formula", textbook: "by_textbook", colliding: "by_book" };
    const row = /** @type {Record<string, string>} */ (rows)[id.replace(/-double$/, "")];
    return output[row ?? ""].some(
      (/** @type {number} */ n, /** @type {number} */ i) => n !== output.right[i],
    );
  },
  squeeze: (output) => output.hits !== output.stepped_hits,
  steps(output, { id }) {
    const ways = ["steps", "intervals-epsilon", "edges", "axes", "orientations"];
    return output.wrong[ways.indexOf(id.replace(/-(float|double)$/, ""))] === 1;
  },
  given_sums(output, { id }) {
    const ways = ["order", "pairwise", "kahan", "compensated", "filtered"];
    const way = ways.indexOf(
      id.replace(/-(float|double)$/, "").replace(/^(exact|rational)$/, "filtered"),
    );
    return output.errors[way] > 0;
  },
  passing: (output) => output.passes === 1,
  balls(output, _method, { family, failure }) {
    if (!/-(overlap|energy)$/.test(family)) return output.hits !== output.right_hits;
    const shown = family.endsWith("-overlap") ? output.overlap : output.energy_change;
    return Math.abs(shown - (failure?.error ?? 0)) <= 1e-9 * shown;
  },
  drift(output, { id }) {
    const ways = ["axes-bare", "axes-quaternion", "axes-exponential", "axes-midpoint"];
    // A tenth of a radian; another method is the fifth curve.
    return output.read[ways.includes(id) ? ways.indexOf(id) : ways.length] > 0.1;
  },
};

/**
 * Labels that overlap another or leave their frame. Each label is a text with the box that it must stay in.
 * @param {any} ladder @returns {Promise<string[]>}
 */
const collisions = (ladder) =>
  ladder.evaluate((/** @type {HTMLElement} */ element) => {
    const labels = [];
    const visible = (/** @type {Element} */ each) =>
      each.getClientRects().length > 0 && !each.closest(".unseen, details:not([open])");
    const frames = ".picture th, .picture td, .picture .legend p, .picture .proven, .cell svg";
    for (const frame of element.querySelectorAll(frames)) {
      if (!visible(frame)) continue;
      const outer = (frame.closest("svg") ?? frame).getBoundingClientRect();
      const walker = document.createTreeWalker(frame, NodeFilter.SHOW_TEXT);
      for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const parent = /** @type {Element} */ (node.parentElement);
        if (!node.textContent?.trim() || !visible(parent) || parent.closest("title")) continue;
        const svg = parent.closest("svg");
        const range = document.createRange();
        range.selectNodeContents(node);
        // One box a line; the letters of a line may reach into the leading of the next.
        const lines = svg ? [parent.getBoundingClientRect()] : [...range.getClientRects()];
        const frameBox = svg ? svg.getBoundingClientRect() : outer;
        for (const { left, right, top, bottom } of lines)
          labels.push({ words: node.textContent.trim(), left, right, top, bottom, frameBox });
      }
    }
    const wrong = [];
    for (const [i, p] of labels.entries()) {
      const { frameBox: f } = p;
      if (
        p.left < f.left - 1 ||
        p.right > f.right + 1 ||
        p.top < f.top - 1 ||
        p.bottom > f.bottom + 1
      )
        wrong.push(`"${p.words}" leaves its frame`);
      for (const q of labels.slice(i + 1)) {
        const across = Math.min(p.right, q.right) - Math.max(p.left, q.left);
        const down = Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top);
        if (across > 1 && down > 3) wrong.push(`"${p.words}" and "${q.words}" overlap`);
      }
    }
    if (labels.length < 20) wrong.push(`only ${labels.length} labels`);
    return wrong;
  });

describe("ladders", { skip }, () => {
  const { server, chromium } = inBrowser();
  const all = skip ? [] : lessons();
  const taken = chaptersTaken("ladder", "chapters whose ladder runs in the page");
  const run = all.filter((page) => taken.includes(chapterOf(page)));
  const url = (/** @type {string} */ where) => `${server.origin}/${where}`;

  for (const where of all.filter(wanted))
    test(`${where}: no label overlaps another or leaves its frame, on paper`, async () => {
      // The width of a printed page.
      const options = { viewport: { width: 658, height: 971 } };
      const { page, close } = await open(chromium.browser, url(where), options);
      const ladder = page.locator("contact-ladder").first();
      const pressed = ladder.locator("td button").first();
      await pressed.click();
      await page.emulateMedia({ media: "print" });
      assert.deepEqual(await collisions(ladder), []);
      const cut = await ladder.evaluate((/** @type {HTMLElement} */ element) => {
        const { left, right } = element.getBoundingClientRect();
        return [...element.querySelectorAll("table.ladder-picture, .legend, .proven, .measured")]
          .map((each) => ({ name: each.className, box: each.getBoundingClientRect() }))
          .filter(({ box }) => box.width === 0 || box.left < left - 1 || box.right > right + 1)
          .map(({ name }) => name);
      });
      assert.deepEqual(cut, []);
      // Bullets stand left of the text, and a box that scrolls would cut them off.
      const content = page.locator(".content").first();
      assert.equal(await content.evaluate((box) => getComputedStyle(box).overflowX), "visible");
      // What the cell shows is not printed, and neither is a frame around the cell.
      assert.ok(await ladder.locator(".cell").isHidden());
      assert.equal(await pressed.evaluate((cell) => getComputedStyle(cell).outlineStyle), "none");
      await close();
    });

  const phone = { viewport: { width: 390, height: 844 } };
  for (const where of all.filter(wanted))
    for (const [name, options] of /** @type {const} */ ([
      ["a desk", {}],
      ["a phone", phone],
    ]))
      test(`${where}: no label overlaps another or leaves its frame, on ${name}`, async () => {
        const { page, close } = await open(chromium.browser, url(where), options);
        const ladder = page.locator("contact-ladder").first();
        await ladder.locator("td button").first().waitFor();
        assert.deepEqual(await collisions(ladder), []);
        const { results } = await measured(ladder);
        // One cell of each family: each has a plot of its own.
        const families = new Map(results.map((row) => [row.family, row]));
        for (const row of families.values()) {
          await cellOf(ladder, row).evaluate((/** @type {HTMLElement} */ cell) => cell.click());
          assert.deepEqual(await collisions(ladder), [], `${row.method}, ${row.family}`);
        }
        if (options === phone) {
          // The methods' column stays where it is while the others scroll.
          const head = ladder.locator("tbody th").first();
          const before = await head.boundingBox();
          const scrolling = ladder.locator(".scrolling").first();
          await scrolling.evaluate((/** @type {HTMLElement} */ box) => {
            box.scrollLeft = box.scrollWidth;
          });
          assert.equal((await head.boundingBox())?.x, before?.x);
          const sideways = await page.evaluate(
            () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
          );
          assert.ok(sideways <= 0, `the page scrolls ${sideways} px sideways`);
        } else {
          for (const picture of await ladder.locator("table.ladder-picture").all()) {
            const table = await picture.boundingBox();
            assert.ok(table && table.height <= 720, `the picture is ${table?.height} px high`);
          }
        }
        await close();
      });

  for (const where of skip ? [] : completeLessons().filter(wanted))
    test(`${where}: a failing input is opened in the figure, where the method fails`, async () => {
      const { page, trouble, close } = await open(chromium.browser, url(where));
      const ladder = page.locator("contact-ladder").first();
      const { ladder: slug, methods, results } = await measured(ladder);
      const seen = new Set();
      for (const row of results) {
        const { failure } = row;
        if (row.wrong > 0) assert.ok(failure, `${row.method}, ${row.family} has no failing input`);
        if (!failure?.figure) continue;
        const what = `${row.method}, ${row.family} in ${failure.figure}`;
        const figure = page.locator(`contact-figure[name="${slug}/${failure.figure}"]`);
        // By hand once for each figure; the others get their numbers at once.
        if (!seen.has(failure.figure)) {
          seen.add(failure.figure);
          await cellOf(ladder, row).click();
          await ladder.getByRole("button", { name: "Open in the figure", exact: true }).click();
          const said = figure.locator("xpath=preceding-sibling::*[1]");
          await said.getByText("From the ladder,").waitFor();
          assert.ok(await figure.isVisible());
        } else {
          await figure.evaluate((/** @type {any} */ element, fields) => {
            element.reset();
            element.set(
              Object.fromEntries(
                Object.entries(fields).map(([name, values]) => [
                  name,
                  values.length === 1 ? values[0] : values,
                ]),
              ),
            );
          }, failure.fields ?? {});
        }
        const { input, output } = await figure.evaluate((/** @type {any} */ { input, output }) => ({
          input,
          output,
        }));
        for (const [field, values] of Object.entries(failure.fields ?? {}))
          assert.deepEqual([input[field]].flat(), values, `${what}: ${field}`);
        assert.equal(output.problem, 0, what);
        // A choice that shows nothing hides the number.
        const choices = figure.locator("select");
        for (const shown of await choices.evaluateAll((/** @type {HTMLSelectElement[]} */ all) =>
          all.map((each) => each.selectedOptions[0]?.textContent ?? ""),
        ))
          assert.notEqual(shown, "", `${what}: a choice is empty`);
        const method = methods.find(({ id }) => id === row.method);
        if (method)
          assert.ok(fails[failure.figure]?.(output, method, row) ?? true, `${what} is right`);
      }
      if (seen.size > 0) {
        await page.getByRole("button", { name: "Back to the ladder", exact: true }).first().click();
        assert.ok(await ladder.locator(".cell").isVisible());
      }
      assert.deepEqual(trouble, []);
      await close();
    });

  for (const where of sample(all, 3, "tables of ladders", { kind: "ladder" })) {
    test(`${where}: all numbers are in a table`, async () => {
      const { page, close } = await open(chromium.browser, url(where));
      const ladder = page.locator("contact-ladder").first();
      const { results } = await measured(ladder);
      await ladder
        .locator("summary")
        .filter({ hasText: /^The numbers$/ })
        .click();
      const rows = ladder.locator(":scope > details tbody tr");
      await rows.first().waitFor();
      assert.equal(await rows.count(), results.length);
      for (const [i, text] of (await rows.allTextContents()).entries()) {
        const { wrong, n } = /** @type {Row} */ (results[i]);
        const count = `${wrong.toLocaleString("en")} of ${n.toLocaleString("en")}`;
        assert.ok(text.includes(count), `${text}: ${count}`);
      }
      await close();
    });

    test(`${where}: an input that cannot be loaded is said, and asked for again`, async () => {
      const { page, close } = await open(chromium.browser, url(where));
      const ladder = page.locator("contact-ladder").first();
      const row = (await measured(ladder)).results.find(({ failure }) => failure);
      assert.ok(row);
      const moved = (/** @type {string} */ to) =>
        ladder.evaluate((/** @type {HTMLElement} */ element, name) => {
          const before = element.getAttribute("failures") ?? "";
          element.setAttribute("failures", name);
          return before;
        }, to);
      const file = await moved("nowhere.json");
      await cellOf(ladder, row).click();
      await ladder.getByText("The input could not be loaded.").waitFor();
      await moved(file);
      await cellOf(ladder, row).click();
      await cellOf(ladder, row).click();
      await ladder.locator(".cell h4").waitFor();
      await close();
    });
  }

  for (const where of sample(all, 3, "ladders with axe", { kind: "ladder" }))
    test(`${where}: axe finds nothing beside an open cell`, async () => {
      const { page, close } = await open(chromium.browser, url(where));
      const ladder = page.locator("contact-ladder").first();
      const { results } = await measured(ladder);
      const row = results.find(({ failure }) => failure);
      assert.ok(row);
      await cellOf(ladder, row).click();
      await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
      for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
        await page.emulateMedia({ colorScheme });
        const found = await page.evaluate(async () => {
          const { violations } = await /** @type {any} */ (globalThis).axe.run("contact-ladder");
          return violations.map((/** @type {any} */ rule) =>
            rule.nodes.map((/** @type {any} */ node) => `${rule.id}: ${node.target}`),
          );
        });
        assert.deepEqual(found, [], colorScheme);
      }
      await close();
    });

  ofAll(
    "cells are reached with the arrow keys, and pointing lights a row and a column",
    async () => {
      const { page, close } = await open(chromium.browser, url(all[0] ?? ""));
      const ladder = page.locator("contact-ladder").first();
      const { families } = await measured(ladder);
      const rows = ladder.locator("tbody tr");
      const first = rows.first().locator("td button");
      await first.first().focus();
      await page.keyboard.press("ArrowRight");
      await page.keyboard.press("ArrowDown");
      const at = rows.nth(1).locator("td[data-family]").nth(1);
      const focused = at.locator("button");
      assert.ok(await focused.evaluate((cell) => cell === document.activeElement));
      assert.equal(await ladder.locator('td button[tabindex="0"]').count(), 1);
      assert.match((await rows.nth(1).getAttribute("class")) ?? "", /lit/);
      assert.equal(
        await ladder.locator("th.family.lit").getAttribute("data-family"),
        families[1]?.id,
      );
      await page.keyboard.press("Enter");
      assert.ok(await ladder.locator(".cell").isVisible());
      assert.equal(await focused.getAttribute("aria-expanded"), "true");
      await ladder.getByRole("button", { name: "Close", exact: true }).click();
      assert.ok(await ladder.locator(".cell").isHidden());
      assert.ok(await focused.evaluate((cell) => cell === document.activeElement));
      await close();
    },
  );

  ofAll("the filter leaves the methods of the chosen types", async () => {
    const { page, close } = await open(chromium.browser, url(all[0] ?? ""));
    const ladder = page.locator("contact-ladder").first();
    const kinds = () =>
      ladder
        .locator("tbody tr:visible")
        .evaluateAll((/** @type {HTMLElement[]} */ rows) => [
          ...new Set(rows.map((row) => row.dataset.kind)),
        ]);
    assert.deepEqual((await kinds()).sort(), ["double", "exact", "float"]);
    await ladder.getByRole("checkbox", { name: "float" }).uncheck();
    await ladder.getByRole("checkbox", { name: "exact" }).uncheck();
    assert.deepEqual(await kinds(), ["double"]);
    await ladder.getByRole("checkbox", { name: "exact" }).check();
    assert.deepEqual((await kinds()).sort(), ["double", "exact"]);
    await close();
  });

  for (const where of run)
    test(`${where}: run here`, { timeout: 60_000 }, async () => {
      const { page, trouble, close } = await open(chromium.browser, url(where));
      const ladder = page.locator("contact-ladder").first();
      const data = await measured(ladder);
      assert.equal(await ladder.locator("rect.own").count(), 0);
      await ladder.getByRole("button", { name: "Run it here", exact: true }).click();
      const status = ladder.locator(".status").filter({ hasText: /timed in|could not/ });
      await status.waitFor({ timeout: 50_000 });
      assert.match((await status.textContent()) ?? "", /timed in/);
      const rows = await ladder.evaluate((/** @type {any} */ element) => element.rows);
      // GMP's rational numbers are not in the page.
      const here = data.methods.filter(({ scalar }) => scalar !== "rational");
      const asked = data.families.flatMap(({ part }) => here.filter((each) => each.part === part));
      const ofBook = rows.filter((/** @type {Row} */ { method }) =>
        data.methods.some(({ id }) => id === method),
      );
      assert.equal(ofBook.length, asked.length);
      const peers = new Set(rows.map((/** @type {Row} */ { method }) => method));
      for (const { id } of here) peers.delete(id);
      assert.equal(peers.size, PEERS[data.ladder] ?? 0);
      for (const row of rows) {
        assert.ok(row.ns_median > 0 && row.ns_q1 <= row.ns_median && row.ns_median <= row.ns_q3);
        const method = data.methods.find((each) => each.id === row.method);
        if (method?.exact) assert.equal(row.wrong, 0, row.method);
      }
      assert.equal(await ladder.locator(".here tbody tr").count(), rows.length);
      // A second bar for each method, and for a pressed cell the reader's own numbers.
      assert.equal(await ladder.locator("rect.own").count(), here.length + peers.size);
      assert.equal(await ladder.locator("tr.peer").count(), peers.size);
      assert.equal(await ladder.locator("rect.book").count(), data.methods.length);
      await cellOf(ladder, rows[0]).click();
      assert.match((await ladder.locator(".cell").textContent()) ?? "", /In this browser:/);
      assert.deepEqual(await collisions(ladder), []);
      assert.deepEqual(trouble, []);
      await close();
    });

  for (const where of run)
    test(`${where}: cancelled`, async () => {
      const { page, close } = await open(chromium.browser, url(where));
      const ladder = page.locator("contact-ladder").first();
      await ladder.getByRole("button", { name: "Run it here", exact: true }).click();
      await ladder.getByRole("button", { name: "Cancel", exact: true }).click();
      await ladder.getByText("Stopped.").waitFor();
      assert.ok(await ladder.getByRole("button", { name: "Run it here", exact: true }).isVisible());
      await close();
    });
});
