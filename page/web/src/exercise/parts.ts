// What the page says of an exercise before any script: the listings, the points, the hints.

import type { InputSpec } from "./input-panel.ts";
import type { Tie } from "./mine-program.ts";

export interface Parts {
  /** NN_slug/NAME */
  readonly id: string;
  /** The address of …/_static/contact/ */
  readonly base: string;
  readonly title: string;
  /** NAME.cpp */
  readonly file: string;
  readonly stub: string;
  readonly contract: string;
  readonly contractListing: HTMLElement;
  /** The code to break, if there is any. */
  readonly given: HTMLElement | undefined;
  readonly inputs: readonly InputSpec[];
  /** How the lesson's figure calls the reader's function, if it can. */
  readonly mine: Tie | undefined;
  readonly points: HTMLElement | undefined;
  readonly commands: HTMLElement | undefined;
  readonly hints: readonly Node[][];
  /** Whether it can also be read, ordered and filled. */
  readonly forms: boolean;
}

/** A heading without its link to itself. */
export function headingOf(section: Element | null): string {
  const heading = section?.querySelector("h1, h2, h3, h4, h5")?.cloneNode(true) as Element | null;
  heading?.querySelector(".headerlink")?.remove();
  return heading?.textContent?.trim() ?? "";
}

function hintsOf(element: Element): Node[][] {
  const hints: Node[][] = [];
  let folded = element.querySelector(":scope > .hints > details");
  while (folded) {
    const content = [...folded.childNodes].filter(
      (node) => !(node instanceof HTMLElement && node.matches("summary, details")),
    );
    hints.push(content);
    folded = folded.querySelector(":scope > details");
  }
  return hints;
}

export function readParts(element: HTMLElement): Parts | undefined {
  const id = element.getAttribute("name");
  const part = (name: string): HTMLElement | null => element.querySelector(`:scope > ${name}`);
  const contract = part(".contract");
  const stub = part(".stub")?.querySelector("pre");
  if (!id || !contract || !stub) return undefined;
  return {
    id,
    base: new URL(element.getAttribute("base") ?? "./", document.baseURI).href,
    title: headingOf(element.closest("section")).replace(/^Exercise: /, ""),
    file: `${id.split("/")[1]}.cpp`,
    stub: stub.textContent ?? "",
    contract: contract.querySelector("pre")?.textContent ?? "",
    contractListing: contract,
    given: part(".given") ?? undefined,
    inputs: JSON.parse(element.getAttribute("inputs") ?? "[]") as InputSpec[],
    mine: JSON.parse(element.getAttribute("mine") ?? "null") ?? undefined,
    points: part(".table-wrapper, table") ?? undefined,
    commands: part(".commands") ?? undefined,
    hints: hintsOf(element),
    forms: element.hasAttribute("forms"),
  };
}

export interface Next {
  readonly href: string;
  readonly words: string;
}

/** What comes after an exercise: the next one, the section that follows, or the next page. */
export function nextAfter(element: HTMLElement): Next | undefined {
  const own = element.closest("section");
  if (!own) return undefined;
  for (const section of document.querySelectorAll<HTMLElement>("article section[id]")) {
    const follows = own.compareDocumentPosition(section) & Node.DOCUMENT_POSITION_FOLLOWING;
    if (!follows || own.contains(section)) continue;
    const words = headingOf(section);
    const exercise = section.matches(".exercise");
    const label = exercise ? words.replace(/^Exercise: /, "Next exercise: ") : `Read on: ${words}`;
    return { href: `#${section.id}`, words: label };
  }
  const page = document.querySelector<HTMLAnchorElement>(".related-pages a.next-page");
  const title = page?.querySelector(".title")?.textContent?.trim();
  return page && title ? { href: page.href, words: `Next chapter: ${title}` } : undefined;
}
