// What a run tests of what is too much for every run: it goes by turns, as tools/sample.py says, which also says what
// it takes from the environment.

import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const file = fileURLToPath(new URL("../../tools/turn", import.meta.url));

/** @param {string} text @param {string} where */
function readTurn(text, where) {
  if (!/^\s*\d+\s*$/.test(text))
    throw new Error(`${where} must hold one whole number, and holds ${JSON.stringify(text)}`);
  return Number(text);
}

const given = process.env["CONTACT_TURN"];
const turn =
  given === undefined
    ? readTurn(fs.readFileSync(file, "utf8"), file)
    : readTurn(given, "CONTACT_TURN");

/** The chapters whose checks alone are run; none: all of them. */
export const chapters = (process.env["CONTACT_CHAPTERS"] ?? "").split(",").filter(Boolean);

/** @param {readonly string[]} names @param {string} item */
const touches = (names, item) => names.some((name) => name === "*" || item.includes(name));

/** Whether something with this name is looked at: it belongs to one of `chapters`, if there are any. @param {string} name */
export const wanted = (name) => chapters.length === 0 || touches(chapters, name);

/** Declares a test of what all chapters share: none where some of them alone are checked. */
export const ofAll = chapters.length > 0 ? () => {} : test;

/** Kinds of which the chapters that are asked for say nothing. */
const ofNoChapter = ["hostile", "explain", "authors", "tidy"];

/** @param {string} what @param {string[]} ran @param {string[]} left */
function record(what, ran, left) {
  const slices = process.env["CONTACT_SLICES"];
  if (slices && ran.length + left.length > 0)
    fs.appendFileSync(slices, `${JSON.stringify({ what, ran, left })}\n`);
}

/**
 * Every `each`-th of a list, and what the change touches.
 * @template T @param {readonly T[]} list @param {number} each
 * @param {string} what its name in the table at the end of a run; "" keeps it out of the table
 * @param {{ kind?: string, within?: number, name?: (item: T) => string }} [options]
 *   `kind`: what CONTACT_TOUCHED calls them; `within`: how seldom the list itself is taken
 * @returns {T[]}
 */
export function sample(list, each, what, { kind, within = 1, name = String } = {}) {
  let of = list;
  let every = process.env["CONTACT_ALL"] !== undefined;
  /** @type {string[]} */
  let touched = [];
  if (kind !== undefined) {
    touched = JSON.parse(process.env["CONTACT_TOUCHED"] || "{}")[kind] ?? [];
    if (chapters.length > 0 && !ofNoChapter.includes(kind)) {
      of = list.filter((item) => wanted(name(item)));
      every = true;
    }
  }
  const taken = of.map(
    (item, i) =>
      every || (i + Math.floor(turn / within)) % each === 0 || touches(touched, name(item)),
  );
  if (what) {
    const names = of.map(name);
    record(
      what,
      names.filter((_, i) => taken[i]),
      names.filter((_, i) => !taken[i]),
    );
  }
  return of.filter((_, i) => taken[i]);
}

const book = fileURLToPath(new URL("../../chapters", import.meta.url));

/** The chapters with a figure or a ladder, in order. A run compiles those of a third of them for the page. */
export const withParts = fs
  .readdirSync(book)
  .sort()
  .filter((slug) => {
    const folder = path.join(book, slug);
    const figures = path.join(folder, "figures");
    const hasFigure =
      fs.existsSync(figures) && fs.readdirSync(figures).some((name) => name.endsWith(".cpp"));
    return hasFigure || fs.existsSync(path.join(folder, "ladder.cpp"));
  });

/**
 * Of these chapters, those whose figures (or ladders, or pages) this run tests; tools/page_parts.py builds what they show.
 * @param {"figures" | "ladder" | "page"} kind
 * @param {string} what as for `sample`
 */
export const chaptersTaken = (kind, what = "") => sample(withParts, 3, what, { kind });
