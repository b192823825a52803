import assert from "node:assert/strict";
import test from "node:test";
import { parseHTML } from "linkedom";
import { load } from "./load.mjs";

const { document, HTMLElement, Node } = parseHTML("<!doctype html><html><body></body></html>");
Object.assign(globalThis, { document, HTMLElement, Node });

const { colour } = await load("exercise/colour.ts");
const { columnToOffset } = await load("exercise/columns.ts");
const { messageList, printed, sentence, testList } = await load("exercise/results.ts");
const { readParts } = await load("exercise/parts.ts");
const { Versions } = await load("exercise/versions.ts");
const { doneWords } = await load("offline/controls.ts");

/** @param {string} code */
function coloured(code) {
  const made = document.createElement("pre");
  made.append(colour(code));
  const spans = [...made.querySelectorAll("span")];
  return { text: made.textContent, marks: spans.map((s) => [s.className, s.textContent]) };
}

test("colouring changes no letter of the code", () => {
  for (const code of [
    '#include "a.hpp"\n#include <vector>\n\nint f() { return 1\'000 + 0x1f; }  // α "x"\n',
    "/* never closed\nint x;",
    '"never closed\nint y;',
    "#define A \\\n  'x' /* c */ <tag> && !b\n",
    "",
    "<script>alert(1)</script>",
  ])
    assert.equal(coloured(code).text, code);
});

test("words have the classes of the book's listings", () => {
  assert.deepEqual(coloured('const double x = -1.5e3;  // "no" return').marks, [
    ["k", "const"],
    ["kt", "double"],
    ["o", "="],
    ["o", "-"],
    ["mf", "1.5e3"],
    ["c1", '// "no" return'],
  ]);
  assert.deepEqual(coloured("/* a\nreturn */ constant").marks, [["cm", "/* a\nreturn */"]]);
  assert.deepEqual(coloured('#include "r.hpp"').marks, [
    ["cp", "#include"],
    ["s", '"r.hpp"'],
  ]);
  assert.deepEqual(coloured("'\\'' true").marks, [
    ["s", "'\\''"],
    ["kc", "true"],
  ]);
});

test("the compiler's columns are bytes, the editor's are not", () => {
  assert.equal(columnToOffset("abc", 1), 0);
  assert.equal(columnToOffset("abc", 3), 2);
  assert.equal(columnToOffset("αβ = 1;", 5), 2);
  assert.equal(columnToOffset("≤x", 4), 1);
  assert.equal(columnToOffset("😀x", 5), 2);
  assert.equal(columnToOffset("ab", 9), 2);
});

/** @param {Record<string, unknown>} more */
const verdict = (more) => ({
  exercise: "02_triangles/ray_triangle",
  file: "ray_triangle.cpp",
  verdict: "failed",
  points: 3,
  max_points: 6,
  tests: [
    { name: "one", status: "passed", points: 3, max_points: 3, seconds: 0 },
    {
      name: "two",
      status: "stopped",
      points: 0,
      max_points: 1,
      seconds: 0,
      failure: { asked: "Where?", inputs: [], reason: "It ran for 5 s." },
    },
    {
      name: "three",
      status: "failed",
      points: 0,
      max_points: 1,
      seconds: 0,
      failure: {
        asked: "What?",
        inputs: [
          { name: "a", text: "1" },
          { name: "long", text: "2\n3" },
        ],
        got: "<b>4</b>",
        right: "5",
        allowed: "1e-9",
        misconception: "beta-sign",
        hint: "as text",
      },
    },
    {
      name: "four",
      status: "skipped",
      points: 0,
      max_points: 1,
      seconds: 0,
      failure: { asked: "", inputs: [], reason: "It needs “two”." },
    },
  ],
  warnings: [],
  output: "",
  seconds: { compile: 0, link: 0, run: 0 },
  ...more,
});

/** @param {any} list */
const rows = (list) =>
  [...list.querySelectorAll("dt")].map((term) => [
    term.textContent,
    term.nextElementSibling.textContent,
  ]);

test("each test is a sentence with a mark, words for it, and points", () => {
  const list = testList(verdict({}), undefined);
  const items = [...list.children];
  assert.deepEqual(
    items.map((item) => item.getAttribute("data-status")),
    ["passed", "stopped", "failed", "skipped"],
  );
  assert.equal(items[0].querySelector(".sentence").textContent, "passed: one");
  assert.equal(items[0].querySelector(".points").textContent, "3 of 3 points");
  assert.equal(items[3].querySelector(".reason").textContent, "It needs “two”.");
});

