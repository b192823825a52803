// All of it for Node: the record of the table and its test ask the same code as the page.

export { book } from "./adapters/book.ts";
export { ADAPTERS } from "./adapters.ts";
export * from "./ask.ts";
export { flipTime } from "./questions/rotation.ts";
export { QUESTIONS } from "./questions.ts";
export * from "./simulate.ts";
