// The checker in a real browser, against what page/wasm/build.mjs made: downloads, limits, stops, and what the page
// keeps. That verdicts are those of the command line: tests/browser/parity.test.mjs.

import assert from "node:assert/strict";
import fs from "node:fs";
import { after, before, describe, test } from "node:test";
import { launch, notRun, open, serve } from "../../../../tests/browser/browser.mjs";
import { check, exerciseData, makePage, notBuilt, root } from "./checker_page.mjs";

const skip = notRun() || notBuilt();
const id = "02_triangles/ray_triangle";
/** @param {string} exercise */
const solutionOf = (exercise) =>
  fs.readFileSync(`${root}/solutions/${exercise}/${exercise.split("/")[1]}.cpp`, "utf8");
/** The solution, which does something else first. @param {string} code @param {string} [above] */
function with_(code, above = "") {
  const begin = "  const Eigen::Vector3d e1";
  const text = solutionOf(id);
  assert.ok(text.includes(begin));
  return `#include <cstdio>\n#include <cstdlib>\n${above}${text.replace(begin, `${code}\n${begin}`)}`;
}

/** @type {Awaited<ReturnType<typeof makePage>>} */
let folder;
/** @type {Awaited<ReturnType<typeof serve>>} */
let server;
/** @type {Awaited<ReturnType<typeof launch>>} */
let browser;
/** @type {Awaited<ReturnType<typeof open>>} */
let shown;

/** @param {string} source @param {Parameters<typeof check>[3]} [options] */
const checked = (source, options) => check(shown.page, id, source, options);

/** What stopped each test that did not pass. @param {Awaited<ReturnType<typeof check>>} result */
function reasons({ verdict, error }) {
  assert.ok(verdict, error);
  return verdict.tests
    .filter(({ status }) => status === "stopped")
    .map(({ failure }) => failure?.reason ?? "");
}

/** @param {Awaited<ReturnType<typeof check>>} result @param {RegExp} reason */
function allStopped(result, reason) {
  const told = reasons(result);
  assert.equal(told.length, result.verdict?.tests.length, JSON.stringify(result.verdict?.tests));
  for (const text of told) assert.match(text, reason);
  assert.equal(result.verdict?.points, 0);
}

