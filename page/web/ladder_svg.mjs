// node page/web/ladder_svg.mjs RESULT.json [OUT.svg]
//
// Draws a ladder's measurements with the page's own plotting code; without OUT.svg it is printed.

import fs from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { build } from "esbuild";
import { parseHTML } from "linkedom";

const [from, to] = process.argv.slice(2);
if (!from) {
  console.error("usage: node page/web/ladder_svg.mjs RESULT.json [OUT.svg]");
  process.exit(2);
}

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.dirname(path.dirname(here));
// A name of its own for each run, so that two at once do not read half a file.
const code = path.join(root, "build", "web-node", `ladder-plot-${process.pid}.mjs`);
try {
  await build({
    entryPoints: [path.join(here, "src", "ladder-plot.ts")],
    outfile: code,
    bundle: true,
    format: "esm",
    platform: "node",
    target: "node18",
    logLevel: "warning",
  });
  const { ladderPlot } = await import(pathToFileURL(code).href);
  const { document } = parseHTML("<!doctype html><html><body></body></html>");
  const svg = ladderPlot(JSON.parse(fs.readFileSync(from, "utf8")), document).toString();
  if (to) fs.writeFileSync(to, `${svg}\n`);
  else process.stdout.write(`${svg}\n`);
} finally {
  fs.rmSync(code, { force: true });
}
