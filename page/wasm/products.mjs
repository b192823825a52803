// What there is to build, found from the folders of the repository, and the recipe of each.
import fs from "node:fs";
import path from "node:path";
import { book, chapterEntry } from "./book.mjs";
import {
  figureFlags,
  mergeLink,
  moduleLink,
  pageFlags,
  programLink,
  runtimeFlags,
  studentFlags,
  testFlags,
  timedFigureFlags,
} from "./flags.mjs";
import { inRoot } from "./paths.mjs";

/** @typedef {import('./recipes.mjs').Recipe} Recipe */
/** @typedef {import('./recipes.mjs').Compile} Compile */
/** @typedef {{ name: string, output: string, recipe: Recipe }} Product
 *   `output` is where it goes, below the output folder */

/** @param {string} folder @returns {string[]} */
const names = (folder) => (fs.existsSync(folder) ? fs.readdirSync(folder).sort() : []);

/** The chapters, in order. */
export function chapters() {
  const wrong = Object.entries(book().problems).find(([file]) => file.endsWith("/chapter.toml"));
  if (wrong) throw new Error(wrong[1]);
  return Object.keys(book().chapters).sort();
}

/**
 * Whether a product is built: it is one of these, or belongs to one of these chapters. None: everything is.
 * @param {string} name @param {readonly string[]} only
 */
export const isAskedFor = (name, only) =>
  only.length === 0 || only.some((one) => name === one || name.startsWith(`${one}/`));

/**
 * A chapter's own folder, then those of the chapters that it builds on, near ones first.
 * @param {string} slug @returns {string[]}
 */
export function chapterFolders(slug) {
  const found = new Set([slug]);
  for (const name of found) {
    for (const earlier of chapterEntry(name).builds_on) found.add(earlier);
  }
  return [...found].map((name) => inRoot("chapters", name));
}

/** @param {string[]} flags @returns {import('./recipes.mjs').Precompile} */
const pagePrelude = (flags) => ({
  tool: "precompile",
  what: `the headers that all ${flags === pageFlags ? "ladders" : flags === figureFlags ? "figures" : "figures with times"} share`,
  flags,
  folders: [],
  source: inRoot("page", "wasm", "page_prelude.hpp"),
});

/** @type {import('./recipes.mjs').Precompile} */
export const checkPrelude = {
  tool: "precompile",
  what: "the prelude of the exercises",
  inPage: true,
  flags: studentFlags,
  folders: [inRoot("grading")],
  source: inRoot("grading", "contact", "prelude.hpp"),
};

/** @type {import('./recipes.mjs').Precompile} */
const testPrelude = {
  tool: "precompile",
  what: "what the tests of exercises include",
  flags: testFlags,
  folders: [inRoot("tests"), inRoot("grading"), inRoot("chapters", "00_vectors")],
  source: inRoot("tests", "support", "exercise_precompiled.hpp"),
};

/** @type {Compile} */
const throwStub = {
  tool: "compile",
  what: "page/wasm/throw_stub.cpp",
  language: "c++",
  flags: pageFlags,
  folders: [],
  source: inRoot("page", "wasm", "throw_stub.cpp"),
};

/** Of figures alone: ladders measure, and the C library's heap is quicker. @type {Compile} */
const smallHeap = {
  tool: "compile",
  what: "page/wasm/small_heap.cpp",
  language: "c++",
  // Its own calls would become calls of itself: memory that is set to 0 is what calloc gives.
  flags: [...figureFlags, "-fno-builtin"],
  folders: [],
  source: inRoot("page", "wasm", "small_heap.cpp"),
};

/**
 * A module that the page calls: one C++ file with its exports.
 * @param {string} source @param {string[]} folders @param {string[]} flags
 * @param {Compile[]} others what else is linked @returns {Recipe}
 */
function moduleRecipe(source, folders, flags, others = []) {
  const what = path.relative(inRoot(), source);
  const pch = pagePrelude(flags);
  return {
    tool: "link",
    what,
    ...moduleLink,
    parts: [
      { tool: "compile", what, language: "c++", flags, folders, source, pch },
      throwStub,
      ...others,
    ],
  };
}

