// The page's scripts read the same data as grading/book, and an author's mistake is reported.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { book, chapterEntry, exerciseEntry, wrongAnswers } from "./book.mjs";
import { inRoot } from "./paths.mjs";

const id = "12_momentum/force_curve";

test("the registry is the book's", () => {
  assert.deepEqual(book().problems, {});
  assert.ok(chapterEntry("02_triangles").builds_on.includes("01_planes"));
  assert.ok(exerciseEntry(id).tests.length > 2);
  assert.throws(
    () => exerciseEntry("12_momentum/x"),
    /no exercises\/12_momentum\/x\/exercise.toml/,
  );
  assert.throws(() => chapterEntry("99_none"), /no chapters\/99_none\/chapter.toml/);
});

test("wrong answers are whole, however they are kept", () => {
  const kept = fs.readdirSync(inRoot("solutions", id, "wrong"));
  assert.ok(kept.some((name) => name.endsWith(".patch")));
  const whole = wrongAnswers(id);
  assert.equal(whole.length, kept.length);
  for (const file of whole)
    assert.match(
      fs.readFileSync(inRoot(file), "utf8"),
      /^\/\/ misconception: .+\n\/\/ caught by: /,
    );
  assert.deepEqual(wrongAnswers("12_momentum/x"), []);
});
