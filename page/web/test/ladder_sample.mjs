// A small ladder, and its picture as ladder_picture.mjs prints it.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseHTML } from "linkedom";

const program = fileURLToPath(new URL("../ladder_picture.mjs", import.meta.url));
export const row = (family, method, wrong, ns, error = 0) => ({
  family,
  method,
  n: 1000,
  wrong,
  undecided: 0,
  error_median: 0,
  error_max: error,
  ns_median: ns,
  ns_q1: ns * 0.9,
  ns_q3: ns * 1.1,
  repeats: 5,
});
export const method = (id, scalar, exact, recommended = false) => ({
  id,
  title: id,
  scalar,
  exact,
  recommended,
});
export const result = {
  ladder: "02_triangles",
  question: "Does the ray hit?",
  families: [
    { id: "random", title: "random", n: 1000 },
    { id: "edge", title: "aimed at <edges>", n: 1000 },
  ],
  methods: [
    method("unfiltered", "exact", true),
    method("sure", "double, then exact", true, true),
    method("plain", "float", false),
    method("slow", "double", false),
    method("lucky", "double", false),
  ],
  results: [
    row("random", "plain", 0, 20, 1e-7),
    row("random", "slow", 0, 80, 1e-16),
    row("random", "lucky", 0, 50, 0),
    row("random", "sure", 0, 100, 0),
    row("random", "unfiltered", 0, 900, 0),
    row("edge", "plain", 320, 20),
    row("edge", "slow", 1, 80),
    row("edge", "lucky", 0, 50),
    row("edge", "sure", 0, 100),
    row("edge", "unfiltered", 0, 900),
  ],
};

/** @param {object} data */
export function draw(data) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "contact-ladder-"));
  const file = path.join(folder, "result.json");
  fs.writeFileSync(file, JSON.stringify(data));
  const done = spawnSync(process.execPath, [program, file], { encoding: "utf8" });
  fs.rmSync(folder, { recursive: true });
  assert.equal(done.status, 0, done.stderr);
  assert.doesNotMatch(done.stdout, /NaN|undefined|Infinity/);
  return parseHTML(`<!doctype html><html><body>${done.stdout}</body></html>`).document;
}

export const names = (/** @type {any} */ document, selector = "tbody tr") =>
  [...document.querySelectorAll(selector)].map((each) => each.getAttribute("data-method"));
