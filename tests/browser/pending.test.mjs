// A page that is read while the book is still being built: a figure that is not there yet says how
// many are before it, and appears by itself.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { figuresOn, launch, lessons, notRun, open, serve, site } from "./browser.mjs";
import { exerciseOn, PATIENCE, pageOf } from "./exercise_page.mjs";
import { chaptersTaken } from "./sample.mjs";

const EXERCISE = "02_triangles/ray_triangle";

const skip = notRun();

/** A lesson with its first figure, which is built, as it is served before the figure is built. */
function unbuilt() {
  for (const page of lessons()) {
    const [first] = figuresOn(page);
    if (!first?.built) continue;
    const text = fs.readFileSync(path.join(site, page), "utf8");
    const html = text.replace(
      /(<contact-figure[^>]*>)<img[^>]*>/,
      '$1<p class="not-built">This figure is still being built.</p>',
    );
    assert.ok(html.includes("not-built"), `${page} has a picture in its first figure`);
    return { page, figure: first.name, html };
  }
  throw new Error("no lesson begins with a figure that is built");
}

test("a figure that is not built yet waits for its turn, and appears", { skip }, async () => {
  const { browser, close } = await launch();
  const served = await serve();
  try {
    const { page: lesson, figure, html } = unbuilt();
    const queue = ["other/one", figure];
    served.answer = (pathname, response) => {
      if (pathname !== `/${lesson}`) return false;
      response.end(html);
      return true;
    };
    // A worker would ask the server itself.
    const {
      page,
      trouble,
      close: leave,
    } = await open(browser, "about:blank", {
      serviceWorkers: "block",
    });
    /** @type {(string | null)[]} */
    const wanted = [];
    await page.route("**/building.json*", (route) => {
      wanted.push(new URL(route.request().url()).searchParams.get("want"));
      return route.fulfill({ json: { waiting: queue, building: queue.slice(0, 1) } });
    });
    await page.goto(`${served.origin}/${lesson}`);
    const element = page.locator("contact-figure").first();
    await element.scrollIntoViewIfNeeded();
    await element.getByText("This is not built yet: one other is before it.").waitFor();
    assert.equal(await element.getAttribute("name"), figure);
    queue.shift();
    await element.getByText("This is being built now.").waitFor();
    assert.equal(await element.locator(".stage").count(), 0);
    queue.shift();
    await element.locator(".stage").waitFor();
    assert.ok(await element.evaluate((/** @type {any} */ live) => live.output !== undefined));
    assert.deepEqual([...new Set(wanted)], [figure]);
    assert.deepEqual(
      trouble.filter((what) => !what.startsWith("off the origin")),
      [],
    );
    await leave();
  } finally {
    served.close();
    await close();
  }
});

/** A queue as the server tells it, in which what is asked for is built when the test says so. */
async function queued(/** @type {import("playwright-core").Page} */ page) {
  /** @type {string[]} */
  const queue = [];
  /** @type {Set<string | null>} */
  const wanted = new Set();
  await page.route("**/building.json*", (route) => {
    wanted.add(new URL(route.request().url()).searchParams.get("want"));
    return route.fulfill({ json: { waiting: queue, building: queue.slice(0, 1) } });
  });
  return { queue, wanted };
}

/** A figure of another turn is asked for where the page is scrolled to it. @param {Set<unknown>} wanted */
const withoutFigures = (wanted) =>
  [...wanted].filter((one) => /^(ladder|exercise) /.test(`${one}`));

test("a ladder that is not built yet waits for its turn, and runs", { skip }, async () => {
  const { browser, close } = await launch();
  const served = await serve();
  try {
    const { page } = await open(browser, "about:blank", { serviceWorkers: "block" });
    const { queue, wanted } = await queued(page);
    const [slug] = chaptersTaken("ladder");
    const unbuilt = `**/ladders/${slug}.wasm`;
    await page.route(unbuilt, (route) => route.fulfill({ status: 404 }));
    await page.goto(`${served.origin}/chapters/${slug}.html`);
    const ladder = page.locator("contact-ladder").first();
    const run = ladder.getByRole("button", { name: "Run it here", exact: true });
    queue.push("other/one", `ladder ${slug}`);
    await run.click();
    await ladder.getByText("This is not built yet: one other is before it.").waitFor();
    await ladder.getByRole("button", { name: "Cancel", exact: true }).click();
    await ladder.getByText("Stopped.").waitFor();
    await run.click();
    await ladder.getByText("This is not built yet").waitFor();
    await page.unroute(unbuilt);
    queue.length = 0;
    await ladder.getByText(/timed in/).waitFor({ timeout: 60_000 });
    assert.deepEqual(withoutFigures(wanted), [`ladder ${slug}`]);
  } finally {
    served.close();
    await close();
  }
});

test("a check whose tests are not built yet waits for them", { skip }, async () => {
  const { browser, close } = await launch();
  const served = await serve();
  try {
    const { page } = await open(browser, "about:blank", { serviceWorkers: "block" });
    const { queue, wanted } = await queued(page);
    await page.route("**/cpp/manifest.json", (route) => route.fulfill({ status: 404 }));
    await page.goto(`${served.origin}/${pageOf(EXERCISE)}`);
    queue.push("other/one", `exercise ${EXERCISE}`);
    const { element, press } = exerciseOn(page, EXERCISE);
    await press("Check");
    await element.getByText("This is not built yet: one other is before it.").waitFor();
    assert.equal(await element.getAttribute("state"), "loading");
    queue.length = 0;
    await page.unroute("**/cpp/manifest.json");
    await page
      .locator(`contact-exercise[name="${EXERCISE}"][state=done]`)
      .waitFor({ timeout: PATIENCE });
    assert.deepEqual(withoutFigures(wanted), [`exercise ${EXERCISE}`]);
  } finally {
    served.close();
    await close();
  }
});
