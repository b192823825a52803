// Finds the words of tools/words.yml with prh. A JSON document on standard input, one on standard output:
// [{ name, text }, ...] gives { terms, found: [{ index, offset, end, found, term, expected }, ...] }; index says in which text.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(new URL("../page/package.json", import.meta.url));
const { fromYAML } = require("prh");

const file = new URL("words.yml", import.meta.url);
const list = readFileSync(file, "utf8");
/** What stands under a heading of the list, as names and texts: `  name: text`. */
const under = (heading) => {
  const block = list.match(new RegExp(`^${heading}:\\n((?:  .*\\n)+)`, "m"))?.[1] ?? "";
  return new Map([...block.matchAll(/^ {2}(\w+): (.*)$/gm)].map(([, name, text]) => [name, text]));
};
const sets = under("sets");
const kinds = under("kinds");

const expand = (text) =>
  text.replace(/\{([a-z]+)\}/g, (_, name) => {
    if (!sets.has(name)) throw new Error(`words.yml: there is no set {${name}}`);
    return sets.get(name);
  });
const start = list.indexOf("\nrules:\n");
const { rules } = fromYAML(file.pathname, expand(expand(list.slice(start))));
const checked = rules.map((rule) => {
  const { term, files } = rule.raw;
  if (!term) throw new Error(`words.yml: a rule without a term writes ${rule.expected}`);
  if (files && !kinds.has(files)) throw new Error(`words.yml: there is no kind of files ${files}`);
  return { rule, term, files: files ? new RegExp(kinds.get(files)) : /^/ };
});

const found = [];
const texts = JSON.parse(readFileSync(0, "utf8"));
let last;
let holding = [];
for (const [index, { name, text }] of texts.entries()) {
  if (name !== last) holding = checked.filter(({ files }) => files.test(name));
  last = name;
  const lower = text.toLowerCase();
  const here = []; // what is found in this text; rules of one term may find the same use
  for (const { rule, term } of holding)
    for (const { index: offset, matches } of rule.applyRule(lower)) {
      const end = offset + matches[0].length;
      if (here.some((use) => use.term === term && use.offset < end && offset < use.end)) continue;
      const expected = rule.expected;
      here.push({ index, offset, end, found: text.slice(offset, end), term, expected });
    }
  found.push(...here);
}
process.stdout.write(
  JSON.stringify({ terms: [...new Set(checked.map(({ term }) => term))], found }),
);
