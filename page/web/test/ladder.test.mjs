// A ladder's picture: what it says of its measurements, as text.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";
import { parseHTML } from "linkedom";
import { draw, method, names, result, row } from "./ladder_sample.mjs";
import { load } from "./load.mjs";

const { cellOf, scatter } = await load("ladder-cell.ts");
const { partsOf } = await load("ladder-data.ts");
const { knownError } = await load("ladder-measure.ts");

test("a method a row, by time; a family a column", () => {
  const document = draw(result);
  assert.deepEqual(names(document), ["plain", "lucky", "slow", "sure", "unfiltered"]);
  const heads = [...document.querySelectorAll("th.family")].map((each) => each.textContent);
  // No method is wrong on the first: there the largest error is shown.
  assert.deepEqual(heads, ["randomerror", "aimed at <edges>% wrong"]);
  assert.match(document.querySelector("tbody td.ns").textContent, /^20 ns$/);
});

test("a cell is labelled and coloured by the share of wrong answers, or by the error", () => {
  const document = draw(result);
  const cells = (/** @type {string} */ id) =>
    [...document.querySelectorAll(`tr[data-method="${id}"] td[data-family]`)].map((cell) => [
      cell.textContent,
      cell.className,
    ]);
  assert.deepEqual(cells("plain"), [
    ["1e−7", "level-2"],
    ["32", "level-4"],
  ]);
  assert.deepEqual(cells("slow"), [
    ["1e−16", "level-0"],
    ["0.1", "level-1"],
  ]);
  assert.deepEqual(cells("sure"), [
    ["0", "level-0"],
    ["0", "level-0"],
  ]);
});

test("what only decides has no error, and what has overflowed the worst", () => {
  const results = result.results.map((each) => ({ ...each }));
  for (const each of results) {
    if (["sure", "slow"].includes(each.method)) each.error_max = each.error_median = null;
  }
  const document = draw({ ...result, results });
  const first = (/** @type {string} */ id) =>
    document.querySelector(`tr[data-method="${id}"] td[data-family]`);
  for (const [id, level] of [
    ["sure", "level-none"],
    ["slow", "level-5"],
  ]) {
    assert.equal(first(id).textContent, "–");
    assert.equal(first(id).className, level);
  }
});

test("the frontier is bold: no other method is both faster and at least as often right", () => {
  // `slow` loses to `lucky`, `unfiltered` to `sure`; that `sure` can never be wrong is worth its time.
  assert.deepEqual(names(draw(result), "tr.frontier"), ["plain", "lucky", "sure"]);
  const document = draw(result);
  assert.equal(document.querySelectorAll("tbody th strong").length, 3);
});

test("the book's choice is marked, with a sentence that the numbers prove", () => {
  const document = draw(result);
  assert.deepEqual(names(document, "tr.recommended"), ["sure"]);
  const said = () => draw(result).querySelector(".proven").textContent;
  assert.equal(
    said(),
    "★ sure (double, then exact): the fastest of the 2 methods that by design are never wrong, 5 × the time of the " +
      "fastest of all; “lucky (double)” is faster and was not wrong and had no larger error on these inputs, but is not so by design.",
  );
  // Other numbers, another sentence.
  const wrong = result.results.map((each) =>
    each.method === "lucky" && each.family === "edge" ? { ...each, wrong: 30 } : each,
  );
  const choose = (/** @type {string} */ id) =>
    result.methods.map((each) => ({ ...each, recommended: each.id === id }));
  const other = (/** @type {string} */ id, results = wrong) =>
    draw({ ...result, methods: choose(id), results }).querySelector(".proven").textContent;
  assert.match(
    other("lucky"),
    /lucky \(double\): wrong on 30 of 2,000 inputs, the fastest of the 4 methods that are wrong at most that often, 2.5 × the time of the fastest of all\.$/,
  );
  // A factor that rounds to 1 is no factor.
  const level = wrong.map((each) =>
    each.method === "lucky" ? { ...each, ns_median: 20.2 } : each,
  );
  assert.match(other("lucky", level), /, about the time of the fastest of all\b/);
  assert.match(
    other("plain"),
    /plain \(float\): wrong on 320 of 2,000 inputs, the fastest of all\.$/,
  );
  // Faster methods that are as good are no secret.
  assert.match(
    other("slow", result.results),
    /wrong on 1 of 2,000 inputs, 4 × the time of the fastest of all; “lucky \(double\)” is faster and was no more often wrong and had no larger error on these inputs\.$/,
  );
  // The fastest that is never wrong by design is not the choice here: no word of "the fastest of".
  assert.match(
    other("unfiltered", result.results),
    /unfiltered \(exact\): never wrong by design, 45 × the time of the fastest of all; 2 other methods are faster and were not wrong and had no larger error on these inputs\.$/,
  );
});

