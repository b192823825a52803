// Exercises in the page: solved by typing, checked by the book's own judge, and still there after
// whatever a student's program does. One download of the toolchain serves most of the tests; the
// first of each group begins with nothing kept but that.

import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { fieldsOf, notRun } from "./browser.mjs";
import {
  axe,
  changed,
  exerciseOn,
  hintFor,
  lineOf,
  newReader,
  pageOf,
  solutionOf,
  stubOf,
  testsOf,
  toolchainAsked,
  visit,
  wrongAnswersOf,
} from "./exercise_page.mjs";
import { inBrowser } from "./in_browser.mjs";

/** @typedef {import("./exercise_page.mjs").Exercise} Exercise */
/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").BrowserContext} BrowserContext */

const skip = notRun();
const segment = "01_planes/segment_plane";
const sphere = "01_planes/sphere_plane";
const distance = "01_planes/signed_distance";
const points = "01_planes/plane_from_points";

describe("exercises", { skip }, () => {
  const { server, chromium } = inBrowser();
  /** @type {BrowserContext} */
  let shared;
  /** The page on which most of the tests are made, one after the other. @type {Page} */
  let page;
  /** @type {string[]} */
  let trouble;
  /** @param {import("playwright-core").BrowserContextOptions} [options] */
  const nothingKept = (options) => newReader(chromium.browser, options);
  before(async () => {
    shared = await nothingKept();
    ({ page, trouble } = await visit(shared, server.origin, pageOf(segment)));
  });

  const asked = (since = 0) => toolchainAsked(server.asked.slice(since));

  /** The record of an exercise in the browser. @param {string} id */
  const recordOf = (id) =>
    page.evaluate(
      (exercise) =>
        JSON.parse(localStorage.getItem("contact-hours/1/progress") ?? "{}").exercises?.[exercise],
      id,
    );

  describe("from the stub to the last point", () => {
    /** @type {Exercise} */
    let exercise;
    const all = testsOf(segment);
    const total = all.reduce((sum, { points }) => sum + points, 0);
    before(async () => {
      exercise = exerciseOn(page, segment);
    });

    test("the stub as it is given is not attempted: no failure, no points", async () => {
      assert.equal(await exercise.check(), "not_attempted");
      assert.deepEqual(
        (await exercise.tests()).map(({ status }) => status),
        all.map(() => "not_attempted"),
      );
      assert.deepEqual(await exercise.failure(), []);
      assert.match(await exercise.status(), /not attempted/i);
      assert.doesNotMatch(await exercise.status(), /[1-9]\d* of \d+ points/);
      assert.equal((await recordOf(segment))?.best_points ?? 0, 0);
    });

    test("typed into the editor, the solution passes, with all its points and ticks", async () => {
      await exercise.typeOver("/*segment*/", "segment");
      await exercise.typeOver("/*plane*/", "plane");
      await exercise.typeOver(
        "contact::todo();",
        [
          "const double d0 = plane.normal.dot(segment.start) - plane.offset;",
          "const double d1 = plane.normal.dot(segment.end) - plane.offset;",
          "if ((d0 > 0 && d1 > 0) || (d0 < 0 && d1 < 0) || d0 == d1) return std::nullopt;",
          "const double t = d0 / (d0 - d1);",
          "return contact::RayHit<double>{t, segment.start + t * (segment.end - segment.start)};",
        ].join("\n"),
      );
      assert.equal(await exercise.check(), "passed", await exercise.status());
      assert.match(await exercise.status(), new RegExp(`\\b${total} of ${total} points`));
      const rows = await exercise.tests();
      assert.equal(rows.length, all.length);
      rows.forEach(({ status, text }, index) => {
        const { name = "", points } = all[index] ?? {};
        assert.equal(status, "passed", name);
        assert.ok(text.includes(name), `${text} is not ${name}`);
        assert.match(text, new RegExp(`\\b${points}\\b`), name);
      });
      assert.deepEqual(await exercise.failure(), []);
    });

    test("having passed, it says what comes next", async () => {
      const link = exercise.element.locator(".bench .next a");
      assert.match((await link.textContent()) ?? "", /\S/);
      await link.click();
      const { hash } = new URL(page.url());
      const after = await exercise.element.evaluate(
        (element, id) =>
          element.compareDocumentPosition(/** @type {Node} */ (document.getElementById(id))),
        hash.slice(1),
      );
      assert.equal(after, 4, `${hash} does not follow the exercise`);
    });

    test("after a reload the code and the verdict are back, and nothing was downloaded", async () => {
      const code = await exercise.text();
      const rows = await exercise.tests();
      const since = server.asked.length;
      await page.reload({ waitUntil: "load" });
      await page.waitForSelector(`contact-exercise[name="${segment}"][verdict="passed"]`);
      assert.deepEqual(await exercise.tests(), rows);
      assert.match(await exercise.status(), new RegExp(`\\b${total} of ${total} points`));
      await exercise.edit();
      assert.equal(await exercise.text(), code);
      assert.deepEqual(asked(since), {});
    });
  });

  test("by the keyboard alone: into the editor, checked, out of it, and a hint", async () => {
    const exercise = exerciseOn(page, distance);
    await page.reload({ waitUntil: "load" });
    const tabUntil = async (/** @type {(node: Element) => boolean} */ there, most = 300) => {
      for (let pressed = 0; pressed < most; ++pressed) {
        await page.keyboard.press("Tab");
        if (await page.evaluate(`(${there})(document.activeElement)`)) return;
      }
      throw new Error(`not reached with ${most} times Tab: ${there}`);
    };
    const inEditor = (/** @type {Element} */ node) =>
      node.closest(".code") !== null && node.closest('[name$="/signed_distance"]') !== null;
    await tabUntil(inEditor);
    await exercise.content.waitFor();
    assert.equal(
      await page.evaluate(() => document.activeElement?.getAttribute("contenteditable")),
      "true",
    );
    await page.keyboard.press("ControlOrMeta+A");
    await page.keyboard.type(
      '#include "signed_distance.hpp"\nnamespace exercise {double signed_distance(const PlaneEquation&, const Eigen::Vector3d&) {return 1;} int side(const PlaneEquation&, const Eigen::Vector3d&) {return 1;}}',
    );
    // Tab indents here, and so does not leave.
    await page.keyboard.press("Tab");
    assert.ok(await exercise.content.evaluate((node) => node === document.activeElement));
    assert.equal(
      await exercise.untilDone(() => page.keyboard.press("ControlOrMeta+Enter")),
      "failed",
    );
    assert.ok(await exercise.content.evaluate((node) => node === document.activeElement));
    await page.keyboard.press("Escape");
    await page.keyboard.press("Tab");
    assert.equal(await exercise.content.evaluate((node) => node === document.activeElement), false);
    await page.keyboard.press("Shift+Tab");
    await page.keyboard.press("Escape");
    await tabUntil((node) => node.matches("button") && node.textContent?.trim() === "Hint", 12);
    await page.keyboard.press("Space");
    await exercise.element.locator(".bench .hints > details").first().waitFor();
  });

  for (const id of [segment, distance])
    describe(`${id}: every wrong answer`, () => {
      /** @type {Exercise} */
      let exercise;
      before(async () => {
        exercise = exerciseOn(page, id);
      });

      test("there are some", () => assert.ok(wrongAnswersOf(id).length >= 3));

      for (const { name, text, misconception, caughtBy } of wrongAnswersOf(id))
        test(`${name}: what was asked, what came back, what is right, and its hint`, async () => {
          const known = misconception !== "none";
          assert.equal(await exercise.submit(text), "failed");
          const row = (await exercise.tests()).find((each) => each.text.includes(caughtBy));
          assert.equal(row?.status, "failed", caughtBy);
          const first = await exercise.failure();
          // More follows where the answers before it have failed the same test.
          const order = first.map(({ what }) => what).slice(0, 4);
          assert.deepEqual(order, ["Asked", "Input", "Came back", "Right"]);
          // The test that catches it may be another one than the first that fails; then it is folded.
          const failure = (await exercise.failureOf(caughtBy)).slice(0, known ? 5 : 4);
          assert.deepEqual(
            failure.map(({ what }) => what),
            ["Asked", "Input", "Came back", "Right", ...(known ? ["Hint"] : [])],
          );
          for (const { what, says } of failure) assert.ok(says.length > 0, what);
          if (known) assert.equal(failure.at(-1)?.says, hintFor(misconception));
        });
    });

  describe("programs that end badly", () => {
    /** @type {Exercise} */
    let exercise;
    const all = testsOf(segment);
    const which = all.findIndex(({ name }) => name === "tiny distances keep their signs");
    before(async () => {
      exercise = exerciseOn(page, segment);
    });

    /** The solution, which does something else when it is asked for one tiny distance.
     * @param {string} statement @param {string} before what stands before the function */
    const endingWith = (statement, before = "") =>
      changed(
        changed(
          solutionOf(segment),
          "  const double d0",
          `  if (segment.start.z() == 0x1p-600) {\n    ${statement}\n  }\n  const double d0`,
        ),
        "namespace exercise {\n",
        `${before}\nnamespace exercise {\n`,
      );
    const endless = endingWith("volatile int turn = 0;\n    for (;;) turn = 1 - turn;");

    /** One test is stopped and says why; the others have kept their points. @param {RegExp} why */
    async function costsOneTest(why) {
      assert.deepEqual(
        (await exercise.tests()).map(({ status }) => status),
        all.map((_, index) => (index === which ? "stopped" : "passed")),
      );
      const failure = await exercise.failure();
      const stopped = failure.find(({ what }) => what === "What stopped the test");
      assert.match(stopped?.says ?? "nothing said", why);
      const asked = failure.find(({ what }) => what === "Asked");
      assert.match(asked?.says ?? "nothing said", /Where does the segment meet the plane\?/);
    }

    // How else an answer may end: parity.test.mjs, beside the verdict of the program.
    const cases = [
      {
        name: "a null pointer followed",
        why: /memory|null/i,
        code: endingWith(
          "const double* volatile nowhere = nullptr;\n    if (*nowhere > 0) return std::nullopt;",
        ),
      },
      {
        name: "an exception",
        why: /lost my way/,
        code: endingWith('throw std::runtime_error("lost my way");'),
      },
    ];
    for (const { name, why, code } of cases)
      test(`${name} costs its test only and is called by its name`, async () => {
        assert.equal(await exercise.submit(code), "failed");
        await costsOneTest(why);
      });

    test("while a loop runs without end the page answers; then its limit stops it", async () => {
      await exercise.paste(endless);
      const figure = page.locator(`contact-figure[name="${segment}"]`);
      await figure.evaluate((/** @type {any} */ it) => it.ready);
      // The limit is on the loop, not on the hands of a slow machine: they get three tries.
      for (let tries = 3, running = false; !running; --tries) {
        assert.ok(tries > 0, "the loop ended before the page had answered");
        const start = await fieldsOf(figure, "input");
        const verdict = await exercise.untilDone(async () => {
          await exercise.press("Check");
          await page.waitForSelector(`contact-exercise[name="${segment}"][state="running"]`);
          await figure.locator(".stage").scrollIntoViewIfNeeded();
          const knob = await figure.locator(".grip .knob").first().boundingBox();
          assert.ok(knob);
          await page.mouse.move(knob.x + knob.width / 2, knob.y + knob.height / 2);
          await page.mouse.down();
          await page.mouse.move(knob.x + 30, knob.y - 20, { steps: 5 });
          await page.mouse.up();
          assert.notDeepEqual(await fieldsOf(figure, "input"), start);
          await exercise.content.focus();
          await page.keyboard.press("ControlOrMeta+End");
          await page.keyboard.type("// still here");
          assert.match(await exercise.text(), /\/\/ still here$/);
          running = (await exercise.attribute("state")) === "running";
        });
        assert.equal(verdict, "failed");
      }
      await costsOneTest(/second/i);
    });

    test("Stop ends a check; the next one has the same compiler, without a download", async () => {
      const attempts = (await recordOf(segment)).attempts;
      await exercise.paste(endless);
      await exercise.press("Check");
      await page.waitForSelector(`contact-exercise[name="${segment}"][state="running"]`);
      const since = server.asked.length;
      const compilers = page.workers().filter((worker) => /compile/.test(worker.url()));
      assert.equal(compilers.length, 1, `${page.workers().map((worker) => worker.url())}`);
      await exercise.press("Stop");
      await exercise.element
        .locator(".status")
        .filter({ hasText: /^Stopped\./ })
        .waitFor();
      assert.match((await exercise.attribute("state")) ?? "", /idle|done/);
      assert.equal((await recordOf(segment)).attempts, attempts);
      assert.equal(await exercise.submit(solutionOf(segment)), "passed");
      assert.ok(page.workers().includes(/** @type {any} */ (compilers[0])));
      assert.deepEqual(asked(since), {});
    });
  });

  describe("what does not compile", () => {
    /** @type {Exercise} */
    let exercise;
    const solution = solutionOf(segment);
    before(async () => {
      exercise = exerciseOn(page, segment);
    });

    const head = "namespace exercise {\n";
    const tail = "}  // namespace exercise\n";
    /** `at`: what stands on the line that the message must point to, if it points to one. */
    const cases = [
      {
        name: "a semicolon left out",
        code: changed(
          solution,
          "- plane.offset;\n  const double d1",
          "- plane.offset\n  const double d1",
        ),
        words: /;|semicolon/i,
        original: /expected ';'/,
        at: "const double d0",
      },
      {
        name: "no function at all",
        code: `#include "segment_plane.hpp"\n`,
        words: /contract asks for segment_plane, and your file does not define it/,
        original: /undefined symbol/,
      },
      {
        name: "another signature",
        code: changed(
          solution,
          "const contact::Segment<double>& segment,",
          "contact::Segment<double> segment,",
        ),
        words: /parameters are not the contract's/,
        original: /undefined symbol/,
        at: "std::optional",
      },
      {
        name: "the function outside the namespace",
        code: changed(changed(solution, head, ""), tail, ""),
        words: /not in namespace exercise/,
        original: /undefined symbol/,
        at: "std::optional",
      },
      {
        name: "a main of one's own",
        code: `${solution}\nint main() { return 0; }\n`,
        words: /bring their own main/,
        original: /duplicate symbol/,
      },
      {
        name: "the contract not included",
        code: changed(solution, '#include "segment_plane.hpp"\n', ""),
        words: /does not include "segment_plane\.hpp"/,
        original: /contact/,
        at: "std::optional",
      },
    ];
    for (const { name, code, words, original, at } of cases)
      test(`${name}: in words, with the compiler's own one click away`, async () => {
        assert.equal(await exercise.submit(code), "does_not_compile");
        const messages = await exercise.messages();
        assert.ok(messages.length > 0);
        const [first] = messages;
        assert.match(first?.words ?? "", words);
        assert.equal(first?.open, false);
        assert.match(first?.original ?? "", original);
        await exercise.element.locator(".messages > li summary").first().click();
        assert.ok(
          await exercise.element
            .locator(".messages > li details > :not(summary)")
            .first()
            .isVisible(),
        );
        const wanted = at === undefined ? [] : [lineOf(code, at)];
        const marked = (await exercise.marks()).map(({ line }) => line);
        assert.deepEqual(marked.slice(0, 1), wanted);
      });

    test("a message leads to its line, which is marked in the editor", async () => {
      const code = changed(
        solution,
        "plane.offset;\n  const double d1",
        "plane.ofset;\n  const double d1",
      );
      assert.equal(await exercise.submit(code), "does_not_compile");
      const line = lineOf(code, "plane.ofset");
      const link = exercise.element
        .locator(".messages > li")
        .first()
        .getByText(new RegExp(`line ${line}\\b`, "i"));
      await link.first().click();
      const caret = await page.evaluate(() => {
        const { anchorNode } = /** @type {Selection} */ (getSelection());
        return (anchorNode instanceof Element ? anchorNode : anchorNode?.parentElement)?.closest(
          ".cm-line",
        )?.textContent;
      });
      assert.match(caret ?? "", /plane\.ofset/);
      assert.ok(await exercise.content.evaluate((node) => node === document.activeElement));
      const [mark] = await exercise.marks();
      assert.equal(mark?.line, line);
      assert.match(mark?.text ?? "", /ofset/);
    });

    test("what does not compile is no attempt, and the marks go with the mistake", async () => {
      const { attempts = 0 } = (await recordOf(segment)) ?? {};
      assert.equal(
        await exercise.submit(changed(solution, "return", "retrun")),
        "does_not_compile",
      );
      assert.equal((await recordOf(segment))?.attempts ?? 0, attempts);
      assert.ok((await exercise.marks()).length > 0);
      assert.equal(await exercise.submit(solution), "passed");
      assert.deepEqual(await exercise.marks(), []);
      assert.deepEqual(await exercise.messages(), []);
    });
  });

  describe("help on the way", () => {
    /** @type {Exercise} */
    let exercise;
    before(async () => {
      exercise = exerciseOn(page, sphere);
    });

    test("Hint gives one more each time, and the record counts them", async () => {
      const hints = exercise.element.locator(".bench .hints > details");
      assert.equal(await hints.count(), 0);
      await exercise.press("Hint");
      await hints.nth(0).waitFor();
      assert.equal(await hints.count(), 1);
      await exercise.press("Hint");
      await hints.nth(1).waitFor();
      assert.equal(await hints.count(), 2);
      assert.notEqual(await hints.nth(0).textContent(), await hints.nth(1).textContent());
      assert.equal((await recordOf(sphere)).hints_shown, 2);
    });

    test("Reset gives the stub back; Undo reset gives the code back", async () => {
      const mine = `${stubOf(sphere)}// mine\n`;
      await exercise.paste(mine);
      await exercise.press("Reset");
      assert.equal(await exercise.text(), stubOf(sphere));
      await exercise.press("Undo reset");
      assert.equal(await exercise.text(), mine);
    });

    test("an earlier version comes back from the list, and the present one goes there", async () => {
      const early = `${stubOf(sphere)}// early\n`;
      const late = `${stubOf(sphere)}// late\n`;
      await exercise.paste(early);
      await exercise.press("Reset");
      await exercise.paste(late);
      const versions = exercise.element.locator(".bench .versions");
      await versions.locator("summary").click();
      await versions.getByRole("button").first().click();
      assert.equal(await exercise.text(), early);
      await versions.getByRole("button").first().click();
      assert.equal(await exercise.text(), late);
    });

    test("the solution is shown at once after passing", async () => {
      const done = exerciseOn(page, segment);
      assert.ok((await recordOf(segment)).passed);
      await done.press("Solution");
      await done.element.locator(".bench .solution").waitFor();
      assert.equal(await done.button("Show it all the same").count(), 0);
    });

    test("the solution is shown before passing at the second request", async () => {
      const solution = exercise.element.locator(".bench .solution");
      await exercise.press("Solution");
      await exercise.button("Show it all the same").waitFor();
      assert.equal(await solution.isVisible(), false);
      assert.notEqual((await recordOf(sphere))?.solution_shown, true);
      await exercise.press("Show it all the same");
      await solution.waitFor();
      assert.match((await solution.textContent()) ?? "", /squaredNorm|norm\(\)/);
      assert.equal((await recordOf(sphere)).solution_shown, true);
    });
  });

  describe("to every reader", () => {
    /** @type {Exercise} one that has not been touched so far */
    let exercise;
    before(() => {
      exercise = exerciseOn(page, points);
    });
    const [wrong] = wrongAnswersOf(points);
    /** @type {[string, () => Promise<unknown>][]} */
    const stages = [
      [
        "before use",
        async () => page.evaluate(() => customElements.whenDefined("contact-exercise")),
      ],
      ["with the editor open", () => exercise.edit()],
      ["with a failure", () => exercise.submit(/** @type {any} */ (wrong).text)],
      [
        "with messages of the compiler",
        () => exercise.submit(changed(solutionOf(points), "return", "retrun")),
      ],
      ["passed", () => exercise.submit(solutionOf(points))],
    ];
    for (const [stage, reach] of stages) {
      for (const colorScheme of /** @type {const} */ (["light", "dark"]))
        test(`${stage}: axe finds nothing, ${colorScheme}`, async () => {
          if (colorScheme === "light") await reach();
          await page.emulateMedia({ colorScheme });
          assert.deepEqual(await axe(page, `contact-exercise[name="${points}"]`), []);
        });
      test(`${stage}: nothing sticks out at 390 pixels`, async () => {
        await page.setViewportSize({ width: 390, height: 844 });
        const out = await exercise.element.evaluate((element) =>
          [
            element,
            ...element.querySelectorAll(
              ".bench > *, .buttons > *, .tests > *, .failure, .messages",
            ),
          ]
            .filter((node) => node.getBoundingClientRect().right > 390)
            .map((node) => node.className || node.tagName),
        );
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        await page.setViewportSize({ width: 1200, height: 900 });
        assert.deepEqual({ out, wide: Math.max(wide, 390) }, { out: [], wide: 390 });
      });
    }
  });

  test("nothing went wrong in the console meanwhile, and no other server was asked", () =>
    assert.deepEqual(trouble, []));
});
