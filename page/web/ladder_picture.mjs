// node page/web/ladder_picture.mjs RESULT.json [OUT.html]
//
// A ladder's measurements as the page shows them, made by the page's own code; without OUT.html they
// are printed.

import fs from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { build } from "esbuild";

const [from, to] = process.argv.slice(2);
if (!from) {
  console.error("usage: node page/web/ladder_picture.mjs RESULT.json [OUT.html]");
  process.exit(2);
}

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.dirname(path.dirname(here));
// A name of its own for each run, so that two at once do not read half a file.
const code = path.join(root, "build", "web-node", `ladder-picture-${process.pid}.mjs`);
try {
  await build({
    entryPoints: [path.join(here, "src", "ladder-picture.ts")],
    outfile: code,
    bundle: true,
    format: "esm",
    platform: "node",
    target: "node18",
    logLevel: "warning",
  });
  const { ladderPicture } = await import(pathToFileURL(code).href);
  const html = ladderPicture(JSON.parse(fs.readFileSync(from, "utf8")));
  if (to) fs.writeFileSync(to, `${html}\n`);
  else process.stdout.write(`${html}\n`);
} finally {
  fs.rmSync(code, { force: true });
}
