// What grading/book/forms.py makes of a solution with marks, and the C++ that an answer in a form becomes.

export interface Part {
  readonly text: string;
  /** Why these lines stand here; empty if they are fixed. */
  readonly reason: string;
  /** What a reader fills in: parts of the text. */
  readonly gaps: readonly string[];
}

export interface Distractor {
  readonly text: string;
  readonly misconception: string;
}

/** `[piece]`, or `[piece, distractor]` for what a wrong answer has instead of that piece. */
export type Line = readonly [number] | readonly [number, number];

export interface FormData {
  readonly parts: readonly Part[];
  /** The lines of each function in their shuffled order. */
  readonly runs: readonly (readonly Line[])[];
  readonly distractors: readonly Distractor[];
}

/** A line of *order* as the reader has put it: which of its run, and whether it is left out. */
export interface Put {
  readonly line: number;
  readonly out: boolean;
}

export const isPiece = (part: Part): boolean => part.reason !== "";

/** Its lines of code, each with its line feed: a comment would tell which of two lines is right. */
const codeOf = (text: string): string =>
  text
    .split("\n")
    .filter((line) => !/^\s*(\/\/.*)?$/.test(line))
    .map((line) => `${line}\n`)
    .join("");

export function lineText(data: FormData, line: Line): string {
  const [piece, distractor] = line;
  return codeOf(
    distractor === undefined ? data.parts[piece]!.text : data.distractors[distractor]!.text,
  );
}

/** What is shown around the lines: the fixed text before each run, and the one after the last. */
export function fixedTexts(data: FormData): string[] {
  const texts = [""];
  let inRun = false;
  for (const part of data.parts) {
    if (isPiece(part) && !inRun) texts.push("");
    inRun = isPiece(part);
    if (!inRun) texts[texts.length - 1] += part.text;
  }
  return texts;
}

export function orderedText(data: FormData, order: readonly (readonly Put[])[]): string {
  const [first, ...after] = fixedTexts(data);
  const runs = data.runs.map((run, at) =>
    (order[at] ?? [])
      .filter(({ out }) => !out)
      .map(({ line }) => lineText(data, run[line]!))
      .join(""),
  );
  return first! + runs.map((text, at) => text + after[at]!).join("");
}

/** The solution as text between gaps: one more text than there are gaps. */
export function aroundGaps(data: FormData): string[] {
  const texts = [""];
  for (const { text, gaps } of data.parts) {
    const positions = gaps.map((gap) => ({ begin: text.indexOf(gap), size: gap.length }));
    let done = 0;
    for (const { begin, size } of positions.sort((a, b) => a.begin - b.begin)) {
      texts[texts.length - 1] += text.slice(done, begin);
      texts.push("");
      done = begin + size;
    }
    texts[texts.length - 1] += text.slice(done);
  }
  return texts;
}

export function filledText(data: FormData, gaps: readonly string[]): string {
  const [first, ...after] = aroundGaps(data);
  return first! + after.map((text, at) => (gaps[at] ?? "").trim() + text).join("");
}
