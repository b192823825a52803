// How fast a scene's clock runs in the page.

/** Seconds of the scene in one second of the page's clock. */
export const PACES = [1e-4, 1e-3, 0.01, 0.1, 0.25, 0.5, 1, 2, 5, 10, 60, 600] as const;

/** The pace at which a scene takes some seconds to watch: the real one if that is so. */
export function paceFor(duration: number): number {
  return duration >= 1 && duration <= 20 ? 1 : watchablePace(duration);
}

/** The pace at which a scene takes about eight seconds to watch. */
export function watchablePace(duration: number): number {
  const wanted = duration / 8;
  return PACES.reduce((best, pace) =>
    Math.abs(Math.log(pace / wanted)) < Math.abs(Math.log(best / wanted)) ? pace : best,
  );
}

/** The longest time between two pictures that the clock makes up for: then it is slower instead. */
const LONGEST = 1 / 30;

/** Until when to run for the next picture. */
export function nextTime(now: number, elapsed: number, pace: number, duration: number): number {
  return Math.min(duration, now + Math.min(Math.max(elapsed, 0), LONGEST) * pace);
}
