// Renders mathematics: one JSON request a line in, one JSON answer a line out.
// The argument is the folder whose node_modules holds KaTeX.
import { createRequire } from "node:module";
import { join } from "node:path";
import { createInterface } from "node:readline";

const katex = createRequire(join(process.argv[2], "package.json"))("katex");
// A second copy of the formula's TeX, which is not needed: screen readers read the MathML beside it.
const annotation = /<annotation encoding="application\/x-tex">[^<]*<\/annotation>/g;
const macros = {
  "\\norm": "\\lVert #1\\rVert",
  "\\abs": "\\lvert #1\\rvert",
};

for await (const line of createInterface({ input: process.stdin })) {
  const { tex, display } = JSON.parse(line);
  let answer;
  try {
    const options = { displayMode: display, throwOnError: true, strict: "error", trust: false };
    const made = katex.renderToString(tex, { ...options, macros: { ...macros } });
    answer = { html: made.replace(annotation, "").replace(/<\/?semantics>/g, "") };
  } catch (error) {
    answer = { error: error.message };
  }
  process.stdout.write(`${JSON.stringify(answer)}\n`);
}
