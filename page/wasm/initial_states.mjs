// What each figure shows first, from its TypeScript, which Node does not read: esbuild bundles it.
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { build } from "esbuild";
import { inRoot } from "./paths.mjs";

const modules = inRoot("page", "node_modules");

/** @param {string[]} names "01_planes/segment_plane" @returns {Promise<Map<string, Record<string, number | number[]>>>} */
export async function initialStates(names) {
  const outdir = fs.mkdtempSync(path.join(os.tmpdir(), "contact-figures-"));
  try {
    await build({
      entryPoints: names.map((name) => {
        const [chapter = "", figure = ""] = name.split("/");
        return { in: inRoot("chapters", chapter, "figures", `${figure}.ts`), out: name };
      }),
      outdir,
      outExtension: { ".js": ".mjs" },
      bundle: true,
      splitting: true,
      format: "esm",
      platform: "node",
      target: "node18",
      alias: {
        "@contact": inRoot("page", "web", "src"),
        three: path.join(modules, "three", "src", "Three.Core.js"),
      },
      nodePaths: [modules],
      logLevel: "warning",
    });
    const states = new Map();
    for (const name of names) {
      const { default: figure } = await import(
        pathToFileURL(path.join(outdir, `${name}.mjs`)).href
      );
      states.set(name, figure.initial);
    }
    return states;
  } finally {
    fs.rmSync(outdir, { recursive: true });
  }
}
