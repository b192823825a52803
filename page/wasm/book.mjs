// What the chapters and exercises say of themselves, and their wrong answers as C++: as the programs in grading/book
// read them, which are asked once by each process.
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { inRoot } from "./paths.mjs";

/** @typedef {{ title: string, status: string, builds_on: string[], exercises: string[] }} Chapter */
/** @typedef {{ name: string, points: number }} Test */
/** @typedef {{ title: string, misconceptions: string[], tests: Test[] }} ExerciseEntry */
/** @typedef {{ summary: string, hint: string }} Misconception */
/**
 * @typedef {{
 *   chapters: Record<string, Chapter>,
 *   exercises: Record<string, ExerciseEntry>,
 *   misconceptions: Record<string, Misconception>,
 *   problems: Record<string, string>,
 * }} Book
 */

/** @param {string} program @param {string[]} words */
function ask(program, ...words) {
  const own = inRoot("build", "venv", "bin", "python");
  const python = fs.existsSync(own) ? own : "python3";
  const all = [inRoot("grading", "book", program), ...words];
  const done = spawnSync(python, all, { encoding: "utf8" });
  if (done.status !== 0)
    throw new Error(`${program}: ${done.error?.message ?? done.stdout + done.stderr}`);
  return done.stdout;
}

/** @type {Book | undefined} */
let read;

/** build/book.json, brought up to date. @returns {Book} */
export function book() {
  read ??= JSON.parse(fs.readFileSync(ask("book_json.py").trim(), "utf8"));
  return /** @type {Book} */ (read);
}

/** For a file that is not there or has a mistake in it. @param {string} file @returns {never} */
function refuse(file) {
  const problem = book().problems[file];
  throw new Error(problem ?? `there is no ${file}`);
}

/** @param {string} slug */
export const chapterEntry = (slug) =>
  book().chapters[slug] ?? refuse(`chapters/${slug}/chapter.toml`);

/** @param {string} id NN_slug/NAME */
export const exerciseEntry = (id) =>
  book().exercises[id] ?? refuse(`exercises/${id}/exercise.toml`);

/**
 * An exercise's wrong answers, by their names, as files of C++: paths from the root.
 * @param {string} id NN_slug/NAME @returns {string[]}
 */
export function wrongAnswers(id) {
  ask("wrong_answers.py", id);
  const folder = path.posix.join("build", "wrong", id);
  if (!fs.existsSync(inRoot(folder))) return [];
  return fs
    .readdirSync(inRoot(folder))
    .filter((name) => /^[^.].*\.cpp$/.test(name))
    .sort()
    .map((name) => `${folder}/${name}`);
}
