// An input as numbers, for exercises that break code: what is typed becomes the body of the function that returns it.
import assert from "node:assert/strict";
import test from "node:test";
import { parseHTML } from "linkedom";
import { load } from "./load.mjs";

const { document, HTMLElement, Node, Event } = parseHTML(
  "<!doctype html><html><body></body></html>",
);
Object.assign(globalThis, { document, HTMLElement, Node });
globalThis.CSS = /** @type {any} */ ({ escape: (/** @type {string} */ text) => text });

const { bodyOf, literal, withBody } = await load("exercise/input-code.ts");
const { inputPanel } = await load("exercise/input-panel.ts");

test("a typed number is compiled as it was typed", () => {
  for (const [typed, compiled] of [
    ["3", "3"],
    [" -0.25 ", "-0.25"],
    ["\u22121e-9", "-1e-9"],
    ["+.5", ".5"],
    ["0x1.8p-53", "0x1.8p-53"],
    ["007", "7"],
    ["-0", "-0.0"],
    ["1000000000", "1000000000.0"],
    ["999999999", "999999999"],
  ])
    assert.equal(literal(typed), compiled, typed);
  for (const none of ["", "x", "1,5", "1e", "0x10", "1;", "1.2.3", "NaN", "--1"])
    assert.equal(literal(none), undefined, none);
});

test("the body has the shape of the value", () => {
  assert.equal(bodyOf(["1", "-2.5"]), "{\n  return {1, -2.5};\n}");
  assert.equal(
    bodyOf([
      ["0", "0"],
      ["6", "1"],
    ]),
    "{\n  return {{0, 0}, {6, 1}};\n}",
  );
  assert.equal(
    bodyOf({ u: ["1", "2", "3"], k: "0.5" }),
    "{\n  return {.u = {1, 2, 3}, .k = 0.5};\n}",
  );
  const long = bodyOf(Array.from({ length: 30 }, (_, i) => [String(i), "0.125"]));
  assert.equal(long.split("\n").length, 34);
  assert.ok(long.split("\n").every((line) => line.length <= 100));
  assert.throws(() => bodyOf([["1", "two"]]), /two/);
});

test("only the function's own body is replaced", () => {
  const source = `// points() { is not meant }
const char* name = "points() {";
int more_points() { return points().size(); }
std::vector<double> points() {
  // a brace in a comment: }
  if (ready()) { return {1, 2}; }
  return {'}', 1'000};
}
int after() { return 1; }
`;
  const changed = withBody(source, "points", "{\n  return {3};\n}");
  assert.equal(
    changed,
    `// points() { is not meant }
const char* name = "points() {";
int more_points() { return points().size(); }
std::vector<double> points() {
  return {3};
}
int after() { return 1; }
`,
  );
  assert.equal(withBody(source, "missing", "{}"), undefined);
  assert.equal(withBody("int f() { return 1;", "f", "{}"), undefined);
});

/** @param {any} spec @param {string} text */
function panel(spec, text) {
  const host = { now: text, said: "" };
  const element = inputPanel([spec], {
    text: () => host.now,
    replace: (/** @type {string} */ changed) => {
      host.now = changed;
    },
    say: (/** @type {string} */ words) => {
      host.said = words;
    },
  });
  const press = (/** @type {string} */ label) => {
    const found = [...element.querySelectorAll("button")].find((b) => b.textContent === label);
    assert.ok(found, label);
    found.dispatchEvent(new Event("click"));
  };
  const type = (/** @type {number} */ at, /** @type {string} */ words) => {
    const input = element.querySelectorAll("input")[at];
    input.value = words;
    input.dispatchEvent(new Event("input"));
  };
  return { element, host, press, type };
}

const stub = "P points() { contact::todo(); }\nP other() { contact::todo(); }\n";

test("points are typed, added, removed and written into the code", () => {
  const spec = {
    function: "points",
    says: "Some points",
    start: [
      [0, 0],
      [6, 1],
    ],
    figure: "",
    from: [],
  };
  const { element, host, press, type } = panel(spec, stub);
  type(3, "1e-9");
  press("Add a point");
  assert.equal(element.querySelectorAll(".knob").length, 3);
  press("Write them into the code");
  assert.equal(
    host.now,
    "P points() {\n  return {{0, 0}, {6, 1e-9}, {6, 1e-9}};\n}\nP other() { contact::todo(); }\n",
  );
  const [first] = element.querySelectorAll('[aria-label="Remove point 0"]');
  first?.dispatchEvent(new Event("click"));
  press("Write them into the code");
  assert.match(host.now, /return \{\{6, 1e-9\}, \{6, 1e-9\}\};/);
});

test("numbers that the code does not have yet are said to be so", () => {
  const points = [
    [0, 0],
    [6, 1],
  ];
  const spec = { function: "points", says: "Some points", start: points, figure: "", from: [] };
  const { element, press, type } = panel(spec, stub);
  const said = () => element.querySelector(".unwritten")?.textContent;
  assert.equal(said(), "");
  const changes = [
    () => type(3, "2"),
    () => press("Add a point"),
    () => {
      const event = Object.assign(new Event("keydown"), { key: "ArrowUp" });
      element.querySelector(".knob")?.dispatchEvent(event);
    },
  ];
  for (const change of changes) {
    change();
    assert.equal(said(), "Changed, and not in the code yet.");
    press("Write them into the code");
    assert.equal(said(), "");
  }
  // What is no number is not written.
  type(0, "a half");
  press("Write them into the code");
  assert.equal(said(), "Changed, and not in the code yet.");
});

test("what is no number is named, and the code stays", () => {
  const spec = {
    function: "points",
    says: "A drop",
    start: { height: 1, k: 0.5 },
    figure: "",
    from: [],
  };
  const { host, press, type } = panel(spec, stub);
  type(1, "a half");
  press("Write them into the code");
  assert.equal(host.now, stub);
  assert.match(host.said, /a half/);
  type(1, "0.25");
  press("Write them into the code");
  assert.match(host.now, /^P points\(\) \{\n {2}return \{\.height = 1, \.k = 0\.25\};\n\}/);
});

test("a function that the reader deleted is named", () => {
  const spec = { function: "points", says: "Numbers", start: [5, 0], figure: "", from: [] };
  const { host, press } = panel(spec, "int main() {}");
  press("Write them into the code");
  assert.equal(host.now, "int main() {}");
  assert.match(host.said, /points\(\)/);
});
