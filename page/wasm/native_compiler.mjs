// Clang as a native program, for all C++ that is compiled before a reader comes: three times as quick as the same
// version as WebAssembly (compiler.mjs), which compiles what a reader types. The headers and the libraries are the same.
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
  const lib = inRoot("build", "venv", "lib");
  for (const python of fs.existsSync(lib) ? fs.readdirSync(lib) : []) {
    const packages = path.join(lib, python, "site-packages");
    if (!fs.existsSync(path.join(packages, packageName))) continue;
    const info = fs.readdirSync(packages).find((name) => /^ziglang-.*\.dist-info$/.test(name));
    const version = info?.slice(`${packageName}-`.length, -".dist-info".length) ?? "";
    found = { program: path.join(packages, packageName, "zig"), version };
    return found;
  }
  throw new Error(`${packageName} is not in build/venv: run ./contact setup`);
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

/**
 * Runs the compiler in the root of the repository.
 * @param {string[]} args flags as flags.mjs has them, which name libraries where compiler.mjs has them; files by fromRoot()
 * @param {string} what for the message when it fails
 * @returns {Promise<string>} what it said
 */
export async function runNative(args, what) {
  const usr = await resources();
  const system = packages();
  const real = (/** @type {string} */ arg) => {
    if (arg.startsWith("/usr")) return usr + arg.slice("/usr".length);
    if (arg === `/${systemRoot}/eigen3`) return eigenDir;
    if (arg === `/${systemRoot}`) return system;
    return arg === `/${assertionsFolder}` ? assertionsFolder : arg;
  };
  return new Promise((resolve, reject) => {
    const options = { cwd: root, maxBuffer: 1 << 26 };
    const all = ["clang", ...args.slice(1).map(real)];
    execFile(native().program, all, options, (error, stdout, stderr) => {
      if (!error) resolve(stdout + stderr);
      else if (typeof error.code === "number")
        reject(new CompileError(`${what} does not compile`, stdout + stderr));
      else reject(new CompileError(`${what}: the compiler stopped: ${error.message}`, stderr));
    });
  });
}
