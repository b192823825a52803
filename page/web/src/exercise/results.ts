// A verdict as the reader sees it: what the compiler said, each test with its mark, and the first
// failure whole. Loaded when there is a verdict.

import type {
  CompileError,
  Diagnostic,
  ExerciseData,
  Failure,
  TestVerdict,
  VerdictJson,
} from "../cpp/types.ts";
import { html } from "../dom.ts";
import { number } from "./points.ts";

const MARKS: Record<TestVerdict["status"], readonly [mark: string, words: string]> = {
  passed: ["✓", "passed"],
  failed: ["✗", "failed"],
  stopped: ["!", "stopped"],
  not_attempted: ["○", "not attempted"],
  skipped: ["–", "skipped"],
};

const count = (n: number, one: string, many = `${one}s`): string => `${n} ${n === 1 ? one : many}`;

const isFailure = ({ status }: TestVerdict): boolean => status === "failed" || status === "stopped";

const errorsOf = (verdict: VerdictJson): readonly Diagnostic[] =>
  (verdict.diagnostics ?? []).filter(({ severity }) => severity === "error");

/** The verdict in one sentence or two. */
export function sentence(verdict: VerdictJson): string {
  const points = `${number(verdict.points)} of ${number(verdict.max_points)} points`;
  if (verdict.verdict === "passed") return `Passed: every test passed. ${points}.`;
  if (verdict.verdict === "not_attempted")
    return "Not attempted: your function still says contact::todo(). Put your answer in its place.";
  if (verdict.verdict === "does_not_compile") {
    const errors = errorsOf(verdict);
    const [first] = errors;
    if (!first) return "It does not compile yet. The messages below say what is missing.";
    const where = first.line > 0 ? ` on line ${first.line}` : "";
    return errors.length === 1
      ? `It does not compile yet: there is one error${where}.`
      : `It does not compile yet: ${errors.length} errors. Begin with the first${where}.`;
  }
  const failures = verdict.tests.filter(isFailure);
  const [first] = failures;
  const look = first ? ` First look at “${first.name}”.` : "";
  return `${points}: ${count(failures.length, "test fails", "tests fail")}.${look}`;
}

/** Blanks that make the names of inputs line up. */
function aligned(inputs: Failure["inputs"]): string {
  const width = Math.max(...inputs.map(({ name }) => name.length));
  return inputs
    .map(({ name, text }) => {
      const rest = text.replaceAll("\n", `\n${" ".repeat(width + 3)}`);
      return `${name.padEnd(width)} = ${rest}`;
    })
    .join("\n");
}

const literal = (text: string): HTMLElement => html("pre", {}, text);

function explained(
  { status, visibility }: TestVerdict,
  failure: Failure,
  data: ExerciseData | undefined,
): HTMLElement {
  const list = html("dl");
  const add = (name: string, ...content: (Node | string)[]): void =>
    list.append(html("dt", {}, name), html("dd", {}, ...content));
  if (failure.asked) add("Asked", failure.asked);
  if (failure.inputs.length > 0) add("Input", literal(aligned(failure.inputs)));
  if (failure.got) add("Came back", literal(failure.got));
  if (failure.right) {
    const within = failure.allowed
      ? html("p", { class: "allowed" }, "to within ", html("code", {}, failure.allowed))
      : "";
    add("Right", literal(failure.right), within);
  }
  if (failure.reason) add(status === "stopped" ? "What stopped the test" : "Why", failure.reason);
  const known = failure.misconception && data?.misconceptions[failure.misconception];
  if (known) {
    const words = html("div");
    words.innerHTML = known;
    add("Hint", words);
  } else if (failure.hint) add("Hint", failure.hint);
  if (visibility === "values_withheld") add("Not shown", "This test does not show its values.");
  return list;
}

const more = (label: string, content: HTMLElement): HTMLElement =>
  html("details", { class: "more" }, html("summary", {}, label), content);

