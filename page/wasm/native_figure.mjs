// A figure's C++ as a native program, to compare with its WebAssembly.
import { spawnSync } from "node:child_process";
import path from "node:path";
import { inRoot } from "./paths.mjs";

const build = inRoot("build", "dev");
const elsewhere = process.env["CONTACT_PROGRAMS"];
/** @type {Set<string>} */
const built = new Set();

/**
 * The program of a figure, built from the current source. Only tests run these, and not all of them, so each is built
 * when it is first requested; one build at a time.
 * @param {string} name "01_planes/segment_plane" @returns {string} its path
 */
export function nativeFigure(name) {
  const target = `figure_${name.replace("/", "_")}`;
  if (elsewhere) return path.join(elsewhere, target);
  const program = path.join(build, "bin", target);
  if (built.has(target)) return program;
  const command = ["cmake", "--build", build, "--target", target];
  const lock = ["flock", inRoot("build", "lock")];
  const canLock = spawnSync("flock", ["--version"]).status === 0;
  const [first = "", ...rest] = canLock ? [...lock, ...command] : command;
  const { status, stdout, stderr } = spawnSync(first, rest, { encoding: "utf8" });
  if (status !== 0) throw new Error(`${target} does not build:\n${stdout}${stderr}`);
  built.add(target);
  return program;
}
