// node docs/wasm/build.mjs figures|ladders|exercises|all [--only NAME] [--out build/web] [--workers N] [--json]
//
// Compiles what the page runs. What has not changed is taken from build/wasm-cache. Exit code 0: all there;
// 1: something does not compile (the rest is built all the same); 2: wrong usage.
import fs from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import { inRoot, root, shown } from "./paths.mjs";
import { makeAll } from "./pool.mjs";
import { exercises, figures, ladders } from "./products.mjs";
import { key, made, prune, writeWhole } from "./recipes.mjs";

/** @typedef {import('./products.mjs').Product} Product */

const kinds = { figures, ladders, exercises };
const usage =
  "usage: node docs/wasm/build.mjs figures|ladders|exercises|all [--only NAME] [--out FOLDER] " +
  "[--workers N] [--quiet]";

/** @param {string[]} args @returns {Promise<number>} the exit code */
async function main(args) {
  /** @type {ReturnType<typeof read>} */
  let given;
  try {
    given = read(args);
  } catch (error) {
    console.error(`${/** @type {Error} */ (error).message}\n${usage}`);
    return 2;
  }
  const { kind, only, out, workers, quiet } = given;
  const start = performance.now();
  /** @type {Product[]} */
  const all = kind === "all" ? Object.values(kinds).flatMap((list) => list()) : kinds[kind]();
  const products = only
    ? all.filter(({ name }) => name === only || name.startsWith(`${only}/`))
    : all;
  if (only && products.length === 0) {
    console.error(
      `There is no ${kind === "all" ? "product" : kind.slice(0, -1)} ${only}. There are:`,
    );
    for (const { name } of all) console.error(`  ${name}`);
    return 2;
  }

  const { built, failed } = await makeAll(
    products.map(({ recipe }) => recipe),
    {
      workers,
      onDone: ({ recipe, ok, log, seconds }, left) => {
        if (quiet && ok) return;
        const verb = {
          compile: "compiled",
          precompile: "compiled",
          archive: "packed",
          link: "linked",
        };
        console.error(
          `${ok ? verb[recipe.tool] : "FAILED  "} ${recipe.what}  ${seconds.toFixed(1)} s, ${left} left`,
        );
        if (ok && log) console.error(log.trimEnd());
      },
    },
  );

  let written = 0;
  /** @type {Set<string>} */
  const told = new Set();
  for (const { output, recipe } of products) {
    const name = key(recipe);
    const why = failed.get(name);
    if (why !== undefined) {
      if (!told.has(why)) console.error(`\n${why}`);
      told.add(why);
      continue;
    }
    const target = path.join(out, output);
    const bytes = made(name);
    // A file that is right already keeps its date, so that what depends on it rests.
    if (!fs.existsSync(target) || !fs.readFileSync(target).equals(bytes)) writeWhole(target, bytes);
    ++written;
    if (!quiet) {
      const zipped = gzipSync(bytes, { level: 9 }).length;
      console.log(`${shown(target)}  ${bytes.length} bytes, ${zipped} compressed`);
    }
  }
  writeNotices(out);
  prune(14);
  const seconds = ((performance.now() - start) / 1000).toFixed(1);
  console.log(
    `${written} of ${products.length} ${kind === "all" ? "products" : kind} in ${seconds} s ` +
      `(${built} steps made, the rest from the cache)`,
  );
  return written === products.length ? 0 : 1;
}

/** The licences of what is linked into every module, in one file beside them. @param {string} out */
function writeNotices(out) {
  const here = inRoot("docs", "wasm");
  const texts = fs.readdirSync(path.join(here, "licences")).sort();
  const all = ["NOTICES.md", ...texts.map((name) => path.join("licences", name))].map((name) =>
    [name, "", fs.readFileSync(path.join(here, name), "utf8").trim(), ""].join("\n"),
  );
  const target = path.join(out, "wasm-notices.txt");
  const text = all.join(`\n${"-".repeat(78)}\n\n`);
  if (!fs.existsSync(target) || fs.readFileSync(target, "utf8") !== text) writeWhole(target, text);
}

/** @param {string[]} args */
function read(args) {
  const { positionals, values } = parseArgs({
    args,
    allowPositionals: true,
    options: {
      only: { type: "string" },
      out: { type: "string", default: path.join("build", "web") },
      workers: { type: "string", default: "2" },
      quiet: { type: "boolean", default: false },
    },
  });
  const [kind, ...rest] = positionals;
  if (kind === undefined || rest.length > 0 || !(kind in kinds || kind === "all"))
    throw new Error(
      kind === undefined ? "what shall be built?" : `${positionals.join(" ")}: not known`,
    );
  const workers = Number(values.workers);
  if (!Number.isInteger(workers) || workers < 1) throw new Error("--workers takes a number from 1");
  return {
    kind: /** @type {keyof typeof kinds | 'all'} */ (kind),
    only: values.only,
    out: path.resolve(root, /** @type {string} */ (values.out)),
    workers,
    quiet: values.quiet === true,
  };
}

process.exitCode = await main(process.argv.slice(2));
