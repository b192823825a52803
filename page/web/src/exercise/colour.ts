// C++ with the classes that the book's listings have, for code that is only looked at.

import { html } from "../dom.ts";

const KEYWORDS = new Set(
  (
    "alignas alignof asm auto break case catch class concept const consteval constexpr constinit " +
    "const_cast continue co_await co_return co_yield decltype default delete do dynamic_cast else " +
    "enum explicit export extern final for friend goto if inline mutable namespace new noexcept " +
    "operator override private protected public reinterpret_cast requires return sizeof static " +
    "static_assert static_cast struct switch template this thread_local throw try typedef typeid " +
    "typename union using virtual volatile while"
  ).split(" "),
);
const TYPES = new Set(
  "bool char double float int long short signed unsigned void wchar_t size_t".split(" "),
);
const LITERALS = new Set(["true", "false", "nullptr"]);

// In order: comment to the end of the line, comment between marks, directive, string, number, word,
// operators.
const TOKEN =
  /(\/\/.*)|(\/\*[\s\S]*?(?:\*\/|(?![\s\S])))|(^[ \t]*#[ \t]*\w+(?:[ \t]*<[^>\n]*>)?)|("(?:\\.|[^"\\\n])*"?|'(?:\\.|[^'\\\n])*'?)|(\b\d[\w.']*)|([A-Za-z_]\w*)|([~!%^&*+=|?<>/-]+)/gm;
const CLASSES = ["c1", "cm", "cp", "s", "mf", "", "o"];

function classOf(groups: readonly (string | undefined)[]): string {
  const kind = groups.findIndex((group) => group !== undefined);
  const word = kind === 5 ? groups[5]! : "";
  if (KEYWORDS.has(word)) return "k";
  if (TYPES.has(word)) return "kt";
  if (LITERALS.has(word)) return "kc";
  return CLASSES[kind] ?? "";
}

export function colour(code: string): DocumentFragment {
  const made = document.createDocumentFragment();
  let done = 0;
  for (const match of code.matchAll(TOKEN)) {
    const name = classOf(match.slice(1));
    if (!name) continue;
    made.append(code.slice(done, match.index), html("span", { class: name }, match[0]));
    done = match.index + match[0].length;
  }
  made.append(code.slice(done));
  return made;
}
