// While `./contact serve` still builds the book, the server says at building.json what is waiting to
// be built, in order, and what of it is being built. Asking for a thing moves it to the front. On any other host there is no such
// file, and nothing is waited for.

interface Building {
  readonly waiting: readonly string[];
  readonly building: readonly string[];
}

const PAUSE = 1500;

async function building(base: string, name: string): Promise<Building | undefined> {
  try {
    const address = new URL(`../../building.json?want=${encodeURIComponent(name)}`, base);
    const answer = await fetch(address, { cache: "no-store" });
    return answer.ok ? ((await answer.json()) as Building) : undefined;
  } catch {
    return undefined;
  }
}

/**
 * Returns when `name` is not, or no longer, waiting to be built; says whether it waited.
 *
 * @param base the folder with the page's built files
 * @param say is told how many are before it
 */
export async function untilBuilt(
  name: string,
  base: string,
  say: (words: string) => void,
  signal?: AbortSignal,
): Promise<boolean> {
  for (let waited = false; ; waited = true) {
    const said = await building(base, name);
    signal?.throwIfAborted();
    const before = said?.waiting.indexOf(name) ?? -1;
    if (said === undefined || before < 0) return waited;
    const others = before === 1 ? "one other is" : `${before} others are`;
    const now = before === 0 || said.building.includes(name);
    say(now ? "This is being built now." : `This is not built yet: ${others} before it.`);
    await new Promise((resolve) => setTimeout(resolve, PAUSE));
  }
}