test("the first failure is shown whole, the others are folded", () => {
  const list = testList(verdict({}), undefined);
  assert.equal(list.querySelectorAll(".failure").length, 1);
  const [, first, second] = list.children;
  assert.deepEqual(rows(first.querySelector(".failure")), [
    ["Asked", "Where?"],
    ["What stopped the test", "It ran for 5 s."],
  ]);
  assert.deepEqual(rows(second.querySelector("details")), [
    ["Asked", "What?"],
    ["Input", "a    = 1\nlong = 2\n       3"],
    ["Came back", "<b>4</b>"],
    ["Right", "5to within 1e-9"],
    ["Hint", "as text"],
  ]);
  assert.equal(second.querySelector("b"), null);
});

test("a recognised misconception has its hint as the book sets it", () => {
  const data = { misconceptions: { "beta-sign": "<p>The <em>sign</em>.</p>" } };
  const list = testList(verdict({}), data);
  assert.equal(list.querySelector("details em").textContent, "sign");
  assert.ok(!list.textContent.includes("as text"));
});

test("a test that keeps its values to itself says so", () => {
  const failure = { asked: "Where?", inputs: [], hint: "look back" };
  const kept = { ...verdict({}).tests[2], visibility: "values_withheld", failure };
  const [item] = testList(verdict({ tests: [kept] }), undefined).children;
  assert.deepEqual(rows(item), [
    ["Asked", "Where?"],
    ["Hint", "look back"],
    ["Not shown", "This test does not show its values."],
  ]);
});

test("a test that passed shows what it has to show, folded", () => {
  const finding = {
    asked: "Which?",
    inputs: [{ name: "x", text: "5" }],
    right: "25",
    reason: "Off by 15.",
  };
  const found = { ...verdict({}).tests[0], finding };
  const [item] = testList(verdict({ tests: [found] }), undefined).children;
  assert.equal(item.getAttribute("data-status"), "passed");
  assert.equal(item.querySelector(".failure"), null);
  assert.equal(item.querySelector("details > summary").textContent, "What it shows");
  assert.deepEqual(rows(item.querySelector("details")), [
    ["Asked", "Which?"],
    ["Input", "x = 5"],
    ["Right", "25"],
    ["Why", "Off by 15."],
  ]);
});

test("the sentence says where to look first", () => {
  assert.equal(sentence(verdict({})), "3 of 6 points: 2 tests fail. First look at “two”.");
  assert.match(sentence(verdict({ verdict: "passed", points: 6 })), /^Passed.*6 of 6 points/);
  assert.match(sentence(verdict({ verdict: "not_attempted" })), /todo\(\)/);
  const at = { severity: "error", line: 7, file: "ray_triangle.cpp" };
  const broken = (/** @type {unknown[]} */ diagnostics) =>
    sentence(verdict({ verdict: "does_not_compile", tests: [], diagnostics }));
  assert.match(broken([at]), /one error on line 7/);
  assert.match(broken([{ severity: "warning", line: 2 }, at, at]), /2 errors.* line 7/);
  assert.match(broken([]), /say what is missing/);
});

/** @param {Record<string, unknown>} more */
const message = (more) => ({
  file: "ray_triangle.cpp",
  line: 5,
  column: 3,
  end_line: 5,
  end_column: 9,
  severity: "error",
  message: "use of undeclared identifier 'retrun'",
  words: "There is nothing called retrun here.",
  ...more,
});

test("messages are in the beginner's words, with the compiler's own and its notes folded away", () => {
  /** @type {any[]} */
  const asked = [];
  const diagnostics = [
    message({}),
    message({ severity: "note", message: "did you mean 'return'?", words: "" }),
    message({ severity: "warning", line: 2, words: "x is never used" }),
    message({ file: "exercises/02_triangles/ray_triangle/ray_triangle.hpp", line: 30 }),
  ];
  const [list] = messageList(
    verdict({ diagnostics }),
    "ray_triangle.cpp",
    (/** @type {any} */ one) => asked.push(one.line),
  );
  const items = [...list.children];
  assert.equal(items.length, 3);
  assert.equal(items[0].querySelector(".words").textContent, diagnostics[0].words);
  const original = items[0].querySelector("details");
  assert.equal(original.hasAttribute("open"), false);
  assert.match(original.querySelector("pre").textContent, /undeclared.*\n.*did you mean/);
  assert.equal(items[1].querySelector(".words").textContent, "Warning: x is never used");
  assert.match(items[2].querySelector(".place").textContent, /ray_triangle\.hpp, line 30/);
  assert.equal(items[2].querySelector("button"), null);
  items[0].querySelector("button").click();
  assert.deepEqual(asked, [5]);
});

