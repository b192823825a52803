// The judge: the grading library of `contact check`, as one small module for the page.
import path from "node:path";
import { moduleLink, quiet, studentFlags } from "./flags.mjs";
import { inRoot } from "./paths.mjs";
import { exceptionRuntime } from "./products.mjs";

/** @typedef {import('./recipes.mjs').Compile} Compile */

/** Small before quick: a verdict takes it a few milliseconds either way. */
const flags = [
  ...studentFlags.filter((flag) => flag !== "-O1" && !/HARDENING/.test(flag)),
  "-Oz",
  "-DNDEBUG",
  // The two libraries without streams, which would bring the whole of <locale>: 50 kB of what is sent.
  "-DJSON_NO_IO",
  "-DTOML_ENABLE_FORMATTERS=0",
  "-DTOML_FLOAT_CHARCONV=1",
  ...quiet,
];

/** What of grading/ the page needs: no file is written there, no process started. */
const sources = [
  "book/book.cpp",
  "text/near_names.cpp",
  "progress/again.cpp",
  "progress/progress_record.cpp",
  "progress/progress_report.cpp",
  "verdict/verdict.cpp",
  "diagnosis/claims.cpp",
  "diagnosis/compiler_messages.cpp",
  "diagnosis/contract_text.cpp",
  "diagnosis/diagnosis.cpp",
  "diagnosis/exercise_contract.cpp",
  "diagnosis/explained.cpp",
  "diagnosis/message_text.cpp",
  "diagnosis/sieve.cpp",
  "diagnosis/source_structure.cpp",
  "diagnosis/source_text.cpp",
  ...[
    "definitions",
    "eigen",
    "link",
    "members",
    "missing",
    "names",
    "rules",
    "signs",
    "types",
    "warnings",
  ].map((kind) => `diagnosis/mistakes/${kind}.cpp`),
];

/** @type {import('./recipes.mjs').Precompile} */
const prelude = {
  tool: "precompile",
  what: "what the judge's sources share",
  flags,
  folders: [],
  source: inRoot("page", "judge", "judge_prelude.hpp"),
};

/** @returns {import('./recipes.mjs').Link} */
export const judgeRecipe = () => ({
  tool: "link",
  what: "the judge",
  before: [...moduleLink.before, "--compress-relocations"],
  after: moduleLink.after,
  parts: [
    ...[
      ...sources.map((file) => inRoot("grading", file)),
      inRoot("page", "judge", "judge.cpp"),
    ].map((source) => {
      const what = path.relative(inRoot(), source);
      return /** @type {Compile} */ ({
        tool: "compile",
        what,
        language: "c++",
        flags,
        folders: [],
        source,
        pch: prelude,
      });
    }),
    exceptionRuntime,
  ],
});
