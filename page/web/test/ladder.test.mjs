import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

const program = fileURLToPath(new URL("../ladder_svg.mjs", import.meta.url));
const row = (family, method, wrong, ns) => ({
  family,
  method,
  n: 1000,
  wrong,
  undecided: 0,
  error_median: 0,
  error_max: 1e-9,
  ns_median: ns,
  ns_q1: ns * 0.9,
  ns_q3: ns * 1.1,
  repeats: 5,
});
const result = {
  ladder: "02_triangles",
  question: "Does the ray hit?",
  families: [
    { id: "random", title: "random", n: 1000 },
    { id: "edge", title: "aimed at <edges>", n: 1000 },
  ],
  methods: [
    { id: "plain", title: "plain", scalar: "float", exact: false },
    { id: "sure", title: "sure", scalar: "exact", exact: true },
  ],
  results: [
    row("random", "plain", 0, 20),
    row("random", "sure", 0, 900),
    row("edge", "plain", 320, 21),
    row("edge", "sure", 0, 950),
  ],
};

/** @param {object} data */
function draw(data) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "contact-ladder-"));
  const file = path.join(folder, "result.json");
  fs.writeFileSync(file, JSON.stringify(data));
  const done = spawnSync(process.execPath, [program, file], { encoding: "utf8" });
  fs.rmSync(folder, { recursive: true });
  assert.equal(done.status, 0, done.stderr);
  return done.stdout;
}

test("a ladder is drawn with a band a family and a name a method", () => {
  const svg = draw(result);
  assert.match(svg, /^<svg/);
  assert.equal(svg.match(/>plain</g)?.length, 2);
  assert.equal(svg.match(/>sure</g)?.length, 2);
  assert.match(svg, /aimed at &lt;edges&gt; \(1,000 inputs\)/);
  assert.match(svg, /wrong answers/);
  assert.doesNotMatch(svg, /NaN|undefined/);
});

test("without a wrong answer the error is what is plotted", () => {
  const results = result.results.map((each) => ({ ...each, wrong: 0 }));
  assert.match(draw({ ...result, results }), /largest error/);
});
