// Saves the exercise of a page to embed as one HTML file that works when it is opened from a disk: markup, styles, scripts, fonts,
// its tests, the judge, and, if the reader wishes, the compiler. files.ts is its counterpart in the file.

import type { Manifest } from "../cpp/types.ts";

async function answer(address: string): Promise<Response> {
  const response = await fetch(address, { cache: "no-cache" });
  if (!response.ok) throw new Error(`${address}: ${response.status}`);
  return response;
}
const textAt = async (address: string): Promise<string> => (await answer(address)).text();

/** The bytes of a file as a data: address. */
function asData(blob: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(blob);
  });
}

/** Code that nothing in it ends early inside a page. */
const inPage = (code: string): string => code.replace(/<\/(?=script)/gi, "<\\/");

/** A style sheet with the files that it names in it. */
async function style(address: string): Promise<string> {
  let text = await textAt(address);
  for (const [whole, name = ""] of text.matchAll(/url\(["']?(?!data:|#)([^"')]+)["']?\)/g)) {
    const response = await fetch(new URL(name, address));
    const data = response.ok ? await asData(await response.blob()) : "data:,";
    text = text.replace(whole, () => `url("${data}")`);
  }
  return text;
}

/** What a figure of the lesson would do for the exercise is not in the file. */
function withoutFigures(exercise: Element): void {
  exercise.removeAttribute("mine");
  const inputs: { figure: string }[] = JSON.parse(exercise.getAttribute("inputs") ?? "[]");
  for (const input of inputs) input.figure = "";
  if (inputs.length > 0) exercise.setAttribute("inputs", JSON.stringify(inputs));
}

/** The files of a check by their paths in …/_static/contact/. */
async function files(base: string, id: string, compiler: boolean): Promise<Map<string, Blob>> {
  const manifest = (await (await answer(`${base}cpp/manifest.json`)).json()) as Manifest;
  const tests = manifest.exercises[id];
  if (!tests) throw new Error(`the tests of ${id} are not built`);
  const keys = compiler ? [...manifest.core, ...manifest.behind] : ["judge.wasm"];
  const shipped = keys.flatMap((key) => manifest.files[key] ?? []);
  const names = [tests, ...shipped].map(({ file }) => `cpp/${file}`);
  names.push("exercises/book.json", `exercises/${id}.json`);
  const found = new Map<string, Blob>();
  // One after the other: together they are large.
  for (const name of names) found.set(name, await (await answer(base + name)).blob());
  for (const name of ["compile-worker.js", "run-worker.js", "program-worker.js"])
    found.set(name, await (await answer(`${base}alone/${name}`)).blob());
  const own = { ...manifest, exercises: { [id]: tests } };
  found.set("cpp/manifest.json", new Blob([JSON.stringify(own)]));
  return found;
}

/** What the file costs with the compiler in it, in bytes: base64 takes four letters for three bytes. */
export async function sizeWithCompiler(base: string): Promise<number> {
  const manifest = (await (await answer(`${base}cpp/manifest.json`)).json()) as Manifest;
  const keys = [...manifest.core, ...manifest.behind];
  const sum = keys.reduce((all, key) => all + (manifest.files[key]?.transfer ?? 0), 0);
  return (sum * 4) / 3;
}

/**
 * The file. The page is read again, as it was before any script changed it.
 * @param compiler whether the compiler is in it, or comes from the book's server
 */
export async function fileOf(address: string, compiler: boolean): Promise<Blob> {
  const page = new DOMParser().parseFromString(await textAt(address), "text/html");
  // Its base is relative to the page, and a parsed document has the address of its parser.
  const lesson = new URL(page.querySelector("base")?.getAttribute("href") ?? "", address).href;
  const absolute = (name: string | null): string => new URL(name ?? "", lesson).href;
  const section = page.querySelector("section.exercise");
  const exercise = section?.querySelector("contact-exercise");
  const id = exercise?.getAttribute("name");
  if (!section || !exercise || !id) throw new Error("there is no exercise in this page");
  withoutFigures(exercise);
  const base = absolute(exercise.getAttribute("base"));
  exercise.setAttribute("base", base);
  for (const link of page.querySelectorAll("article a[href], .from a"))
    link.setAttribute("href", absolute(link.getAttribute("href")));
  const links = [...page.querySelectorAll('link[rel="stylesheet"]')];
  const styles = await Promise.all(links.map((link) => style(absolute(link.getAttribute("href")))));
  const code = page.querySelector("head style")?.textContent ?? "";
  const theme = await textAt(absolute("../embed/page.js"));
  const script = await textAt(`${base}alone/contact.js`);
  const notices = await textAt(`${base}notices.txt`);

  const parts: BlobPart[] = [
    `<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><base href="${lesson}" target="_blank">\n`,
    '<meta name="viewport" content="width=device-width, initial-scale=1">\n',
    '<meta name="color-scheme" content="light dark">\n',
    page.querySelector("title")?.outerHTML ?? "",
    ...[...styles, code].map((text) => `<style>${text}</style>\n`),
    `</head><body class="embedded"><script>${inPage(theme)}</script>\n`,
    `<div class="content"><article role="main">${page.querySelector("h1")?.outerHTML ?? ""}`,
    `${section.outerHTML}${page.querySelector(".from")?.outerHTML ?? ""}</article></div>\n`,
  ];
  for (const [name, blob] of await files(base, id, compiler)) {
    const data = await asData(blob);
    const bytes = data.slice(data.indexOf(",") + 1);
    parts.push(`<script type="text/plain" data-file="${name}">`, bytes, "</script>\n");
  }
  parts.push(
    `<script type="text/plain" class="notices">${inPage(notices)}</script>\n`,
    `<script type="module">${inPage(script)}</script>\n</body></html>\n`,
  );
  return new Blob(parts, { type: "text/html" });
}