describe("the checker", { skip }, () => {
  before(async () => {
    folder = await makePage();
    server = await serve(folder.folder);
    browser = await launch();
    shown = await open(browser.browser, `${server.origin}/index.html`);
    await shown.page.waitForFunction("document.body.dataset.ready");
  });
  after(async () => {
    await shown?.close();
    await browser?.close();
    server?.close();
    folder?.remove();
  });

  const size = () => shown.page.evaluate("checker.size()");
  const manifest = () => JSON.parse(fs.readFileSync(`${root}/build/web/cpp/manifest.json`, "utf8"));
  const weight = (/** @type {string[]} */ keys) =>
    keys.reduce((sum, key) => sum + manifest().files[key].transfer, 0);

  test("an interrupted download is reported, and continues from the complete files", async () => {
    const { core, behind } = manifest();
    assert.deepEqual(await size(), { core: weight(core), behind: weight(behind), kept: true });
    server.answer = (pathname, response, file) => {
      if (!/llvm\.core\.[0-9a-f]{8}/.test(pathname)) return false;
      response.setHeader("content-length", fs.statSync(file).size);
      const part = fs.readFileSync(file).subarray(0, 3e6);
      response.write(part, () => setTimeout(() => response.destroy(), 1500));
      return true;
    };
    const { error, told } = await checked(solutionOf(id));
    assert.match(error ?? "", /^CheckerError: The download broke off/);
    assert.ok(told.some(({ step, received = 0 }) => step === "download" && received > 2e6));
    delete server.answer;
    server.asked.length = 0;
    const { verdict } = await checked(solutionOf(id));
    assert.equal(verdict?.verdict, "passed");
    assert.ok(server.asked.some((name) => /llvm\.core\./.test(name)));
    assert.deepEqual(
      server.asked.filter((name) => /system|checks\./.test(name)),
      [],
    );
    shown.trouble.length = 0; // the broken download
  });

  // Those of a third of the exercises: tests/browser/parity.test.mjs.
  test("a stub is not attempted", async () => {
    const stub = exerciseData(id).files[`exercises/${id}/ray_triangle.cpp`] ?? "";
    const { verdict } = await checked(stub);
    assert.equal(verdict?.verdict, "not_attempted");
  });

  test("nothing is downloaded again, and a check needs no network", async () => {
    // What is not needed for a first check comes behind it.
    await shown.page.waitForFunction("checker.size().then(({ behind }) => behind === 0)");
    assert.deepEqual(await size(), { core: 0, behind: 0, kept: true });
    await shown.page.route("**/cpp/**", (route) => route.abort());
    await shown.page.reload();
    await shown.page.waitForFunction("document.body.dataset.ready");
    const { verdict, told } = await checked(solutionOf(id));
    assert.equal(verdict?.verdict, "passed");
    assert.ok(told.every(({ step }) => step !== "download"));
    await shown.page.unroute("**/cpp/**");
    shown.trouble.length = 0; // the requests that were refused
  });

  test("an endless loop costs its test, and says which question has no answer", async () => {
    const source = with_("  if (ray.direction.x() > 1.5) for (volatile int i = 0;; i = i + 1) {}");
    const { verdict, told } = await checked(source);
    const stopped = verdict?.tests.filter(({ status }) => status === "stopped") ?? [];
    assert.ok(stopped.length > 0 && stopped.length < (verdict?.tests.length ?? 0));
    for (const { failure } of stopped) {
      assert.match(failure?.reason ?? "", /^no answer after (2|0\.5) seconds: an endless loop/);
      assert.match(failure?.asked ?? "", /\?$/);
      const ray = failure?.inputs.find(({ name }) => name === "ray")?.text ?? "";
      assert.ok(Number(/direction: \(([^,]*),/.exec(ray)?.[1]) > 1.5, ray);
    }
    assert.ok(told.every(({ step }) => step !== "start" && step !== "download"));
  });

  test("more is said of a test that failed before with other code", async () => {
    const name = "random rays agree with exact arithmetic";
    const source = with_(
      "  const double x = std::abs(triangle.a.x());\n  if (x > 0.01 && x != std::round(x)) return {};",
    );
    const after = async (/** @type {string[]} */ codes) => {
      const exercises = { [id]: { failing: { [name]: codes } } };
      const progress = { format: "contact-progress/1", exercises };
      const { verdict } = await checked(source, { progress });
      return verdict?.tests.find((one) => one.name === name);
    };
    assert.equal((await after([]))?.look, undefined);
    const { look } = (await after(["one"])) ?? {};
    assert.equal((look?.right ?? 0) + (look?.wrong ?? 0), 500);
    assert.equal(look?.smaller, undefined);
    const failed = await after(["one", "two", "three"]);
    const triangle = (
      /** @type {import("../../src/cpp/types.ts").Failure | undefined} */ failure,
    ) => failure?.inputs.find((input) => input.name === "triangle")?.text ?? "";
    assert.ok(triangle(failed?.failure).length > 2 * triangle(failed?.look?.smaller).length);
    assert.notEqual(triangle(failed?.look?.smaller), "");
    assert.equal(failed?.look?.hint_number, 1);
  });

  // How else an answer may end: tests/browser/parity.test.mjs, beside the verdict of the program.
  test("a memory bomb leaves the page as it was", async () => {
    const code =
      "  std::vector<std::vector<double>> all;\n  while (true) all.emplace_back(1000000, 1.0);";
    allStopped(await checked(with_(code)), /^ran out of memory$/);
  });

  test("endless output is stopped and cut", async () => {
    const result = await checked(with_('  while (true) std::puts("again and again");'));
    allStopped(result, /^it printed without end and was stopped$/);
    assert.match(result.verdict?.output ?? "", /^again and again\n/);
    assert.ok((result.verdict?.output.length ?? 0) < 2.2e6);
  });

  test("a program that dies before its first test", async () => {
    const global = "static const int early = [] { std::abort(); return 1; }();\n";
    allStopped(await checked(with_("", global)), /^before the test began: aborted/);
  });

  test("what it prints is in the verdict", async () => {
    const { verdict } = await checked(with_('  std::puts("here");'));
    assert.equal(verdict?.verdict, "passed");
    assert.match(verdict?.output ?? "", /^(here\n)+$/);
  });

  test("what does not compile, or is not there, is no attempt", async () => {
    const { verdict } = await checked(with_("  int x = 1"));
    assert.equal(verdict?.verdict, "does_not_compile");
    assert.match(verdict.compile_error?.message ?? "", /expected ';'/);
    const missing = await checked('#include "ray_triangle.hpp"\n');
    assert.equal(missing.verdict?.verdict, "does_not_compile");
    assert.match(missing.verdict.compile_error?.message ?? "", /ray_triangle.*not defined/);
  });

  test("two exercises at once, each with its own verdict", async () => {
    const other = "01_planes/signed_distance";
    const wrong = solutionOf(other).replace(/return [^;]*;/, "return -1e9;");
    const [mine, theirs] = await Promise.all([
      checked(solutionOf(id), { name: "one" }),
      check(shown.page, other, wrong, { name: "two" }),
    ]);
    assert.equal(mine.verdict?.exercise, id);
    assert.equal(mine.verdict.verdict, "passed");
    assert.equal(theirs.verdict?.exercise, other);
    assert.equal(theirs.verdict.verdict, "failed");
  });

  /** Stops a check as soon as it reaches a step. @param {string} source @param {string} step */
  async function stoppedAt(source, step) {
    const result = checked(source, { name: "stopped" });
    await shown.page.waitForFunction(
      ([name, wanted]) => /** @type {any} */ (globalThis).reached?.[name] === wanted,
      /** @type {const} */ (["stopped", step]),
    );
    await shown.page.evaluate("aborts.stopped.abort()");
    return result;
  }

  test("a run that is stopped, and the next check", async () => {
    const { error } = await stoppedAt(with_("  while (true) std::fflush(stdout);"), "run");
    assert.match(error ?? "", /^AbortError/);
    const { verdict, told } = await checked(solutionOf(id));
    assert.equal(verdict?.verdict, "passed");
    assert.ok(told.every(({ step }) => step !== "start"));
  });

  test("a compile that does not end is stopped, and the compiler restarts without a download", async () => {
    // Twice as many kinds of it with each level.
    const endless =
      "template <int N, int K> struct Tree { static constexpr long long value = Tree<N - 1, 2 * K>::value + " +
      "Tree<N - 1, 2 * K + 1>::value; };\ntemplate <int K> struct Tree<0, K> { static constexpr long long value = K; };\n";
    const source = with_("  if (Tree<26, 1>::value == 3) return std::nullopt;", endless);
    const { error, milliseconds } = await stoppedAt(source, "compile");
    assert.match(error ?? "", /^AbortError/);
    assert.ok(milliseconds < 60_000);
    const { verdict, told } = await checked(solutionOf(id));
    assert.equal(verdict?.verdict, "passed");
    assert.ok(told.some(({ step }) => step === "start"));
    assert.ok(told.every(({ step }) => step !== "download"));
  });

  for (const script of ["program-worker.js", "run-worker.js"])
    test(`a page whose ${script} does not load gives no verdict, and says so`, async () => {
      const other = await open(browser.browser, `${server.origin}/index.html?${script}`);
      server.answer = (pathname, response) => {
        if (!pathname.endsWith(script)) return false;
        response.writeHead(503).end();
        return true;
      };
      try {
        await other.page.waitForFunction("document.body.dataset.ready");
        const { verdict, error } = await check(other.page, id, solutionOf(id));
        assert.equal(verdict, undefined);
        assert.match(error ?? "", /^CheckerError: A part of the page could not be loaded/);
      } finally {
        server.answer = undefined;
        await other.close();
      }
    });

  test("nothing went wrong in the page, and nothing was asked elsewhere", () => {
    assert.deepEqual(shown.trouble, []);
  });
});
