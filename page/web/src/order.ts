// The logic of steps to put in order, apart from their element.

/** The list with the item at `from` moved to `to`; the others keep their order. */
export function moved<T>(items: readonly T[], from: number, to: number): T[] {
  const left = [...items];
  const [item] = left.splice(from, 1);
  if (item === undefined) return left;
  left.splice(Math.max(0, Math.min(left.length, to)), 0, item);
  return left;
}

/** How many items from the start are where they belong. */
export function rightFromStart(given: readonly number[], answer: readonly number[]): number {
  const first = given.findIndex((item, i) => item !== answer[i]);
  return first < 0 ? given.length : first;
}
