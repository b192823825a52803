// What a run tests of what is too much for every run: another part of it with each commit, so that a few commits have
// tested all. With CONTACT_ALL=1 it is everything.

import { execFileSync } from "node:child_process";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const all = Boolean(process.env["CONTACT_ALL"]);
const commit = Number.parseInt(
  execFileSync("git", ["-C", here, "rev-parse", "HEAD"]).toString().slice(0, 8),
  16,
);

/** Every `each`-th of a list. @template T @param {readonly T[]} list @param {number} each @returns {T[]} */
export const sample = (list, each) => list.filter((_, i) => all || (i + commit) % each === 0);

/** One of a list. @template T @param {readonly T[]} list @returns {T[]} */
export const one = (list) => sample(list, list.length);
