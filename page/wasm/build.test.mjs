// The build: what is cached, what is rebuilt, and the messages when C++ does not compile.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { promisify } from "node:util";
import { mended, runTool } from "./compiler.mjs";
import { moduleLink, pageFlags, testFlags } from "./flags.mjs";
import { forgetSources } from "./headers.mjs";
import { nativeWords } from "./native_compiler.mjs";
import { inRoot } from "./paths.mjs";
import { makeAll } from "./pool.mjs";
import { exceptionRuntime, figureRecipe } from "./products.mjs";
import { Changed, isMade, key, made, make } from "./recipes.mjs";

const run = promisify(execFile);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "contact-wasm-"));
after(() => fs.rmSync(folder, { recursive: true, force: true }));

/** A small source of its own, so that nothing of an earlier run is in the cache. */
const mark = `${process.pid}_${Date.now()}`;
const source = path.join(folder, "small.cpp");
const header = path.join(folder, "answer.hpp");
fs.writeFileSync(header, "#pragma once\n");
const unrelated = path.join(folder, "unrelated.hpp");

/** @param {string} body @returns {import("./recipes.mjs").Compile} */
function small(body) {
  fs.writeFileSync(source, `#include "answer.hpp"\n${body}\n`);
  forgetSources();
  return {
    tool: "compile",
    what: "small.cpp",
    language: "c++",
    flags: pageFlags,
    folders: [folder],
    source,
  };
}

test("what has not changed is not made again, and a header's change is noticed", async () => {
  fs.writeFileSync(header, `#pragma once\ninline int answer_${mark}() { return 42; }\n`);
  fs.writeFileSync(unrelated, "#pragma once\n");
  const recipe = small(`int twice() { return 2 * answer_${mark}(); }`);
  assert.equal((await makeAll([recipe])).built, 1);
  const first = key(recipe);
  assert.deepEqual([...made(first).subarray(0, 4)], [0, 0x61, 0x73, 0x6d]);

  assert.equal((await makeAll([recipe])).built, 0);
  fs.writeFileSync(unrelated, "#pragma once\nint other();\n");
  forgetSources();
  assert.equal(key(recipe), first);

  fs.writeFileSync(header, `#pragma once\ninline int answer_${mark}() { return 43; }\n`);
  forgetSources();
  assert.notEqual(key(recipe), first);
  assert.equal(isMade(key(recipe)), false);
  assert.equal((await makeAll([recipe])).built, 1);
  assert.notDeepEqual(made(key(recipe)), made(first));
});

test("other flags make another product", () => {
  const recipe = small("int f() { return 1; }");
  assert.notEqual(key(recipe), key({ ...recipe, flags: [...recipe.flags, "-DOTHER"] }));
});

test("a source that a header takes in counts unless the flags say that it is compiled", () => {
  const taken = path.join(folder, "taken.cpp");
  fs.writeFileSync(taken, "int taken();\n");
  fs.writeFileSync(
    header,
    '#pragma once\n#ifdef OTHER\n#endif\n#ifndef CONTACT_SCENES_COMPILED\n#include "taken.cpp"\n#endif\n',
  );
  const alone = small("int f() { return 1; }");
  const linked = { ...alone, flags: [...alone.flags, "-DCONTACT_SCENES_COMPILED"] };
  const other = { ...alone, flags: [...alone.flags, "-DCONTACT_RAYS_COMPILED"] };
  const before = [alone, linked, other].map(key);
  fs.writeFileSync(taken, "int taken(int);\n");
  forgetSources();
  const changed = [alone, linked, other].map((recipe, k) => key(recipe) !== before[k]);
  assert.deepEqual(changed, [true, false, true]);
  fs.writeFileSync(header, "#pragma once\n");
});

test("a source that is saved while it is compiled gives no product under its old key", async () => {
  const recipe = small(`int before_${mark}() { return 1; }`);
  const old = key(recipe);
  small(`int after_${mark}() { return 1; }`);
  await assert.rejects(make(recipe, old, []), Changed);
  assert.equal(isMade(old), false);
});

test("by the native compiler a module is, to the byte, the same as by the page's compiler", async () => {
  const folders = ["01_planes", "00_vectors"].map((slug) => inRoot("chapters", slug));
  const figure = figureRecipe(inRoot("page", "wasm", "fixtures", "stops.cpp"), folders).part;
  assert.ok(figure.tool === "link");
  // With assertions of three libraries, which name files.
  const asserting = {
    ...small(`#include <contact/vector.hpp>\n#include <nlohmann/json.hpp>\n#include <vector>\n
double at(const std::vector<contact::Vector3<double>>& list, int i, const char* text) {
  return list[static_cast<std::size_t>(i)](i) + nlohmann::json::parse(text)["x"].get<double>();
}`),
    flags: testFlags,
    folders: [inRoot("chapters", "00_vectors")],
  };
  const program = {
    ...figure,
    before: [...moduleLink.before, "--export-all"],
    parts: [asserting, exceptionRuntime],
  };
  for (const recipe of [figure, program]) {
    const by = (/** @type {boolean} */ inPage) => ({
      ...recipe,
      parts: recipe.parts.map((one) => {
        if (one.tool !== "compile") return one;
        const { pch: _, ...alone } = one;
        return { ...alone, inPage, flags: [...one.flags, `-DMARK_${mark}`] };
      }),
    });
    const [native, inPage] = [by(false), by(true)];
    assert.notEqual(key(native), key(inPage));
    const { failed } = await makeAll([native, inPage]);
    assert.deepEqual([...failed.values()], []);
    assert.deepEqual(made(key(native)), made(key(inPage)));
  }
});