/**
 * @param {string} source @param {string[]} folders where the reference headers are
 * @param {boolean} timed whether the page measures its times
 */
export const figureRecipe = (source, folders, timed = false) => {
  const found = [inRoot("page", "figure"), ...folders];
  const part = timed
    ? moduleRecipe(source, found, timedFigureFlags)
    : moduleRecipe(source, found, figureFlags, [smallHeap]);
  return /** @type {const} */ ({ tool: "shrink", what: part.what, part });
};

/** Whether a figure has a control that measures times. @param {string} source */
function isTimed(source) {
  const drawing = source.replace(/\.cpp$/, ".ts");
  return fs.existsSync(drawing) && fs.readFileSync(drawing, "utf8").includes('kind: "measure"');
}

/** Every figure: chapters/NN_slug/figures/NAME.cpp. @returns {Product[]} */
export function figures() {
  return chapters().flatMap((slug) =>
    names(inRoot("chapters", slug, "figures"))
      .filter((file) => file.endsWith(".cpp"))
      .map((file) => {
        const name = `${slug}/${path.basename(file, ".cpp")}`;
        const source = inRoot("chapters", slug, "figures", file);
        const recipe = figureRecipe(source, chapterFolders(slug), isTimed(source));
        return { name, output: `figures/${name}.wasm`, recipe };
      }),
  );
}

/** Every ladder: chapters/NN_slug/ladder.cpp. @returns {Product[]} */
export function ladders() {
  return chapters()
    .map((slug) => ({ slug, source: inRoot("chapters", slug, "ladder.cpp") }))
    .filter(({ source }) => fs.existsSync(source))
    .map(({ slug, source }) => ({
      name: slug,
      output: `ladders/${slug}.wasm`,
      recipe: moduleRecipe(source, [inRoot("tests"), ...chapterFolders(slug)], pageFlags),
    }));
}

/**
 * The runtime that makes throw and catch work: the compiler's package comes without it.
 * @type {import('./recipes.mjs').Archive}
 */
export const exceptionRuntime = (() => {
  const home = inRoot("page", "wasm", "third_party", "llvm-eh");
  const folders = [
    "shim",
    "libunwind/include",
    "libcxxabi/include",
    "libcxx/include",
    "libcxx/src",
  ].map((folder) => path.join(home, folder));
  const part = (/** @type {string} */ file, /** @type {Compile['language']} */ language) => {
    const flags = language === "c++" ? runtimeFlags.cxx : runtimeFlags[language];
    const source = path.join(home, file);
    const what = path.relative(inRoot(), source);
    return /** @type {Compile} */ ({ tool: "compile", what, language, flags, folders, source });
  };
  return {
    tool: "archive",
    what: "the exception runtime",
    parts: [
      part("libunwind/src/Unwind-wasm.c", "c"),
      part("shim/tag.s", "assembly"),
      ...[
        "cxa_exception",
        "cxa_personality",
        "cxa_exception_storage",
        "cxa_aux_runtime",
        "fallback_malloc",
      ].map((name) => part(`libcxxabi/src/${name}.cpp`, "c++")),
    ],
  };
})();

/** Where tools/fetch_catch2_source.sh puts Catch2's two amalgamated files. */
export const catch2Source = inRoot("build", "catch2", "extras", "catch_amalgamated.cpp");

/** @returns {Compile} */
function catch2() {
  if (!fs.existsSync(catch2Source))
    throw new Error("the source of Catch2 is missing: run tools/fetch_catch2_source.sh");
  return {
    tool: "compile",
    what: "Catch2",
    language: "c++",
    flags: [...testFlags, "-DCATCH_AMALGAMATED_CUSTOM_MAIN"],
    folders: [path.dirname(catch2Source)],
    source: catch2Source,
  };
}

