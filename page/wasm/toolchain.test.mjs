// What the page downloads is enough to compile, link and run an exercise, and nothing else is asked for.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { exerciseEntry } from "./book.mjs";
import { check } from "./check.mjs";
import { PageCompiler } from "./page_compiler.mjs";
import { inRoot } from "./paths.mjs";
import { makeAll } from "./pool.mjs";
import { key } from "./recipes.mjs";
import { ship, toolchainRecipes } from "./toolchain.mjs";

const chapter = "02_triangles";
const exercise = `${chapter}/ray_triangle`;
const contract = fs.readFileSync(inRoot("exercises", exercise, "ray_triangle.hpp"), "utf8");
const solution = fs.readFileSync(inRoot("solutions", exercise, "ray_triangle.cpp"), "utf8");
const tests = exerciseEntry(exercise).tests.map(({ name }) => name);

const out = fs.mkdtempSync(path.join(os.tmpdir(), "contact-toolchain-"));
after(() => fs.rmSync(out, { recursive: true, force: true }));
/** @type {PageCompiler} */
let compiler;

before(async () => {
  const recipes = toolchainRecipes([chapter]);
  const { failed } = await makeAll(recipes);
  assert.deepEqual([...failed.values()], []);
  const asked = new Set(recipes.map((recipe) => key(recipe)));
  await ship(out, (recipe) => asked.has(key(recipe)));
  compiler = await new PageCompiler(path.join(out, "cpp")).load();
});

test("every file has the size that the manifest gives, and none is left over", () => {
  const { files, core, behind, exercises } = compiler.manifest;
  const shipped = [...Object.values(files), ...Object.values(exercises)];
  for (const { file, transfer } of shipped) {
    assert.match(file, /\.[0-9a-f]{8}\./);
    assert.equal(fs.statSync(path.join(out, "cpp", file)).size, transfer, file);
  }
  const found = fs
    .readdirSync(path.join(out, "cpp"), { recursive: true })
    .map(String)
    .filter((file) => fs.statSync(path.join(out, "cpp", file)).isFile());
  assert.deepEqual(
    found.map((file) => file.split(path.sep).join("/")).sort(),
    ["manifest.json", ...shipped.map(({ file }) => file)].sort(),
  );
  assert.deepEqual([...core, ...behind].sort(), Object.keys(files).sort());
  const written = fs.readdirSync(inRoot("exercises", chapter)).map((name) => `${chapter}/${name}`);
  assert.deepEqual(Object.keys(exercises).sort(), written.sort());
});

test("a first check needs at most 30 MB", () => {
  const { files, core } = compiler.manifest;
  const bytes = core.reduce((sum, name) => sum + (files[name]?.transfer ?? Infinity), 0);
  assert.ok(bytes <= 30e6, `${bytes} bytes`);
});

for (const prelude of [true, false]) {
  test(`the solution passes ${prelude ? "with" : "without"} the precompiled header`, async () => {
    const built = await compiler.build(exercise, contract, solution, { prelude });
    assert.ok(built.ok, built.log);
    assert.equal(built.log, "");
    const verdicts = await check(built.program, tests);
    assert.deepEqual(
      verdicts.map(({ test, status }) => [test, status]),
      tests.map((test) => [test, "passed"]),
    );
  });
}
