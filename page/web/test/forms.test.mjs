import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";
import { load } from "./load.mjs";

const { aroundGaps, filledText, fixedTexts, lineText, orderedText } =
  await load("exercise/form-data.ts");
const { asForm, isForm, WorkStore } = await load("work.ts");
const { mergeProgress } = await load("archive.ts");

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../../..");
const part = (text, reason = "", gaps = []) => ({ text, reason, gaps });
const data = {
  parts: [
    part("int f() {\n"),
    part("  int a = 1 + 2;\n\n", "First.", ["1 + 2"]),
    part("  // Not needed.\n  return a * a;\n", "Last.", ["a * a"]),
    part("}\nint g() {\n"),
    part("  return f() - f();\n", "None is left.", ["f() - f()"]),
    part("}\n"),
  ],
  runs: [[[2], [1, 0], [1]], [[4]]],
  distractors: [{ text: "  int a = 2;", misconception: "sign" }],
};
const put = (line, out = false) => ({ line, out });

test("lines in order, without those left out, stand between the fixed texts of their function", () => {
  assert.deepEqual(fixedTexts(data), ["int f() {\n", "}\nint g() {\n", "}\n"]);
  assert.equal(
    orderedText(data, [[put(2), put(1, true), put(0)], [put(0)]]),
    "int f() {\n  int a = 1 + 2;\n  return a * a;\n}\nint g() {\n  return f() - f();\n}\n",
  );
  assert.equal(
    orderedText(data, [[put(1), put(0), put(2)], [put(0, true)]]),
    "int f() {\n  int a = 2;\n  return a * a;\n  int a = 1 + 2;\n}\nint g() {\n}\n",
  );
});

test("a line to order shows no comment, which would tell that it is the right one", () => {
  assert.equal(lineText(data, [2]), "  return a * a;\n");
  assert.equal(lineText(data, [1, 0]), "  int a = 2;\n");
});

test("gaps take what was typed, in the order of the text", () => {
  assert.equal(aroundGaps(data).length, 4);
  const solution = data.parts.map(({ text }) => text).join("");
  assert.equal(filledText(data, ["1 + 2", "a * a", "f() - f()"]), solution);
  assert.ok(filledText(data, [" 3 "]).startsWith("int f() {\n  int a = 3;\n"));
});

test("of every solution with marks, the right order and the right gaps are the solution", () => {
  const python = path.join(root, "build/venv/bin/python");
  const script =
    "import json, sys; sys.path.insert(0, sys.argv[1]); from forms import *\n" +
    "print(json.dumps({e: form_data(e) for e in sys.argv[2:]}))";
  const solutions = path.join(root, "solutions");
  const ids = fs
    .readdirSync(solutions)
    .flatMap((chapter) =>
      fs.readdirSync(path.join(solutions, chapter)).map((name) => `${chapter}/${name}`),
    );
  const book = path.join(root, "grading/book");
  const command = fs.existsSync(python) ? python : "python3";
  const all = JSON.parse(execFileSync(command, ["-c", script, book, ...ids]).toString());
  const marked = Object.values(all).filter(Boolean);
  assert.ok(marked.length > 20);
  const code = (text) => text.split("\n").filter((line) => !/^\s*(\/\/.*)?$/.test(line));
  for (const form of marked) {
    const solution = form.parts.map(({ text }) => text).join("");
    const gaps = form.parts.flatMap(({ text, gaps }) =>
      [...gaps].sort((a, b) => text.indexOf(a) - text.indexOf(b)),
    );
    assert.equal(filledText(form, gaps), solution);
    const order = form.runs.map((run) =>
      run
        .map((line, at) => ({ line: at, out: line.length > 1, piece: line[0] }))
        .sort((a, b) => a.piece - b.piece),
    );
    assert.deepEqual(code(orderedText(form, order)), code(solution));
  }
});

test("the record of an exercise takes a form, and none where it says nothing", () => {
  const empty = { format: "contact-progress/1", exercises: {} };
  assert.deepEqual(asForm(empty, "x", "write"), empty);
  const filling = asForm(empty, "x", "fill");
  assert.deepEqual(filling.exercises, { x: { form: "fill" } });
  assert.deepEqual(asForm(filling, "x", "write"), empty);
  const tried = { ...empty, exercises: { x: { attempts: 2, form: "fill" } } };
  assert.deepEqual(asForm(tried, "x", "write").exercises, { x: { attempts: 2 } });
  assert.ok(isForm("order") && !isForm("read") && !isForm(undefined));
});

test("of two records, each form keeps the earlier of its two times", () => {
  const record = (entry) => ({ format: "contact-progress/1", exercises: { "02_a/b": entry } });
  const early = "2026-01-01T00:00:00Z";
  const late = "2026-01-02T00:00:00.5Z";
  const merged = mergeProgress(
    record({ passed_as: { fill: late, write: late } }),
    record({ passed_as: { fill: early, order: late, read: early, write: "soon" }, form: "read" }),
  );
  assert.deepEqual(merged.exercises["02_a/b"], {
    passed_as: { fill: early, order: late, write: late },
  });
});

test("what is done in a form is kept, and what cannot be read is nothing", () => {
  const kept = new Map();
  const storage = {
    getItem: (key) => kept.get(key) ?? null,
    setItem: (key, value) => kept.set(key, value),
    removeItem: (key) => kept.delete(key),
    key: (index) => [...kept.keys()][index] ?? null,
    get length() {
      return kept.size;
    },
  };
  const work = new WorkStore(storage);
  assert.equal(work.forms("02_a/b"), undefined);
  const state = { form: "fill", of: "1", order: [[put(0)]], gaps: ["x"] };
  work.setForms("02_a/b", state);
  assert.deepEqual(work.forms("02_a/b"), state);
  assert.deepEqual(work.ids(), []);
  kept.set("contact-hours/1/forms/02_a/b", "[");
  assert.equal(work.forms("02_a/b"), undefined);
});
