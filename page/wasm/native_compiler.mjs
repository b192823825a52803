// Clang as a native program, for all C++ that is compiled before a reader comes: more than twice as quick as the same
// major version as WebAssembly (compiler.mjs), which compiles what a reader types. Headers and libraries are the same.
import { execFile } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { CompileError, compilerVersion, resourceTree } from "./compiler.mjs";
import { assertionsFolder, systemRoot } from "./flags.mjs";
import { systemPackages } from "./headers.mjs";
import { cacheDir, eigenDir, inRoot, root } from "./paths.mjs";

/** @typedef {import('./compiler.mjs').Tree} Tree */

const packageName = "ziglang";

/** @type {{ program: string, version: string } | undefined} */
let found;

/** The program and its version: of the Python package, as ./contact setup installs it. */
function native() {
  if (found) return found;
  const lib = inRoot("build", "venv-page", "lib");
  for (const python of fs.existsSync(lib) ? fs.readdirSync(lib) : []) {
    const packages = path.join(lib, python, "site-packages");
    if (!fs.existsSync(path.join(packages, packageName))) continue;
    const info = fs.readdirSync(packages).find((name) => /^ziglang-.*\.dist-info$/.test(name));
    if (!info) throw new Error(`${packageName} in ${packages} is not whole: run ./contact setup`);
    const version = info.slice(`${packageName}-`.length, -".dist-info".length);
    found = { program: path.join(packages, packageName, "zig"), version };
    return found;
  }
  throw new Error(`${packageName} is not in build/venv-page: run ./contact setup`);
}

/** @returns {string} */
export const nativeVersion = () => `${packageName} ${native().version}`;

/** The compiler's headers and libraries as files, written once. @returns {Promise<string>} their folder */
async function resources() {
  const folder = path.join(cacheDir, "native", `usr-${compilerVersion()}`);
  if (fs.existsSync(folder)) return folder;
  const part = `${folder}.${process.pid}.part`;
  const write = (/** @type {string} */ file, /** @type {Tree | string | Uint8Array} */ content) => {
    if (typeof content === "string" || content instanceof Uint8Array) {
      fs.writeFileSync(file, content);
      return;
    }
    fs.mkdirSync(file, { recursive: true });
    for (const [name, inside] of Object.entries(content)) write(path.join(file, name), inside);
  };
  write(part, await resourceTree());
  renamed(part, folder);
  return folder;
}

/** The packages of the machine that a source may include, and no others: a folder of links. */
function packages() {
  const folder = path.join(cacheDir, "native", systemRoot);
  fs.mkdirSync(folder, { recursive: true });
  for (const { start, dir } of systemPackages) {
    const link = path.join(folder, start.replace(/\/$/, ""));
    if (dir !== eigenDir && !fs.existsSync(link)) renamed(linked(dir, start, link), link);
  }
  return folder;
}

/** @param {string} dir @param {string} start @param {string} link */
function linked(dir, start, link) {
  const part = `${link}.${process.pid}.part`;
  fs.rmSync(part, { force: true });
  fs.symlinkSync(path.join(dir, start), part);
  return part;
}

/** Another process may have been first. @param {string} part @param {string} target */
function renamed(part, target) {
  try {
    fs.renameSync(part, target);
  } catch (error) {
    if (!fs.existsSync(target)) throw error;
    fs.rmSync(part, { recursive: true, force: true });
  }
}

/** A file as the program is told it: it runs in the root, so an object names the same files in every clone.
 * @param {string} file */
export function fromRoot(file) {
  const inside = path.relative(root, file);
  return inside.startsWith("..") ? file : inside;
}

/** Programs that are running, to be ended with this process. @type {Set<import("node:child_process").ChildProcess>} */
const running = new Set();
process.on("exit", () => {
  for (const child of running) child.kill("SIGKILL");
});

/**
 * Runs the compiler in the root of the repository.
 * @param {string[]} flags as flags.mjs has them, with the names that compiler.mjs knows libraries by
 * @param {string[]} rest other arguments; files by fromRoot()
 * @param {string} what for the message when it fails
 * @returns {Promise<{ log: string, read: string[] }>} what it said, and the files that it read but for its own
 */
export async function runNative(flags, rest, what) {
  const usr = await resources();
  const system = packages();
  /** @type {[string, string][]} */
  const places = [
    [usr, "/usr"],
    [eigenDir, `/${systemRoot}/eigen3`],
    [system, `/${systemRoot}`],
    [assertionsFolder, `/${assertionsFolder}`],
  ];
  const real = (/** @type {string} */ flag) => {
    const place = places.find(([, name]) => flag === name || flag.startsWith(`${name}/`));
    return place ? place[0] + flag.slice(place[1].length) : flag;
  };
  const list = path.join(cacheDir, "native", `read.${process.pid}.${++runs}`);
  const all = [
    ...flags.slice(1).map(real),
    // Whoever reads a message or an object finds the names that the page's compiler gives.
    ...(flags[1] === "-cc1" ? places.map(([from, to]) => `-fmacro-prefix-map=${from}=${to}`) : []),
    // The assembler reads one file.
    ...(flags[1] === "-cc1" ? ["-dependency-file", list, "-MT", "it", "-sys-header-deps"] : []),
    ...rest,
  ];
  try {
    const log = await nativeWords(all, what);
    const read = fs.existsSync(list) ? names(fs.readFileSync(list, "utf8")) : [];
    const kept = path.join(cacheDir, path.sep);
    return {
      log,
      read: read.map((file) => fs.realpathSync(file)).filter((file) => !file.startsWith(kept)),
    };
  } finally {
    fs.rmSync(list, { force: true });
  }
}
let runs = 0;

/** The files of a rule for make. @param {string} rule */
const names = (rule) =>
  (rule.replace(/^it:/, "").match(/(?:\\[ #]|[^\s\\])+/g) ?? []).map((name) =>
    path.resolve(root, name.replace(/\\([ #])/g, "$1").replaceAll("$$", "$")),
  );

/** What the program says. @param {string[]} args @param {string} [what] @returns {Promise<string>} */
export function nativeWords(args, what = "clang") {
  return new Promise((resolve, reject) => {
    const options = { cwd: root, maxBuffer: 1 << 26 };
    const child = execFile(
      native().program,
      ["clang", ...args],
      options,
      (error, stdout, stderr) => {
        running.delete(child);
        if (!error) resolve(stdout + stderr);
        else if (typeof error.code === "number")
          reject(new CompileError(`${what} does not compile`, stdout + stderr));
        else reject(new CompileError(`${what}: the compiler stopped: ${error.message}`, stderr));
      },
    );
    running.add(child);
  });
}
