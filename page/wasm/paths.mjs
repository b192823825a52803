// Where things are. Everything else asks here, so that a move is one edit.
import path from "node:path";
import { fileURLToPath } from "node:url";

/** The root of the repository. */
export const root = fileURLToPath(new URL("../../", import.meta.url)).replace(/[/\\]$/, "");

/** @param {string[]} parts */
export const inRoot = (...parts) => path.join(root, ...parts);

/** What the compiler made before, by content; safe to delete. */
export const cacheDir = inRoot("build", "wasm-cache");

/** Eigen's headers, as the machine has them. */
export const eigenDir = path.resolve(
  root,
  process.env["EIGEN3_INCLUDE_DIR"] ?? "/usr/include/eigen3",
);

/** A path to show to a person: relative to the root when it is inside. @param {string} file */
export function shown(file) {
  const relative = path.relative(root, file);
  return relative.startsWith("..") ? file : relative;
}