function test(verdict: TestVerdict, first: boolean, data: ExerciseData | undefined): HTMLElement {
  const { status, failure, finding } = verdict;
  const [mark, words] = MARKS[status];
  const points = `${number(verdict.points)} of ${number(verdict.max_points)}`;
  const row = html(
    "li",
    { "data-status": status },
    html("span", { class: "mark", "aria-hidden": "true" }, mark),
    html(
      "span",
      { class: "sentence" },
      html("span", { class: "spoken" }, `${words}: `),
      verdict.name,
    ),
    html("span", { class: "points" }, points, html("span", { class: "spoken" }, " points")),
  );
  if (finding) row.append(more("What it shows", explained(verdict, finding, data)));
  if (!failure) return row;
  if (!isFailure(verdict)) {
    if (failure.reason) row.append(html("p", { class: "reason" }, failure.reason));
  } else if (first)
    row.append(html("div", { class: "failure" }, explained(verdict, failure, data)));
  else row.append(more("What happened", explained(verdict, failure, data)));
  return row;
}

export function testList(verdict: VerdictJson, data: ExerciseData | undefined): HTMLElement {
  const first = verdict.tests.find(isFailure);
  const rows = verdict.tests.map((one) => test(one, one === first, data));
  return html("ol", { class: "tests" }, ...rows);
}

function original(...texts: string[]): HTMLElement {
  const shown = texts.filter(Boolean).join("\n");
  return html("details", {}, html("summary", {}, "The compiler's own words"), literal(shown));
}

const placed = ({ file, line, column, message, severity }: Diagnostic): string => {
  const place = line > 0 ? `${file}:${line}:${column}: ` : file ? `${file}: ` : "";
  return `${place}${severity}: ${message}`;
};

/** The messages in their order; what belongs to one (a note) is kept with it. `full` is all that was said: the linker
 * names no line, so that what is said of its message is the book's, and its own words are all of them. */
function messageRows(
  diagnostics: readonly Diagnostic[],
  full: string,
  file: string,
  goTo: (message: Diagnostic) => void,
): HTMLElement[] {
  const rows: { main: Diagnostic; notes: Diagnostic[] }[] = [];
  for (const message of diagnostics) {
    const last = rows.at(-1);
    if (message.severity === "note" && last) last.notes.push(message);
    else rows.push({ main: message, notes: [] });
  }
  return rows.map(({ main, notes }) => {
    const row = html("li", { "data-severity": main.severity });
    if (main.line > 0 && main.file.endsWith(file)) {
      const jump = html("button", { type: "button", class: "place" }, `Line ${main.line}`);
      jump.addEventListener("click", () => goTo(main));
      row.append(jump, " ");
    } else if (main.file) {
      const where = main.line > 0 ? `${main.file}, line ${main.line}` : main.file;
      row.append(html("span", { class: "place" }, where), " ");
    }
    const kind = main.severity === "warning" ? "Warning: " : "";
    row.append(html("span", { class: "words" }, kind + main.words));
    const linker = full !== "" && !full.includes(main.message);
    row.append(linker ? original(full) : original(...[main, ...notes].map(placed)));
    return row;
  });
}

function lone(error: CompileError): HTMLElement {
  const words = html("span", { class: "words" }, error.explanation || error.message);
  return html("li", { "data-severity": "error" }, words, original(error.full || error.message));
}

export function messageList(
  verdict: VerdictJson,
  file: string,
  goTo: (message: Diagnostic) => void,
): HTMLElement[] {
  const error = verdict.compile_error;
  const rows = messageRows(verdict.diagnostics ?? [], error?.full ?? "", file, goTo);
  if (error && !rows.some((row) => row.dataset["severity"] === "error")) rows.unshift(lone(error));
  if (rows.length === 0) return [];
  const made: HTMLElement[] = [html("ol", { class: "messages" }, ...rows)];
  for (const line of error?.contract ?? []) {
    const name = line.file.split("/").at(-1) ?? line.file;
    made.push(
      html("p", { class: "quoted" }, `The contract says, in ${name} on line ${line.line}:`),
      literal(line.text),
    );
  }
  return made;
}

/** What the reader's program printed, if anything. */
export function printed(verdict: VerdictJson): HTMLElement[] {
  if (!verdict.output) return [];
  const lines = verdict.output.split("\n");
  const shown = lines.slice(0, 200).join("\n") + (lines.length > 200 ? "\n…" : "");
  const summary = html("summary", {}, "Your program printed");
  return [html("details", { class: "printed", open: "" }, summary, literal(shown))];
}