test("a ladder of two questions has a table and a sentence for each, and one legend", () => {
  const other = (each, ids) => ({ ...each, ...ids, part: "Does it hit twice?" });
  const two = {
    ...result,
    families: [
      ...result.families.map((each) => ({ ...each, part: result.question })),
      other(result.families[0], { id: "other" }),
    ],
    methods: [
      ...result.methods.map((each) => ({ ...each, part: result.question })),
      other(method("twice", "double", true, true), {}),
    ],
    results: [...result.results, row("other", "twice", 0, 5000)],
  };
  const document = draw(two);
  const captions = [...document.querySelectorAll("caption")].map((each) => each.textContent);
  assert.deepEqual(captions, ["Does the ray hit?", "Does it hit twice?"]);
  assert.equal(document.querySelectorAll(".proven").length, 2);
  assert.equal(document.querySelectorAll(".legend").length, 1);
  const [first, second] = document.querySelectorAll("table");
  assert.equal(first.outerHTML, draw(result).querySelector("table").outerHTML);
  assert.equal(second.querySelectorAll("tbody tr").length, 1);
  assert.equal(second.querySelectorAll("thead th.family").length, 1);
  const names = [...document.querySelectorAll("[role=region]")].map((each) =>
    each.getAttribute("aria-label"),
  );
  assert.equal(new Set(names).size, 2);
});

test("without a recommended method there is no sentence", () => {
  const methods = result.methods.map((each) => ({ ...each, recommended: false }));
  const document = draw({ ...result, methods });
  assert.equal(document.querySelectorAll(".proven, tr.recommended").length, 0);
});

test("a family that is about the error shows it although a method is wrong", () => {
  const families = result.families.map((each) => ({ ...each, by_error: true }));
  const results = result.results.map((each) => ({ ...each, error_max: 0.25 }));
  const cells = draw({ ...result, families, results }).querySelectorAll("td[data-family]");
  assert.deepEqual([...new Set([...cells].map((cell) => cell.textContent))], ["0.3"]);
});

test("methods that are never wrong by design are marked", () => {
  const document = draw(result);
  const marked = [...document.querySelectorAll("tbody tr")].filter((each) =>
    each.textContent.includes("never wrong by design"),
  );
  assert.deepEqual(
    marked.map((each) => each.getAttribute("data-method")),
    ["sure", "unfiltered"],
  );
});

test("where nothing is decided, the smaller error is the more often right", () => {
  const results = result.results.map((each) => ({
    ...each,
    wrong: 0,
    error_max: each.method === "lucky" ? 1e-16 : each.error_max,
  }));
  const document = draw({ ...result, results });
  const off = results.map((each) =>
    each.method === "sure" ? { ...each, error_max: 8.2e-17 } : each,
  );
  // A bound is rounded up.
  assert.match(
    draw({ ...result, results: off }).querySelector(".proven").textContent,
    /above 9e−17,/,
  );
  assert.match(
    document.querySelector(".proven").textContent,
    /: no error above 0, the fastest of the 2 methods that by design are never wrong, 5 × the time of the fastest of all\.$/,
  );
  assert.deepEqual(names(document, "tr.frontier"), ["plain", "lucky", "sure"]);
});

