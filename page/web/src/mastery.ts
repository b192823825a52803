// Which objectives a reader has mastered, as `contact progress` says it: by the book's own judge.

import type { ExerciseData } from "./cpp/types.ts";
import { html } from "./dom.ts";
import type { Progress } from "./work.ts";

interface Tally {
  readonly exercises: number;
  readonly passed: number;
  readonly mastered: boolean;
}

interface Report {
  readonly chapters: readonly {
    readonly slug: string;
    readonly objectives: readonly (Tally & { readonly text: string })[];
  }[];
}

/** The judge's report on these exercises. Loads the judge, which is small, and no compiler. */
async function report(base: URL, ids: readonly string[], progress: Progress): Promise<Report> {
  const all = await Promise.all(
    ids.map(async (id) => {
      const response = await fetch(new URL(`exercises/${id}.json`, base));
      if (!response.ok) throw new Error(`${id}: ${response.status}`);
      return (await response.json()) as ExerciseData;
    }),
  );
  const [first] = all;
  if (!first) return { chapters: [] };
  const files = Object.assign({}, ...all.map((data) => data.files));
  const { Checker } = await import("./cpp/checker.ts");
  const judge = await Checker.for(base.href).judge({ ...first, id: ids.join(" "), files });
  const known = Object.entries(progress.exercises).filter(([id]) => ids.includes(id));
  return judge.report({
    format: progress.format,
    exercises: Object.fromEntries(known),
  }) as unknown as Report;
}

function standing(passed: number, exercises: number, mastered: boolean): string {
  if (mastered) return "Mastered. ";
  return passed === 0 ? "Not passed yet. " : `${passed} of ${exercises} passed. `;
}

/** The objectives of the chapters that the reader has begun; empty where there is no judge. */
export async function masteryList(
  base: URL,
  chapters: readonly {
    readonly slug: string;
    readonly title: string;
    readonly exercises: readonly { readonly id: string }[];
  }[],
  progress: Progress,
): Promise<HTMLElement | undefined> {
  const begun = chapters.filter(({ exercises }) =>
    exercises.some(({ id }) => progress.exercises[id]),
  );
  const ids = begun.flatMap(({ exercises }) => exercises.map(({ id }) => id));
  const said = await report(base, ids, progress);
  const parts = begun.flatMap(({ slug, title }) => {
    const objectives = said.chapters.find((chapter) => chapter.slug === slug)?.objectives ?? [];
    const items = objectives
      .filter(({ exercises }) => exercises > 0)
      .map(({ text, exercises, passed, mastered }) =>
        html(
          "li",
          { "data-mastered": String(mastered) },
          html("strong", {}, standing(passed, exercises, mastered)),
          text.replace(/[*`$]/g, ""),
        ),
      );
    return items.length > 0 ? [html("h3", {}, title), html("ul", {}, ...items)] : [];
  });
  if (parts.length === 0) return undefined;
  return html("section", { class: "mastery" }, html("h2", {}, "What you have learnt"), ...parts);
}
