// The flags of every WebAssembly build. A precompiled header can be used only with the flags that it was compiled with,
// so all flags are defined here.

/** Where the virtual file tree keeps headers that are not in the repository. */
export const systemRoot = "system";

/** What the driver would pass on: calling the compiler proper saves its first pass. */
const compiler = [
  "clang++",
  "-cc1",
  "-triple",
  "wasm32-unknown-wasip1",
  "-target-cpu",
  "generic",
  "-mrelocation-model",
  "static",
  "-mframe-pointer=none",
  "-mconstructor-aliases",
  "-fvisibility=hidden",
  "-disable-free",
  "-clear-ast-before-backend",
  "-fno-implicit-modules",
  "-resource-dir",
  "/usr",
  "-isysroot",
  "/usr",
  "-fgnuc-version=4.2.1",
  "-fdeprecated-macro",
  "-ferror-limit",
  "10",
  "-ftemplate-backtrace-limit=4",
];

/** The same arithmetic as in every native build (cmake/ContactOptions.cmake). */
const arithmetic = ["-ffp-contract=off", "-fno-rounding-math", "-DEIGEN_DONT_VECTORIZE"];

/** Searched after the project's own folders. */
const libraries = [
  "-internal-isystem",
  "/usr/include/wasm32-wasip1/c++/v1",
  "-internal-isystem",
  "/usr/include/c++/v1",
  "-internal-isystem",
  "/usr/include",
  "-internal-isystem",
  "/usr/include/wasm32-wasip1",
  "-internal-isystem",
  `/${systemRoot}/eigen3`,
  "-internal-isystem",
  `/${systemRoot}`,
];

const cxx = ["-std=c++20", "-fcxx-exceptions", "-fexceptions"];
const warnings = ["-Wall", "-Wextra"];

/**
 * Exceptions by the engine's own means, in the encoding that all browsers know (the later one is not in Node
 * 18). Needs the runtime in third_party/llvm-eh.
 */
const exceptions = [
  "-target-feature",
  "+exception-handling",
  "-target-feature",
  "+multivalue",
  "-target-feature",
  "+reference-types",
  "-exception-model=wasm",
  "-mllvm",
  "-wasm-enable-eh",
  "-mllvm",
  "-wasm-use-legacy-eh=true",
];

/** Ladders: as quick as the native ones; a throw ends the run (throw_stub.cpp). */
export const pageFlags = [
  ...compiler,
  ...arithmetic,
  ...libraries,
  ...cxx,
  ...warnings,
  "-O2",
  "-DNDEBUG",
];

/**
 * Figures: small, since a page fetches all of its own, and none of them computes for long. `Output out{}` leaves
 * Eigen's columns unset without the first definition: numbers of the state before. printf would be half of a module.
 */
export const figureFlags = [
  ...pageFlags.map((flag) => (flag === "-O2" ? "-Oz" : flag)),
  "-DEIGEN_INITIALIZE_MATRICES_BY_ZERO",
  "-DCONTACT_WITHOUT_PRINTF",
];

/** Figures that measure times: as quick as ladders. */
export const timedFigureFlags = figureFlags.map((flag) => (flag === "-Oz" ? "-O2" : flag));

/** Holds our __assertion_handler, so that what was broken is said, and not only that something was. */
export const assertionsFolder = "page/wasm/libcxx";

/**
 * What a student's file is compiled with, in the build and in the page: as contact_student_flags of
 * cmake/ContactExercises.cmake has it, with the same warnings and with exceptions. Where libstdc++ asserts
 * (_GLIBCXX_ASSERTIONS), libc++ does.
 */
export const studentFlags = [
  ...compiler,
  ...arithmetic,
  "-internal-isystem",
  `/${assertionsFolder}`,
  ...libraries,
  ...cxx,
  ...warnings,
  "-Wpedantic",
  "-Wshadow",
  "-Wconversion",
  "-Wno-unused-parameter",
  "-Werror=return-type",
  ...exceptions,
  "-O1",
  // Address 0 is memory like any other here: without this, following a null pointer stops nothing.
  "-fsanitize=null",
  "-fsanitize-trap=null",
  "-D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_EXTENSIVE",
];

/** So that a message can be shown at its place in the editor: ranges as numbers. */
export const diagnosticFlags = ["-fdiagnostics-print-source-range-info"];

/** Libraries that are not ours: their warnings are not ours to read. */
export const quiet = ["-w"];

/** The tests of exercises and Catch2; warnings are the native build's to give. */
export const testFlags = [
  ...studentFlags.filter((flag) => !flag.startsWith("-fsanitize")),
  ...quiet,
  "-DCATCH_CONFIG_NO_POSIX_SIGNALS",
];

/** The runtime for exceptions, as its own build has it. */
const runtimeDefines = [
  "-O2",
  "-DNDEBUG",
  "-D_LIBUNWIND_HIDE_SYMBOLS",
  "-D_LIBUNWIND_HAS_NO_THREADS",
  "-D_LIBUNWIND_IS_NATIVE_ONLY",
  "-D_LIBCXXABI_BUILDING_LIBRARY",
  "-D_LIBCXXABI_HAS_NO_THREADS",
  "-D_LIBCPP_BUILDING_LIBRARY",
  "-DLIBCXX_BUILDING_LIBCXXABI",
  "-D__WASM_EXCEPTIONS__",
  "-D__USING_WASM_EXCEPTIONS__",
];
export const runtimeFlags = {
  cxx: [
    ...compiler,
    ...libraries,
    "-std=c++23",
    "-fcxx-exceptions",
    "-fexceptions",
    ...exceptions,
    ...quiet,
    ...runtimeDefines,
  ],
  c: [...compiler, ...libraries, "-std=c17", ...exceptions, ...quiet, ...runtimeDefines],
  assembly: [
    "clang",
    "-cc1as",
    "-triple",
    "wasm32-unknown-wasip1",
    "-target-cpu",
    "generic",
    "-target-feature",
    "+exception-handling",
    "-filetype",
    "obj",
  ],
};

export const precompileFlags = ["-fno-pch-timestamp", "-fpch-instantiate-templates"];

const library = "/usr/lib/wasm32-wasip1";
const builtins = "/usr/lib/wasm32-unknown-wasip1/libclang_rt.builtins.a";
const linker = ["wasm-ld", "-m", "wasm32", "--strip-all", "--stack-first", `-L${library}`];

/** Several objects made one, to be linked again. */
export const mergeLink = { before: ["wasm-ld", "-m", "wasm32", "-r"], after: [] };

/** A module that is called (no main): a figure, a ladder. Its stack comes first, so an overflow traps. */
export const moduleLink = {
  before: [...linker, "--no-entry", "-z", "stack-size=262144", `${library}/crt1-reactor.o`],
  after: ["-lc++", "-lc++abi", "-lc", builtins],
};

/** A program that is run: an exercise's tests. Memory is limited as the native check limits it. */
export const programLink = {
  before: [
    ...linker,
    "-z",
    "stack-size=1048576",
    "--max-memory=268435456",
    // To be asked when the program has died: last_words.cpp.
    ...["contact_spare_stack", "contact_last_words", "__stack_pointer"].map(
      (name) => `--export=${name}`,
    ),
    `${library}/crt1-command.o`,
  ],
  after: ["-lc++", "-lc++abi", "-lc", builtins],
};