/** The sentence about the choice `sure`, with this change to the rows. @param {any} change */
const saidOf = (change, families = result.families) => {
  const results = result.results.map((each) => ({ ...each, ...change(each) }));
  return draw({ ...result, families, results }).querySelector(".proven").textContent;
};

test("a method that is never wrong but has a larger error is not as good as the choice", () => {
  const error = (/** @type {any} */ each) => ({
    error_max: each.method === "lucky" && each.family === "random" ? 3 : 0,
  });
  assert.match(saidOf(error), /5\s× the time of the fastest of all\.$/);
  // In another family, whose errors are smaller, it counts as well.
  const hidden = (/** @type {any} */ each) => ({
    error_max: each.family === "edge" ? 1 : each.method === "lucky" ? 0.1 : 0,
  });
  assert.match(saidOf(hidden), /5\s× the time of the fastest of all\.$/);
  // Without a number of the choice there is none to compare.
  const decided = (/** @type {any} */ each) => ({
    error_max: each.method === "sure" ? null : 3,
  });
  assert.match(
    saidOf(decided),
    /; “lucky \(double\)” is faster and was not wrong on these inputs,/,
  );
});

test("a method that leaves more undecided is not as good as the choice", () => {
  const undecided = (/** @type {any} */ each) => ({ undecided: each.method === "lucky" ? 1 : 0 });
  assert.match(saidOf(undecided), /5\s× the time of the fastest of all\.$/);
});

test("where all families are about the error, it judges although an answer has the wrong sign", () => {
  const families = result.families.map((each) => ({ ...each, by_error: true }));
  const errors = { plain: 3, lucky: 2e-3, slow: 1e-3, sure: 1e-3, unfiltered: 0 };
  const change = (/** @type {any} */ each) => ({ error_max: errors[each.method] });
  // `slow` is wrong once.
  assert.match(saidOf(change, families), /: no error above 1e−3, .*fastest of all\.$/);
  const right = (/** @type {any} */ each) => ({ ...change(each), wrong: 0 });
  assert.match(
    saidOf(right, families),
    /: no error above 1e−3, .*; “slow \(double\)” is faster and had no larger error on these inputs,/,
  );
  const frontier = names(
    draw({
      ...result,
      families,
      results: result.results.map((each) => ({ ...each, ...change(each) })),
    }),
    "tr.frontier",
  );
  assert.deepEqual(frontier, ["plain", "lucky", "slow", "sure", "unfiltered"]);
});

test("of the depths, a method that is metres off is not called as good as the choice", () => {
  const deep = measured()
    .flatMap((data) => partsOf(data))
    .find(({ question }) => question === "How deep?");
  const said = draw(deep).querySelector(".proven").textContent;
  assert.match(said, /no error above .*“faces and pairs of edges \(double\)” is faster/);
});

test("where nothing has an error and nothing is wrong, the sentence counts wrong answers", () => {
  const results = result.results.map((each) => ({ ...each, wrong: 0, error_max: null }));
  assert.match(
    draw({ ...result, results }).querySelector(".proven").textContent,
    /: the fastest of the 2 methods that by design are never wrong, 5\s× the time of the fastest of all/,
  );
});

/** The book's measurements. */
function measured() {
  const folder = fileURLToPath(new URL("../../../benchmarks/results/", import.meta.url));
  const ladders = fs.readdirSync(folder).filter((name) => /^\d\d_.*\.json$/.test(name));
  assert.ok(ladders.length >= 11);
  return ladders.map((name) => JSON.parse(fs.readFileSync(path.join(folder, name), "utf8")));
}