test("what only the linker knows is said too, beside the contract's line", () => {
  const made = messageList(
    verdict({
      verdict: "does_not_compile",
      diagnostics: [],
      compile_error: {
        file: "",
        line: 0,
        message: "undefined symbol",
        explanation: "The tests call ray_triangle, and there is none.",
        contract: [{ file: "exercises/x/ray_triangle.hpp", line: 34, text: "bool f(int);" }],
        full: "wasm-ld: error: undefined symbol",
      },
    }),
    "ray_triangle.cpp",
    () => {},
  );
  const text = made.map((/** @type {any} */ element) => element.textContent).join("\n");
  assert.match(text, /there is none/);
  assert.match(text, /wasm-ld: error/);
  assert.match(text, /ray_triangle\.hpp on line 34:\nbool f\(int\);/);
  assert.deepEqual(
    messageList(verdict({}), "ray_triangle.cpp", () => {}),
    [],
  );
});

test("what the program printed is shown as text, and not without end", () => {
  assert.deepEqual(printed(verdict({})), []);
  const [box] = printed(verdict({ output: "<i>x</i>\n".repeat(1000) }));
  const shown = box.querySelector("pre");
  assert.equal(shown.querySelector("i"), null);
  assert.equal(shown.textContent.split("\n").length, 201);
});

test("an earlier version says what its check said, and seconds where a minute is shared", () => {
  const list = new Versions(() => {});
  const said = { verdict: "failed", points: 4, max_points: 8 };
  list.show(
    [
      { text: "e", at: "2026-01-02T10:05:09Z", why: "checked", said },
      {
        text: "d",
        at: "2026-01-02T10:05:01Z",
        why: "checked",
        said: { ...said, verdict: "passed" },
      },
      {
        text: "c",
        at: "2026-01-02T10:04:00Z",
        why: "checked",
        said: { ...said, verdict: "does_not_compile" },
      },
      { text: "b\nb\n", at: "2026-01-02T10:03:00Z", why: "reset" },
      { text: "present", at: "2026-01-02T10:02:00Z", why: "checked" },
    ],
    "present",
  );
  const rows = /** @type {Element[]} */ ([...list.element.querySelectorAll("li")]);
  const words = rows.map((row) => (row.firstChild?.textContent ?? "").trim().split(" at ")[1]);
  assert.match(words[0] ?? "", /^\d\d:05:09, as you checked it: 4 of 8 points$/);
  assert.match(words[1] ?? "", /^\d\d:05:01, as you checked it: passed$/);
  assert.match(words[2] ?? "", /^\d\d:04, as you checked it: does not compile$/);
  assert.match(words[3] ?? "", /^\d\d:03, before Reset: 2 lines$/);
  assert.equal(words.length, 4);
  assert.match(list.element.querySelector("p")?.textContent ?? "", /^At most 20 are kept/);
});

test("a book kept without the compiler is not said to be everything", () => {
  const file = { file: "a.o", bytes: 1, transfer: 1 };
  const compiler = { all: [file], missing: [file], inUse: false };
  assert.match(
    doneWords(compiler),
    /^Done, without the compiler: .*Check will not work offline\.$/,
  );
  assert.match(doneWords({ ...compiler, missing: [] }), /^Done: everything is kept/);
  assert.match(doneWords(undefined), /^Done: everything is kept/);
});

test("the page's own listings, points and hints are found", () => {
  const { document: page } = parseHTML(`<html><body><section id="e"><h3>Exercise: A title<a
    class="headerlink" href="#e">#</a></h3><contact-exercise name="02_triangles/ray_triangle"
    base="../_static/contact/"><div class="contract"><div class="highlight"><pre>contract</pre></div>
    </div><div class="stub"><pre>a <span>stub</span>\n</pre></div><div class="commands">c</div>
    <div class="table-wrapper"><table></table></div><div class="hints"><details><summary>A
    hint</summary><p>one</p><details><summary>One more hint</summary><p>two</p></details></details>
    </div></contact-exercise></section></body></html>`);
  Object.assign(globalThis, { document: { baseURI: "http://book.test/chapters/02.html" } });
  const parts = readParts(page.querySelector("contact-exercise"));
  Object.assign(globalThis, { document });
  assert.equal(parts.id, "02_triangles/ray_triangle");
  assert.equal(parts.base, "http://book.test/_static/contact/");
  assert.equal(parts.title, "A title");
  assert.equal(parts.file, "ray_triangle.cpp");
  assert.equal(parts.stub, "a stub\n");
  assert.equal(parts.contract, "contract");
  const words = parts.hints.map((/** @type {any[]} */ hint) =>
    hint.map((node) => node.textContent.trim()).join(""),
  );
  assert.deepEqual(words, ["one", "two"]);
  assert.ok(parts.points && parts.commands);
});
