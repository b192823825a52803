// Bundles one of the page's sources for Node and imports it, so that tests run what the page runs.

import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { build } from "esbuild";

const here = path.dirname(fileURLToPath(import.meta.url));
const page = path.resolve(here, "..", "..");

/** @param {string} name below page/web/src */
export async function load(name) {
  const outfile = path.resolve(
    page,
    "..",
    "build",
    "web-node",
    "test",
    `${name}.${process.pid}.mjs`,
  );
  await build({
    entryPoints: [path.join(page, "web", "src", name)],
    outfile,
    bundle: true,
    format: "esm",
    platform: "node",
    target: "node18",
    mainFields: ["module", "main"],
    alias: { three: path.join(page, "node_modules", "three", "src", "Three.Core.js") },
    // Engines come with their WebAssembly.
    loader: { ".wasm": "binary" },
    logLevel: "warning",
  });
  return import(pathToFileURL(outfile).href);
}