/** The labels of a time axis, each between two positions. @param {any} axis */
function axisLabels(axis) {
  return [...axis.querySelectorAll("text")].map((text) => {
    const half = text.textContent.length * 3;
    const x = Number(text.getAttribute("x"));
    return { words: text.textContent, from: x - half, to: x + half };
  });
}

/** The axis of each table. @param {any} document */
function checkAxis(document) {
  for (const axis of document.querySelectorAll(".axis")) checkOneAxis(axis);
}

/** @param {any} axis */
function checkOneAxis(axis) {
  const labels = axisLabels(axis);
  let free = 0;
  for (const { words, from, to } of labels) {
    assert.ok(from >= free && to <= 120, `${words} from ${from} to ${to}`);
    free = to;
  }
  // One number alone is no scale.
  assert.ok(labels.length >= 2, labels.map(({ words }) => words).join());
}

test("the time axis has two labels or more; none leaves it or overlaps another", () => {
  for (const factor of [1, 1e3, 1e-1, 3, 7])
    for (const spread of [0.03, 1, 5, 1e4]) {
      const results = result.results.map((each) => ({
        ...each,
        ns_median: each.ns_median * factor * (each.method === "unfiltered" ? spread : 1),
      }));
      checkAxis(draw({ ...result, results }));
    }
});

/** @param {any} mark its middle */
function middleOf(mark) {
  const of = (/** @type {string} */ name) => Number(mark.getAttribute(name));
  const name = mark.tagName.toLowerCase();
  if (name === "circle") return [of("cx"), of("cy")];
  if (name === "rect") return [of("x") + of("width") / 2, of("y") + of("height") / 2];
  const [x = 0, y = 0] = mark
    .getAttribute("d")
    .match(/[\d.]+/g)
    .map(Number);
  return [x, y + 5];
}

test("an error that a browser measures is null where the result files have none", () => {
  assert.deepEqual([0, 0.5, NaN, Infinity].map(knownError), [0, 0.5, null, null]);
});

test("the name in the plot of a cell covers no other method", () => {
  let plots = 0;
  for (const data of measured())
    for (const { method, family } of data.results) {
      const drawn = scatter(data, [], cellOf(data, [], method, family));
      const { document } = parseHTML(`<!doctype html><html><body>${drawn}</body></html>`);
      const name = document.querySelector("text.name");
      const [x, y] = ["x", "y"].map((at) => Number(name.getAttribute(at)));
      const half = name.textContent.length * 3;
      for (const mark of document.querySelectorAll("g[data-method] > *")) {
        const [p, q] = middleOf(mark);
        const covers = Math.abs(p - x) < half + 3 && q > y - 12 && q < y + 6;
        assert.ok(!covers, `${data.ladder}: ${method}, ${family}`);
      }
      plots += 1;
    }
  assert.ok(plots > 500);
});

test("every measured ladder has a time axis with two labels or more", () => {
  for (const data of measured()) checkAxis(draw(data));
});

test("the line between the quartiles lies under no dot", () => {
  const bars = [...draw(result).querySelectorAll(".bar")];
  assert.equal(bars.length, 5);
  for (const bar of bars) {
    const line = Number(bar.querySelector(".quartiles").getAttribute("y1"));
    for (const dot of bar.querySelectorAll(".families circle"))
      assert.ok(Number(dot.getAttribute("cy")) - Number(dot.getAttribute("r")) > line + 4);
  }
});

test("no line of a heading ends between a number and its unit, or beside a sign", () => {
  const families = result.families.map((each, i) => ({
    ...each,
    title: ["needles, moments 1 : 100", "k = 1 for 5 to 15 s"][i],
  }));
  const heads = draw({ ...result, families }).querySelectorAll("th.family .title");
  assert.deepEqual(
    [...heads].map((each) => each.textContent.replaceAll("\u00a0", "_")),
    ["needles, moments 1_:_100", "k_=_1 for 5 to 15_s"],
  );
});