/** The asking and the runner: tests/support. @returns {Recipe[]} */
function support() {
  const folders = [inRoot("tests"), inRoot("grading"), ...chapterFolders("00_vectors")];
  const files = names(inRoot("tests", "support"))
    .filter(
      (file) => /^(exercise|observed|runner).*\.cpp$/.test(file) && !file.endsWith("_test.cpp"),
    )
    .map((file) => inRoot("tests", "support", file));
  const lastWords = inRoot("page", "wasm", "last_words.cpp");
  return [...files, lastWords].map((file) => supportObject(file, folders));
}

/** @param {string} source @param {string[]} folders @returns {Compile} */
const supportObject = (source, folders) => ({
  tool: "compile",
  what: path.relative(inRoot(), source),
  language: "c++",
  flags: testFlags,
  folders,
  source,
  pch: testPrelude,
});

/** What may be met from outside: as cmake/ContactExercises.cmake gives it to contact_seal, and the page's questions. */
const keptNames = [
  "__main_argc_argv",
  "_ZN7contact4todoEv",
  "contact_spare_stack",
  "contact_last_words",
];

/** What a student's object needs of the libraries too: it must be one for all. @returns {Recipe[]} */
const openRuntime = () => [
  supportObject(inRoot("page", "wasm", "test_runtime.cpp"), []),
  ...exceptionRuntime.parts,
];

/** What the tests of every exercise are linked with, in one object, not yet sealed. @returns {Recipe} */
export const openChecks = () => ({
  tool: "link",
  what: "what all tests are linked with",
  ...mergeLink,
  parts: [...support(), catch2(), ...openRuntime()],
});

/** @param {Recipe} part @param {Recipe[]} others @returns {Recipe} */
const sealedWith = (part, others) => ({
  tool: "seal",
  what: part.what,
  part,
  others,
  open: openRuntime(),
  keep: keptNames,
});

/** The same, sealed. */
export const checksObject = () => sealedWith(openChecks(), []);

/** @typedef {{ name: string, slug: string, folder: string, test: string }} Exercise
 *   `folder` holds the contract, `test` is the file of its tests */

/** Every exercise with tests: exercises/NN_slug/NAME/NAME.hpp, tests/NN_slug/NAME_test.cpp. */
export function exerciseList() {
  return names(inRoot("exercises"))
    .flatMap((slug) =>
      names(inRoot("exercises", slug)).map((short) => ({
        name: `${slug}/${short}`,
        slug,
        folder: inRoot("exercises", slug, short),
        test: inRoot("tests", slug, `${short}_test.cpp`),
      })),
    )
    .filter(({ test }) => fs.existsSync(test));
}

/** @param {Exercise} exercise */
const exerciseFolders = ({ folder, slug }) => [
  folder,
  inRoot("tests"),
  inRoot("grading"),
  ...chapterFolders(slug),
];

/** An exercise's tests, not yet sealed. @param {Exercise} exercise @returns {Compile} */
export const openTests = (exercise) => ({
  tool: "compile",
  what: path.relative(inRoot(), exercise.test),
  language: "c++",
  flags: testFlags,
  folders: exerciseFolders(exercise),
  source: exercise.test,
  pch: testPrelude,
});

/**
 * An exercise's tests, compiled once, as the page will link them with a student's object.
 * @param {Exercise} exercise
 */
export const testObject = (exercise) => sealedWith(openTests(exercise), [openChecks()]);

/** Where a student's file may look beside the folder of its contract: the prelude, the shared shapes; no tests. */
export const studentFolders = [inRoot("grading"), inRoot("chapters", "00_vectors")];

/**
 * An answer (stub, solution, wrong or a student's) linked with an exercise's tests.
 * @param {Exercise} exercise @param {string} answer its .cpp @returns {import('./recipes.mjs').Link}
 */
export function checkProgram(exercise, answer) {
  const what = path.relative(inRoot(), answer);
  /** @type {Compile} */
  const object = {
    tool: "compile",
    what,
    language: "c++",
    inPage: true,
    flags: studentFlags,
    source: answer,
    pch: checkPrelude,
    folders: [exercise.folder, ...studentFolders],
  };
  return {
    tool: "link",
    what,
    ...programLink,
    parts: [object, testObject(exercise), checksObject()],
  };
}
