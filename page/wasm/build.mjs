// node page/wasm/build.mjs figures|ladders|toolchain|all... [--only NAME]... [--drop-outdated] [--out build/web]
//   [--workers N] [--quiet]
//
// Compiles what the page runs. What has not changed is taken from build/wasm-cache. `--drop-outdated`: of the figures and
// ladders that `--only` leaves out, those in the cache are there too, and old ones are removed. Exit code 0: all there;
// 1: something does not compile (the rest is built all the same); 2: wrong usage.
import fs from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import { engineProducts } from "./engines.mjs";
import { inRoot, root, shown } from "./paths.mjs";
import { playerProducts } from "./player.mjs";
import { makeAll } from "./pool.mjs";
import { exerciseList, figures, isAskedFor, ladders } from "./products.mjs";
import { isMade, key, made, prune, writeWhole } from "./recipes.mjs";
import { ship, toolchainRecipes } from "./toolchain.mjs";

/** @typedef {import('./products.mjs').Product} Product */
/** @typedef {import('./recipes.mjs').Recipe} Recipe */

/**
 * What becomes one file each: the longest of all comes first, so that no process waits for it at the end.
 * @type {Record<string, () => Product[]>}
 */
const kinds = {
  figures: () => [...playerProducts(), ...engineProducts(), ...figures()],
  ladders,
  toolchain: () => [],
};
const usage =
  "usage: node page/wasm/build.mjs figures|ladders|toolchain|all... [--only NAME]... [--drop-outdated] " +
  "[--out FOLDER] [--workers N] [--quiet]";

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
  const { kinds: asked, only, dropOutdated, out, workers, quiet } = given;
  const one = asked.length === 1 && asked[0] !== "all" ? asked[0] : undefined;
  const start = performance.now();
  /** @type {Product[]} */
  const all = Object.entries(kinds).flatMap(([name, list]) =>
    asked.includes("all") || asked.includes(name) ? list() : [],
  );
  const products = all.filter(
    ({ name, recipe }) => isAskedFor(name, only) || (dropOutdated && isMade(key(recipe))),
  );
  if (dropOutdated)
    for (const product of all)
      if (!products.includes(product)) fs.rmSync(path.join(out, product.output), { force: true });
  const withToolchain = asked.includes("toolchain") || (asked.includes("all") && only.length === 0);
  const exercises = withToolchain ? exerciseList() : [];
  const names = [...all, ...exercises].map(({ name }) => name);
  const unknown = only.find((one) => !names.some((name) => isAskedFor(name, [one])));
  if (unknown !== undefined) {
    const each = { figures: "figure", ladders: "ladder", toolchain: "exercise" };
    const what = each[/** @type {keyof typeof each} */ (one)] ?? "product";
    console.error(`There is no ${what} ${unknown}. There are:`);
    for (const name of names) console.error(`  ${name}`);
    return 2;
  }

  const { built, failed } = await makeAll(
    [...products.map(({ recipe }) => recipe), ...(withToolchain ? toolchainRecipes(only) : [])],
    {
      workers,
      onDone: ({ recipe, ok, log, seconds }, left) => {
        if (quiet && ok) return;
        const verb = {
          compile: "compiled",
          precompile: "compiled",
          archive: "packed",
          link: "linked",
          seal: "sealed",
          shrink: "made smaller",
        };
        console.error(
          `${ok ? verb[recipe.tool] : "FAILED  "} ${recipe.what}  ${seconds.toFixed(1)} s, ${left} left`,
        );
        if (ok && log) console.error(log.trimEnd());
      },
    },
  );

  /** @type {Set<string>} */
  const told = new Set();
  const isThere = (/** @type {Recipe} */ recipe) => {
    // Of what was not asked for, what is there already is shipped as well.
    if (only.length > 0 && withToolchain && !failed.has(key(recipe))) return isMade(key(recipe));
    const why = failed.get(key(recipe));
    if (why !== undefined && !told.has(why)) console.error(`\n${why}`);
    if (why !== undefined) told.add(why);
    return why === undefined;
  };
  let written = 0;
  const say = (
    /** @type {string} */ file,
    /** @type {number} */ bytes,
    /** @type {number} */ sent,
  ) => {
    ++written;
    if (!quiet) console.log(`${shown(file)}  ${bytes} bytes, ${sent} compressed`);
  };
  for (const { output, recipe } of products) {
    if (!isThere(recipe)) continue;
    const target = path.join(out, output);
    const bytes = made(key(recipe));
    // A file that is right already keeps its date, so that what depends on it rests.
    if (!fs.existsSync(target) || !fs.readFileSync(target).equals(bytes)) writeWhole(target, bytes);
    say(target, bytes.length, quiet ? 0 : gzipSync(bytes, { level: 9 }).length);
  }
  let wanted = products.length;
  if (withToolchain) {
    const { files, exercises } = await ship(out, isThere);
    const shipped = [...Object.values(files), ...Object.values(exercises)];
    for (const { file, bytes, transfer } of shipped)
      say(path.join(out, "cpp", file), bytes, transfer);
    wanted += shipped.length;
  }
  writeNotices(out);
  prune(14);
  const seconds = ((performance.now() - start) / 1000).toFixed(1);
  console.log(
    `${written} of ${wanted} ${one === undefined || one === "toolchain" ? "products" : one} in ${seconds} s ` +
      `(${built} steps made, the rest from the cache)`,
  );
  return failed.size === 0 ? 0 : 1;
}

/** The licences of what is linked into every module, in one file beside them. @param {string} out */
function writeNotices(out) {
  const here = inRoot("page", "wasm");
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
      only: { type: "string", multiple: true, default: [] },
      out: { type: "string", default: path.join("build", "web") },
      workers: { type: "string", default: "2" },
      quiet: { type: "boolean", default: false },
      "drop-outdated": { type: "boolean", default: false },
    },
  });
  if (positionals.length === 0) throw new Error("what shall be built?");
  for (const kind of positionals)
    if (!Object.hasOwn(kinds, kind) && kind !== "all") throw new Error(`${kind}: not known`);
  const workers = Number(values.workers);
  if (!Number.isInteger(workers) || workers < 1) throw new Error("--workers takes a number from 1");
  return {
    kinds: positionals,
    only: /** @type {string[]} */ (values.only),
    dropOutdated: values["drop-outdated"] === true,
    out: path.resolve(root, /** @type {string} */ (values.out)),
    workers,
    quiet: values.quiet === true,
  };
}

process.exitCode = await main(process.argv.slice(2));
