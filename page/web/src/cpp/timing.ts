// Decisions about waiting, apart from what is waited for.

/** What compiling without the precompiled header costs more, in seconds. */
export const WITHOUT_PRELUDE_SECONDS = 5;

/** What a download taught about the line. */
export interface Line {
  /** Bytes that came over the network. */
  readonly bytes: number;
  readonly seconds: number;
}

/**
 * How long a check should wait for the precompiled header, in seconds: not at all if compiling without it is
 * sooner done; else somewhat longer than it should take, in case the line gets slower.
 */
export function patienceForPrelude(size: number, line: Line): number {
  // Less than this says nothing: it may have come in one gulp.
  if (line.bytes < 200_000 || line.seconds <= 0) return 0;
  const expected = (size * line.seconds) / line.bytes;
  return expected < WITHOUT_PRELUDE_SECONDS ? Math.max(1, 1.5 * expected) : 0;
}
