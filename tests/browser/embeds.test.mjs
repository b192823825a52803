// Pages to embed, in frames of a page of another origin: they work there as in the lesson, the frame is as high as its
// content, and the theme is the one that the address asks for. An exercise works from a disk, too.

import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, describe } from "node:test";
import { pathToFileURL } from "node:url";
import {
  completeLessons,
  fieldsOf,
  figuresOn,
  gatherTrouble,
  loadFigure,
  notRun,
  notYetServed,
  serve,
  site,
} from "./browser.mjs";
import { PATIENCE, solutionOf } from "./exercise_page.mjs";
import { inBrowser } from "./in_browser.mjs";
import { ofAll } from "./sample.mjs";

const skip = notRun();
const exercise = "01_planes/signed_distance";
/** @param {string} kind @param {string} ref */
const pathOf = (kind, ref) => `embed/${ref.replace("/", `/${kind}/`)}.html`;

/** A question with options of the first lesson, and which of them is right. */
function choice() {
  const folder = path.join(site, "embed", "01_planes", "question");
  for (const file of fs.readdirSync(folder).sort()) {
    const html = fs.readFileSync(path.join(folder, file), "utf8");
    const data = JSON.parse(
      html.match(/<script type="application\/json">(.*?)<\/script>/s)?.[1] ?? "{}",
    );
    if (data.kind === "choose")
      return { where: `embed/01_planes/question/${file}`, key: data.answer };
  }
  throw new Error("the lesson has no question with options");
}

