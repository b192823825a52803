// What a ladder shows of a peer, after a run in the browser.

import assert from "node:assert/strict";
import test from "node:test";
import { parseHTML } from "linkedom";
import { draw, method, names, result, row } from "./ladder_sample.mjs";
import { load } from "./load.mjs";

const { cellOf, failureOf, scatter, summary } = await load("ladder-cell.ts");
const { withPeers } = await load("ladder-data.ts");
const { ladderPicture } = await load("ladder-picture.ts");

/** As the module names it. */
const peer = {
  ...method("three", "JavaScript", false),
  title: "three.js 1.2",
  peer: true,
  part: "",
};
const peerRows = [row("random", "three", 3, 60), row("edge", "three", 250, 90)];

/** The picture after a run in the browser. @param {any[]} here */
function drawHere(here) {
  const shown = withPeers(result, [peer], here);
  const html = ladderPicture(shown, { here, pressable: true });
  assert.doesNotMatch(html, /NaN|undefined|Infinity/);
  return parseHTML(`<!doctype html><html><body>${html}</body></html>`).document;
}

test("after a run a peer is the last row, without a time of the book's", () => {
  const document = drawHere([...result.results, ...peerRows]);
  assert.deepEqual(names(document), ["plain", "lucky", "slow", "sure", "unfiltered", "three"]);
  const line = document.querySelector("tr.peer");
  assert.equal(line.querySelector("th").textContent, "three.js 1.2 JavaScript");
  assert.equal(line.querySelectorAll("rect.own").length, 1);
  assert.equal(line.querySelectorAll("rect.book").length, 0);
  // The geometric mean of its two families.
  assert.equal(line.querySelector("td.ns").textContent, "73 ns");
  const legend = (/** @type {any} */ of) => of.querySelector(".legend").textContent;
  assert.match(
    legend(document),
    /only here, on 1,000 inputs a family, because the book's own numbers/,
  );
  const fewer = [peerRows[0], { ...peerRows[1], n: 16, wrong: 4 }];
  assert.match(legend(drawHere(fewer)), /on 16 to 1,000 inputs a family/);
  assert.doesNotMatch(legend(drawHere(result.results)), /JavaScript/);
});

test("what must be known of a peer's times is said once, only if it has a row", () => {
  const told = { ...peer, note: "its trees are built before" };
  const legend = (/** @type {any[]} */ peers, /** @type {any[]} */ here) =>
    ladderPicture(withPeers(result, peers, here), { here, pressable: true });
  const twice = [told, { ...told, id: "four" }];
  const rows = [...peerRows, ...peerRows.map((each) => ({ ...each, method: "four" }))];
  assert.equal(legend(twice, rows).split("; its trees are built before").length, 2);
  assert.doesNotMatch(legend(twice, result.results), /its trees/);
  assert.doesNotMatch(legend([peer], peerRows), /; its trees/);
});

test("a peer that is wrong makes its column count wrong answers", () => {
  const heads = (/** @type {any[]} */ here) =>
    [...drawHere(here).querySelectorAll("th.family small")].map((each) => each.textContent);
  assert.deepEqual(heads(peerRows), ["% wrong", "% wrong"]);
  assert.deepEqual(heads([{ ...peerRows[0], wrong: 0 }, peerRows[1]]), ["error", "% wrong"]);
  const cells = [...drawHere(peerRows).querySelectorAll("tr.peer td[data-family]")];
  assert.deepEqual(
    cells.map((cell) => cell.textContent),
    ["0.3", "25"],
  );
});

test("a peer changes neither the book's sentence nor the book's frontier", () => {
  const fastest = peerRows.map((each) => ({ ...each, wrong: 0, ns_median: 1 }));
  const document = drawHere(fastest);
  assert.equal(
    document.querySelector(".proven").textContent,
    draw(result).querySelector(".proven").textContent,
  );
  assert.deepEqual(names(document, "tr.frontier"), ["plain", "lucky", "sure"]);
});

test("a run that was stopped before a peer has no row for it", () => {
  assert.equal(drawHere(result.results).querySelectorAll("tr.peer").length, 0);
});

test("a peer's cell tells what was measured here, and that its inputs are not kept", () => {
  const shown = withPeers(result, [peer], peerRows);
  const cell = cellOf(shown, peerRows, "three", "edge");
  assert.equal(
    summary(cell).replaceAll("\u00a0", " "),
    "In this browser: 250 of 1,000 answers wrong; 90 ns (quartiles 81 ns to 99 ns).",
  );
  assert.match(failureOf(cell), /are not kept/);
  const { document } = parseHTML(
    `<!doctype html><html><body>${scatter(shown, peerRows, cell)}</body></html>`,
  );
  const marks = [...document.querySelectorAll('g[data-method="three"] > *')];
  assert.deepEqual(
    marks.map((mark) => mark.getAttribute("class")),
    ["own chosen"],
  );
  assert.equal(document.querySelector("text.name").textContent, "three.js 1.2");
});
