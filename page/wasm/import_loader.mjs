// The page's loader in Node, which does not read TypeScript: esbuild takes the types away.
import { readFile } from "node:fs/promises";
import { transform } from "esbuild";

/** @returns {Promise<typeof import('./loader.js')>} */
export async function importLoader() {
  const source = await readFile(new URL("loader.ts", import.meta.url), "utf8");
  const { code } = await transform(source, { loader: "ts", target: "es2022", format: "esm" });
  return import(`data:text/javascript;base64,${Buffer.from(code).toString("base64")}`);
}