describe("embedded", { skip }, () => {
  const { server: book, chromium } = inBrowser();
  const course = notYetServed();
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "contact-course-"));
  before(() => serve(folder, course));
  after(() => {
    course.close();
    fs.rmSync(folder, { recursive: true, force: true });
  });

  /**
   * A page of a course with one frame in it.
   * @param {string} where the page to embed
   * @param {{ script?: boolean, width?: number, more?: string, colorScheme?: "light" | "dark" }} [options]
   */
  async function embed(
    where,
    { script = true, width = 1000, more = "", colorScheme = "light" } = {},
  ) {
    const name = `${where.replace(/\W+/g, "_")}.html`;
    const line = script ? `<script src="${book.origin}/embed/embed.js" async></script>` : "";
    fs.writeFileSync(
      path.join(folder, name),
      `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A course</title>
<meta name="viewport" content="width=device-width"><link rel="icon" href="data:,"></head>
<body><h1>A course</h1><iframe id="part" src="${book.origin}/${where}" title="A part of the book" allow="clipboard-write"
style="width: 100%; height: 300px; border: 2px solid; box-sizing: border-box"></iframe>${more}${line}</body></html>`,
    );
    const context = await chromium.browser.newContext({
      viewport: { width, height: 800 },
      colorScheme,
      reducedMotion: "reduce",
      permissions: ["clipboard-read", "clipboard-write"],
    });
    const page = await context.newPage();
    const all = gatherTrouble(page, course.origin);
    await page.goto(`${course.origin}/${name}`, { waitUntil: "load" });
    const element = page.locator("#part");
    const frame = await (await element.elementHandle())?.contentFrame();
    assert.ok(frame);
    await frame.waitForLoadState("load");
    await frame.evaluate(() => document.fonts.ready);
    const trouble = () => all.filter((line) => !line.startsWith(`off the origin: ${book.origin}/`));
    /** Waits until the frame shows exactly its content. */
    const fits = async () => {
      const content = () =>
        frame.evaluate(() => Math.ceil(document.body.getBoundingClientRect().height));
      for (let tries = 0; ; tries += 1) {
        const [inside, outside] = [
          await content(),
          await element.evaluate((it) => it.clientHeight),
        ];
        if (inside === outside) return outside;
        if (tries > 100) assert.fail(`the content is ${inside} high, and the frame ${outside}`);
        await page.waitForTimeout(50);
      }
    };
    const overflows = () => frame.evaluate(() => document.documentElement.scrollWidth > innerWidth);
    return { page, frame, element, trouble, fits, overflows, close: () => context.close() };
  }

  /** A figure that this run has built. */
  function figure() {
    const [built] = completeLessons().flatMap(figuresOn);
    assert.ok(built);
    return built.name;
  }

  /**
   * Writes the solution into the editor of an exercise, and waits for the verdict.
   * @param {import("playwright-core").Page} page @param {import("playwright-core").Page | import("playwright-core").Frame} inside
   */
  async function solve(page, inside) {
    const bench = inside.locator("contact-exercise");
    await bench.locator(".code pre").first().click();
    const content = bench.locator(".code .cm-content");
    await content.waitFor();
    await content.focus();
    await page.keyboard.press("ControlOrMeta+A");
    await page.evaluate((text) => navigator.clipboard.writeText(text), solutionOf(exercise));
    await page.keyboard.press("ControlOrMeta+V");
    await bench
      .locator(".bench")
      .getByRole("button", { name: /^Check/ })
      .click();
    await inside.waitForFunction(
      () => document.querySelector("contact-exercise")?.getAttribute("state") === "done",
      undefined,
      { timeout: PATIENCE },
    );
    return bench;
  }

  ofAll("a figure moves", async () => {
    const name = figure();
    const { page, frame, trouble, fits, close } = await embed(pathOf("figure", name));
    const live = frame.locator(`contact-figure[name="${name}"]`);
    await loadFigure(live);
    const before = await fieldsOf(live, "input");
    const control = live.locator(".grip, input[type=range]").first();
    await control.focus();
    await page.keyboard.press("ArrowRight");
    assert.notDeepEqual(await fieldsOf(live, "input"), before);
    assert.equal(await frame.locator("contact-figure").count(), 1);
    await fits();
    assert.deepEqual(trouble(), []);
    await close();
  });

  ofAll("the link to a figure's state leads to the page to embed", async () => {
    const name = figure();
    const where = pathOf("figure", name);
    const { frame, trouble, close } = await embed(where);
    const live = frame.locator(`contact-figure[name="${name}"]`);
    await loadFigure(live);
    await live.getByRole("button", { name: "Copy link" }).click();
    await frame.waitForFunction(() => location.hash !== "");
    assert.ok(frame.url().startsWith(`${book.origin}/${where}#figure=${name}&`), frame.url());
    assert.deepEqual(trouble(), []);
    await close();
  });

  ofAll("a question is answered, and the frame grows with the explanation", async () => {
    const { where, key } = choice();
    const { frame, trouble, fits, close } = await embed(where);
    const question = frame.locator("contact-question");
    const before = await fits();
    await question.locator(".option input").nth(key).check();
    await question.getByRole("button", { name: "Check", exact: true }).click();
    await question.getByText("Right.").waitFor();
    assert.equal(await question.getAttribute("result"), "right");
    assert.ok((await fits()) > before);
    assert.deepEqual(trouble(), []);
    await close();
  });

  ofAll("an exercise is solved and checked", async () => {
    const { page, frame, trouble, fits, close } = await embed(pathOf("exercise", exercise));
    const bench = await solve(page, frame);
    assert.equal(await bench.getAttribute("verdict"), "passed");
    await fits();
    assert.deepEqual(trouble(), []);
    await close();
  });

  ofAll("saved with the compiler, it is checked from a disk without a network", async () => {
    const context = await chromium.browser.newContext({
      acceptDownloads: true,
      permissions: ["clipboard-read", "clipboard-write"],
    });
    const page = await context.newPage();
    const trouble = gatherTrouble(page, book.origin);
    await page.goto(`${book.origin}/${pathOf("exercise", exercise)}`, { waitUntil: "load" });
    const [download] = await Promise.all([
      page.waitForEvent("download", { timeout: PATIENCE }),
      page.getByRole("button", { name: "Save with the compiler" }).click(),
    ]);
    const file = path.join(folder, "saved.html");
    await download.saveAs(file);
    assert.deepEqual(trouble, []);
    await context.setOffline(true);
    const asked = book.asked.length;
    await page.goto(String(pathToFileURL(file)), { waitUntil: "load" });
    await solve(page, page);
    assert.equal(await page.locator("contact-exercise").getAttribute("verdict"), "passed");
    assert.equal(book.asked.length, asked);
    assert.deepEqual(
      trouble.filter((line) => !line.startsWith("off the origin: file:")),
      [],
    );
    await context.close();
  });

  for (const width of [360, 1000])
    ofAll(`at ${width} px each kind fits its frame, and nothing is wider`, async () => {
      const parts = [pathOf("figure", figure()), pathOf("exercise", exercise), choice().where];
      for (const where of parts) {
        const { frame, trouble, fits, overflows, close } = await embed(where, { width });
        for (const live of await frame.locator("contact-figure").all()) await loadFigure(live);
        await fits();
        assert.equal(await overflows(), false, where);
        assert.deepEqual(trouble(), [], where);
        await close();
      }
    });

  ofAll("the theme is the address's, else the system's", async () => {
    const { where } = choice();
    /** @param {string} query @param {"light" | "dark"} colorScheme */
    const paper = async (query, colorScheme) => {
      const { frame, close } = await embed(`${where}${query}`, { colorScheme });
      const colour = await frame.evaluate(() => getComputedStyle(document.body).backgroundColor);
      await close();
      return colour;
    };
    const [light, dark] = [await paper("", "light"), await paper("", "dark")];
    assert.notEqual(light, dark);
    assert.equal(await paper("?theme=dark", "light"), dark);
    assert.equal(await paper("?theme=light", "dark"), light);
  });

  ofAll("without the script the frame keeps its height, and its content scrolls", async () => {
    const { frame, element, trouble, close } = await embed(pathOf("exercise", exercise), {
      script: false,
    });
    assert.equal(await element.evaluate((it) => it.offsetHeight), 300);
    const scrolled = await frame.evaluate(() => {
      scrollTo({ top: 100, behavior: "instant" });
      return scrollY;
    });
    assert.equal(scrolled, 100);
    assert.deepEqual(trouble(), []);
    await close();
  });

  ofAll("a frame of another origin cannot ask for a height", async () => {
    const says =
      "<script>parent.postMessage({ type: 'contact-embed', height: 5000 }, '*')</script>";
    const { page, fits, close } = await embed(choice().where, {
      more: `<iframe id="other" title="Another" style="height: 100px" srcdoc="${says}"></iframe>`,
    });
    await fits();
    await page.evaluate(() => {
      const other = /** @type {HTMLIFrameElement} */ (document.querySelector("#other"));
      other.srcdoc += " ";
      return new Promise((done) => other.addEventListener("load", done, { once: true }));
    });
    await page.waitForTimeout(50);
    const height = await page.locator("#other").evaluate((it) => it.clientHeight);
    assert.equal(height, 100);
    await close();
  });

  ofAll("in a window of its own it has the HTML to copy, and leads to its lesson", async () => {
    const { where } = choice();
    const context = await chromium.browser.newContext();
    const page = await context.newPage();
    const trouble = gatherTrouble(page, book.origin);
    await page.goto(`${book.origin}/${where}`, { waitUntil: "load" });
    const html = await page.getByLabel("The HTML to embed this").inputValue();
    assert.ok(html.includes(`<iframe src="${book.origin}/${where}"`), html);
    assert.ok(html.includes(`<script src="${book.origin}/embed/embed.js"`), html);
    const [lesson] = await Promise.all([
      context.waitForEvent("page"),
      page.locator(".from a").click(),
    ]);
    await lesson.waitForLoadState("load");
    const name = path.basename(where, ".html");
    assert.equal(lesson.url(), `${book.origin}/chapters/01_planes.html#question-${name}`);
    const link = lesson.locator(`#question-${name} .embed-link`);
    assert.equal(
      await link.evaluate((a) => a instanceof HTMLAnchorElement && a.href),
      `${book.origin}/${where}`,
    );
    assert.deepEqual(trouble, []);
    await context.close();
  });
});
