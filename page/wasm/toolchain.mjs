// The downloads that the page needs to compile an exercise: the compiler, its headers and libraries, the prelude's
// precompiled header, the objects linked with tests, and each exercise's tests; and cpp/manifest.json, which gives the
// address and use of each. The names of all other files contain a hash of their content, so a browser can cache them
// forever.
import { createHash } from "node:crypto";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { promisify } from "node:util";
import { gzip } from "node:zlib";
import { coreModule, coreNames, mendedProgram, resourceTree } from "./compiler.mjs";
import { diagnosticFlags, programLink, studentFlags } from "./flags.mjs";
import { closure, sourceFile, virtualPath } from "./headers.mjs";
import { judgeRecipe } from "./judge.mjs";
import { cacheDir, inRoot } from "./paths.mjs";
import {
  checkPrelude,
  checksObject,
  exerciseList,
  isAskedFor,
  studentFolders,
  testObject,
} from "./products.mjs";
import { assertionHandler, key, made, put, writeWhole } from "./recipes.mjs";
import { tar } from "./tar.mjs";

/** @typedef {import('./recipes.mjs').Recipe} Recipe */
/** @typedef {import('./compiler.mjs').Tree} Tree */
/** @typedef {{ file: string, bytes: number, transfer: number }} Shipped */
/** @typedef {{ format: 'contact-cpp/1', files: Record<string, Shipped>, core: string[], behind: string[],
 *   compile: { flags: string[], withPrelude: string[], include: string[], diagnostics: string[] },
 *   link: { before: string[], after: string[] }, exercises: Record<string, Shipped> }} Manifest */

/** Everything that must be made before `ship` can be called.
 * @param {readonly string[]} [only] of the exercises: these, or those of these chapters. @returns {Recipe[]} */
export const toolchainRecipes = (only = []) => [
  checkPrelude,
  checksObject(),
  judgeRecipe(),
  ...exerciseList()
    .filter(({ name }) => isAskedFor(name, only))
    .map((exercise) => testObject(exercise)),
];

/** The C headers that come with the compiler itself, without those for other machines. */
const ownHeaders =
  /^(std.*|__std.*|__float.*|float|limits|tgmath|inttypes|iso646|unwind|varargs|builtins)\.h$/;

/** Folders and files of the standard library that no C++20 program here reads. */
const unread =
  /^(__cxx03|experimental|ext|__pstl|module\.modulemap|libcxx\.imp|__cuda|CMakeLists\.txt)$/;

const libraries = {
  "wasm32-wasip1": ["crt1-command.o", "libc.a", "libc++.a", "libc++abi.a"],
  "wasm32-unknown-wasip1": ["libclang_rt.builtins.a"],
};

/** @param {Tree} tree @param {string} name @returns {Tree} */
const branch = (tree, name) => /** @type {Tree} */ (tree[name]);

/** The smallest set of files with which every student's file compiles and links as with all of them.
 * @returns {Promise<Tree>} */
export async function systemTree() {
  const all = await resourceTree();
  const include = branch(all, "include");
  const standard = branch(branch(include, "c++"), "v1");
  /** @type {Tree} */
  const kept = {
    "c++": { v1: pick(standard, (name) => !unread.test(name)) },
    "wasm32-wasip1": /** @type {Tree} */ (include["wasm32-wasip1"]),
    ...pick(include, (name) => ownHeaders.test(name)),
  };
  const lib = Object.fromEntries(
    Object.entries(libraries).map(([folder, names]) => [
      folder,
      pick(branch(branch(all, "lib"), folder), (name) => names.includes(name)),
    ]),
  );
  /** @type {Tree} */
  const tree = { usr: { include: kept, lib } };
  for (const { virtual, bytes } of ownFiles()) put(tree, virtual, new Uint8Array(bytes));
  return tree;
}

/** @param {Tree} tree @param {(name: string) => boolean} wanted @returns {Tree} */
const pick = (tree, wanted) =>
  Object.fromEntries(Object.entries(tree).filter(([name]) => wanted(name)));

/** Eigen without the parts for processors that it is told not to use, the prelude and the shared shapes. */
function ownFiles() {
  const shapes = inRoot("chapters", "00_vectors", "contact");
  const starts = [
    checkPrelude.source,
    inRoot("page", "wasm", "student_may_include.hpp"),
    ...fs
      .readdirSync(shapes)
      .filter((name) => name.endsWith(".hpp"))
      .map((name) => path.join(shapes, name)),
  ];
  const files = new Map(
    starts.flatMap((start) => closure(start, studentFolders).map((file) => [file.virtual, file])),
  );
  files.delete(virtualPath(/** @type {string} */ (starts[1])));
  const handler = sourceFile(assertionHandler);
  files.set(handler.virtual, handler);
  return [...files.values()].filter(({ virtual }) => !/\/arch\/(?!Default\/)/.test(virtual));
}

