// A file of C++ that calls a reader's function with the numbers of a figure, and what it answers.
//
// The file exports contact_mine_start (once), contact_mine_given (where the numbers go),
// contact_mine_answer and contact_mine_found. An answer is, for each row: whether there is one,
// whether it is a yes or no, how many numbers it has, and the numbers.

import type { Fields } from "../layout.ts";

/** How the page names the tie that the lesson declares (docs/_ext/contact_book/try_mine.py). */
export interface Tie {
  /** NN_slug/NAME */
  readonly figure: string;
  readonly call: string;
  /** The figure's fields that the call uses. */
  readonly fields: readonly string[];
  /** The function answers only while this field of the figure, given or computed, has this value. */
  readonly only: { readonly field: string; readonly value: number; readonly words: string } | null;
  /** A state of the figure, by its label, in which the field has it. */
  readonly start: string | null;
  readonly rows: readonly TieRow[];
}

export interface TieRow {
  readonly label: string;
  /** C++, of the result `mine`. */
  readonly mine: string;
  readonly book: string;
  readonly index: number | null;
  /** The field that says whether the book has this. */
  readonly when: string | null;
  /** The field that says whether the two are compared. */
  readonly asked: string | null;
}

/** One row of an answer; nothing if there is none. */
export type Found =
  | { readonly kind: "truth" | "numbers"; readonly numbers: readonly number[] }
  | undefined;

/** Numbers that differ by less, for their size, are the same: two correct methods may round differently. */
export const ALLOWED = 1e-9;

/** More numbers than any row has. */
const ROOM = 256;

const numbersOf = (value: number | readonly number[] | undefined): readonly number[] =>
  typeof value === "number" ? [value] : (value ?? []);

/** The numbers that the call uses, one field after the other. */
export function givenTo(tie: Tie, fields: Fields): number[] {
  return tie.fields.flatMap((name) => [...numbersOf(fields[name])]);
}

export function callerSource(tie: Tie, file: string, fields: Fields): string {
  let at = 0;
  const variables = tie.fields.map((name) => {
    const size = numbersOf(fields[name]).length;
    const from = at;
    at += size;
    const list = Array.from({ length: size }, (_, i) => `given[${from + i}]`).join(", ");
    if (size === 1) return `  const double ${name} = ${list};`;
    if (size === 2 || size === 3) return `  const Eigen::Vector${size}d ${name}{${list}};`;
    return `  const std::array<double, ${size}> ${name}{${list}};`;
  });
  // An empty optional has no members.
  const rows = tie.rows.map(({ mine }) =>
    mine.includes("mine->") ? `  if (mine) put(${mine}); else none();` : `  put(${mine});`,
  );
  return `#include <contact/prelude.hpp>
#include "${file.replace(/\.cpp$/, ".hpp")}"
#include <array>
#include <cstring>
#include <exception>
#include <type_traits>
extern "C" void __wasm_call_ctors();
namespace {
struct NotWritten {};
double given[${Math.max(at, 1)}];
double found[${ROOM}];
int used;
char words[256];
void add(double value) { if (used < ${ROOM}) found[used++] = value; }
[[maybe_unused]] void none() { add(0); add(0); add(0); }
template <class T> void put(const T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    add(1); add(std::is_same_v<T, bool>); add(1); add(static_cast<double>(value));
  } else {
    add(1); add(0); add(static_cast<double>(value.size()));
    for (int i = 0; i < static_cast<int>(value.size()); ++i) add(static_cast<double>(value[i]));
  }
}
void answer() {
  using namespace exercise;
${variables.join("\n")}
  const auto mine = exercise::${tie.call};
${rows.join("\n")}
}
}  // namespace
[[noreturn]] void not_written() __asm__("__wrap__ZN7contact4todoEv");
void not_written() { throw NotWritten{}; }
extern "C" {
__attribute__((export_name("contact_mine_start"))) void contact_mine_start() { __wasm_call_ctors(); }
__attribute__((export_name("contact_mine_given"))) double* contact_mine_given() { return given; }
__attribute__((export_name("contact_mine_found"))) double* contact_mine_found() { return found; }
__attribute__((export_name("contact_mine_words"))) char* contact_mine_words() { return words; }
__attribute__((export_name("contact_mine_answer"))) int contact_mine_answer() {
  used = 0;
  try {
    answer();
    return used;
  } catch (const NotWritten&) {
    return -1;
  } catch (const std::exception& error) {
    std::strncpy(words, error.what(), sizeof words - 1);
    return -2;
  } catch (...) {
    words[0] = 0;
    return -2;
  }
}
}
`;
}

/** The rows of an answer. */
export function readFound(numbers: readonly number[]): Found[] {
  const rows: Found[] = [];
  for (let at = 0; at + 2 < numbers.length; ) {
    const [there, truth, size = 0] = numbers.slice(at, at + 3);
    rows.push(
      there
        ? { kind: truth ? "truth" : "numbers", numbers: numbers.slice(at + 3, at + 3 + size) }
        : undefined,
    );
    at += 3 + size;
  }
  return rows;
}

/** What the figure has for a row. */
export function booksOwn(row: TieRow, output: Fields, kind: "truth" | "numbers"): Found {
  if (row.when !== null && !output[row.when]) return undefined;
  const numbers = numbersOf(output[row.book]);
  return { kind, numbers: row.index === null ? numbers : [numbers[row.index] ?? Number.NaN] };
}

const near = (a: number, b: number): boolean =>
  Object.is(a, b) || a === b || Math.abs(a - b) <= ALLOWED * Math.max(1, Math.abs(a), Math.abs(b));

export function same(mine: Found, book: Found): boolean {
  if (!mine || !book) return mine === book;
  return (
    mine.numbers.length === book.numbers.length &&
    mine.numbers.every((value, i) => near(value, book.numbers[i]!))
  );
}