test("a file that the key does not know is not read", async () => {
  fs.writeFileSync(path.join(folder, "hidden.hpp"), "#pragma once\n");
  const recipe = { ...small('#define HIDDEN "hidden.hpp"\n#include HIDDEN'), folders: [folder] };
  const { failed } = await makeAll([recipe]);
  assert.match(failed.get(key(recipe)) ?? "", /reads a file that .*\n.*hidden\.hpp/);
});

test("what is saved halfway while it is compiled is no error of the source", async () => {
  const recipe = small(`int before_${mark}() { return 2; }`);
  const old = key(recipe);
  small("int half(");
  await assert.rejects(make(recipe, old, []), Changed);
});

test("both compilers are of one major version", async () => {
  const { log } = await runTool(["clang++", "--version"], {}, "clang");
  const major = /clang version (\d+)\./;
  assert.equal((await nativeWords(["--version"])).match(major)?.[1], log.match(major)?.[1]);
});

test("a C++ error is reported in the compiler's words, and the rest is built", async () => {
  fs.writeFileSync(header, "#pragma once\n");
  const wrong = small(`int wrong_${mark}() { return undeclared; }`);
  const right = figureRecipe(inRoot("page", "wasm", "fixtures", "stops.cpp"), [
    inRoot("chapters", "01_planes"),
    inRoot("chapters", "00_vectors"),
  ]);
  const { failed } = await makeAll([wrong, right]);
  const why = failed.get(key(wrong)) ?? "";
  assert.match(why, /small\.cpp:2:\d+: error: use of undeclared identifier 'undeclared'/);
  assert.equal(failed.has(key(right)), false);
});

test("what needs a thing that failed fails with the same words", async () => {
  fs.writeFileSync(header, `#pragma once\n#error "no ${mark}"\n`);
  small("");
  const recipe = figureRecipe(source, [folder]);
  const { failed } = await makeAll([recipe]);
  assert.match(failed.get(key(recipe)) ?? "", new RegExp(`no ${mark}`));
});

test("the program's own words: an unknown name lists what there is; wrong usage is exit code 2", async () => {
  const program = inRoot("page", "wasm", "build.mjs");
  /** @param {string[]} args @returns {Promise<{ code: number, stderr: string }>} */
  const fails = (...args) =>
    run(process.execPath, [program, ...args]).then(
      () => assert.fail("it succeeded"),
      (error) => error,
    );
  const unknown = await fails("figures", "--only", "99_nothing/here");
  assert.equal(unknown.code, 2);
  assert.match(unknown.stderr, /There is no figure 99_nothing\/here.*01_planes\//s);
  const exercise = await fails("toolchain", "--only", "99_nothing");
  assert.equal(exercise.code, 2);
  assert.match(exercise.stderr, /There is no exercise 99_nothing.*02_triangles\/ray_triangle/s);
  assert.equal((await fails("houses")).code, 2);
  assert.equal((await fails("figures", "houses")).code, 2);
  assert.equal((await fails()).code, 2);
  assert.equal((await fails("figures", "--workers", "none")).code, 2);
});

test("a compiler other than the one that we corrected is refused", () => {
  assert.throws(() => mended("something else"), /no longer fits/);
});

test("the scene player has the source of each header that its sources include", () => {
  const chapter = inRoot("chapters", "20_scenes");
  const read = (/** @type {string} */ file) => fs.readFileSync(file, "utf8");
  const parts = ["quick.cpp", "small.cpp"].map((part) => read(inRoot("page", "player", part)));
  const taken = [...parts.join("").matchAll(/#include <(src\/\w+\.cpp)>/g)].map(
    (one) => `${one[1]}`,
  );
  const seen = new Set(taken.map((name) => path.join(chapter, name)));
  const needed = new Set();
  for (const file of seen) {
    const code = read(file);
    for (const [, source] of code.matchAll(/#include "[./]*(src\/\w+\.cpp)"/g)) needed.add(source);
    for (const [, name] of code.matchAll(/#include [<"](contact\/\w+\/\w+\.hpp)[>"]/g)) {
      const header = path.join(chapter, `${name}`);
      if (fs.existsSync(header)) seen.add(header);
    }
  }
  assert.ok(needed.size > 20);
  needed.delete("src/scene_writer.cpp"); // the page writes no scenes
  assert.deepEqual(
    [...needed].filter((source) => !taken.includes(source)),
    [],
  );
});