/** The compiler's program, small, with the notice that its licences ask for. */
async function compilerProgram() {
  const { build } = createRequire(inRoot("page", "package.json"))("esbuild");
  const { outputFiles } = await build({
    stdin: { contents: mendedProgram(), loader: "js" },
    bundle: true,
    minify: true,
    write: false,
    format: "esm",
    target: "es2022",
    external: ["node:*"],
    banner: { js: "/* clang, LLD and their JavaScript: licences in ../wasm-notices.txt */" },
    logLevel: "silent",
  });
  return new Uint8Array(outputFiles[0].contents);
}

/** @param {Uint8Array} bytes */
const hash = (bytes) => createHash("sha256").update(bytes).digest("hex");

const packed = promisify(gzip);

/** Compressed as far as it goes, which takes ten seconds for the compiler: so kept by content.
 * @param {Uint8Array} bytes @returns {Promise<Uint8Array>} */
async function zipped(bytes) {
  const name = hash(bytes);
  const file = path.join(cacheDir, "made", "gz", name);
  if (fs.existsSync(file)) {
    const now = new Date();
    fs.utimesSync(file, now, now);
    return fs.readFileSync(file);
  }
  const result = await packed(bytes, { level: 9 });
  writeWhole(file, result);
  return result;
}

/**
 * Writes build/web/cpp. Whatever is not made is left out of the manifest.
 * @param {string} out build/web @param {(recipe: Recipe) => boolean} isMade
 * @returns {Promise<Manifest>}
 */
export async function ship(out, isMade) {
  const folder = path.join(out, "cpp");
  /** @type {Set<string>} */
  const named = new Set(["manifest.json"]);
  /** @param {string} name with its ending @param {Uint8Array} bytes @param {boolean} zip @returns {Promise<Shipped>} */
  const put = async (name, bytes, zip = true) => {
    const sent = zip ? await zipped(bytes) : bytes;
    const { dir, name: stem, ext } = path.posix.parse(name);
    const tag = `${hash(sent).slice(0, 8)}${ext}${zip ? ".gz" : ""}`;
    const file = path.posix.join(dir, `${stem}.${tag}`);
    named.add(file);
    const target = path.join(folder, file);
    if (!fs.existsSync(target)) writeWhole(target, sent);
    return { file, bytes: bytes.length, transfer: sent.length };
  };
  /** What is made of these, at the same time: to compress takes longest. @param {[string, Recipe][]} list */
  const putMade = (list) =>
    Promise.all(
      list
        .filter(([, recipe]) => isMade(recipe))
        .map(async ([name, recipe]) => ({ name, shipped: await put(name, made(key(recipe))) })),
    );

  const parts = [
    put("compiler.js", await compilerProgram(), false),
    ...coreNames.map((name) => put(name, coreModule(name))),
    put("system.tar", tar(await systemTree())),
  ];
  const own = putMade([
    ["checks.o", checksObject()],
    ["judge.wasm", judgeRecipe()],
    ["prelude.pch", checkPrelude],
  ]);
  const names = ["compiler.js", ...coreNames, "system.tar"];
  /** @type {Manifest['files']} */
  const files = {};
  for (const [i, shipped] of (await Promise.all(parts)).entries())
    files[String(names[i])] = shipped;
  for (const { name, shipped } of await own) files[name] = shipped;
  const core = Object.keys(files).filter((name) => name !== "prelude.pch");
  const tests = await putMade(
    exerciseList().map((exercise) => [`exercises/${exercise.name}.o`, testObject(exercise)]),
  );
  /** @type {Manifest['exercises']} */
  const exercises = {};
  for (const { name, shipped } of tests) exercises[name.slice("exercises/".length, -2)] = shipped;

  /** @type {Manifest} */
  const manifest = {
    format: "contact-cpp/1",
    files,
    core,
    behind: ["prelude.pch"].filter((name) => name in files),
    compile: {
      flags: studentFlags,
      withPrelude: ["-include-pch", "prelude.pch"],
      include: studentFolders.flatMap((dir) => ["-I", `/${virtualPath(dir)}`]),
      diagnostics: diagnosticFlags,
    },
    link: programLink,
    exercises,
  };
  const text = `${JSON.stringify(manifest, null, 1)}\n`;
  const target = path.join(folder, "manifest.json");
  if (!fs.existsSync(target) || fs.readFileSync(target, "utf8") !== text) writeWhole(target, text);
  sweep(folder, named);
  return manifest;
}

/** Removes what the manifest no longer names. @param {string} folder @param {Set<string>} named */
function sweep(folder, named) {
  const files = fs.readdirSync(folder, { recursive: true, withFileTypes: true });
  for (const entry of files) {
    const file = path.join(entry.parentPath ?? entry.path, entry.name);
    const inside = path.relative(folder, file).split(path.sep).join("/");
    if (entry.isFile() && !named.has(inside)) fs.rmSync(file);
  }
}
