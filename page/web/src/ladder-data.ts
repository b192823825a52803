// A ladder's measurements, as `contact ladder` writes them and the page makes them.

export interface LadderFamily {
  readonly id: string;
  readonly title: string;
  readonly n?: number;
  /** Shown by its largest error even if some method is wrong. */
  readonly by_error?: boolean;
  /** The question, if the ladder has several. */
  readonly part?: string;
}

export interface LadderMethod {
  readonly id: string;
  readonly title: string;
  readonly scalar: string;
  readonly exact: boolean;
  readonly recommended?: boolean;
  /** Another library, in JavaScript: only the reader's own run has it. */
  readonly peer?: boolean;
  /** What a reader must know of a peer's times. */
  readonly note?: string;
  /** The question that it answers, if the ladder has several. */
  readonly part?: string;
}

/** An input on which a method fails, as the ladder's C++ shows it. */
export interface LadderFailure {
  /** Its index in the family. */
  readonly input: number;
  readonly simplified: boolean;
  readonly error: number | null;
  readonly facts: readonly { readonly name: string; readonly text: string }[];
  readonly note: string;
  /** The figure of the chapter that shows it, and its fields there; absent if none can. */
  readonly figure?: string;
  readonly fields?: Readonly<Record<string, readonly number[]>>;
}

export interface LadderRow {
  readonly family: string;
  readonly method: string;
  readonly n: number;
  readonly wrong: number;
  readonly undecided: number;
  readonly error_median: number | null;
  readonly error_max: number | null;
  readonly ns_median: number;
  readonly ns_q1: number;
  readonly ns_q3: number;
  readonly repeats: number;
  /** That there is an input on which the method fails. It lies in a file of its own, and is loaded when somebody asks. */
  readonly fails?: boolean;
  readonly failure?: LadderFailure;
}

/** The failing inputs of a ladder, by `family method`. */
export type LadderFailures = Readonly<Record<string, LadderFailure>>;

export interface LadderResult {
  readonly ladder: string;
  readonly question: string;
  readonly families: readonly LadderFamily[];
  readonly methods: readonly LadderMethod[];
  readonly results: readonly LadderRow[];
}

/** From the page's worker: the ladder's peers, one row each, then the end. */
export type WorkerMessage =
  | { readonly kind: "peers"; readonly peers: readonly LadderMethod[] }
  | { readonly kind: "row"; readonly row: LadderRow; readonly done: number; readonly of: number }
  | { readonly kind: "end"; readonly seconds: number }
  | { readonly kind: "error"; readonly message: string };

export type Kind = "float" | "double" | "exact";
export const KINDS: readonly Kind[] = ["float", "double", "exact"];

export function kindOf({ scalar, exact }: LadderMethod): Kind {
  if (exact || scalar === "exact" || scalar === "rational") return "exact";
  return scalar.startsWith("float") ? "float" : "double";
}

export function methodName({ title, scalar }: LadderMethod): string {
  return title.toLowerCase().includes(scalar.toLowerCase()) ? title : `${title}, ${scalar}`;
}

/** The book's measurement, and what a reader's own run says of the peers. The book's rows come first. */
export function withPeers(
  result: LadderResult,
  peers: readonly LadderMethod[],
  here: readonly LadderRow[],
): LadderResult {
  // A ladder of one question has no parts in the book's file, and empty ones in the module.
  const single = result.families.every(({ part }) => !part);
  const rows = here.filter(({ method }) => peers.some(({ id }) => id === method));
  const timed = peers
    .filter(({ id }) => rows.some(({ method }) => method === id))
    .map(({ part, ...peer }) => (single || part === undefined ? peer : { ...peer, part }));
  return {
    ...result,
    methods: [...result.methods, ...timed],
    results: [...result.results, ...rows],
  };
}

/** Without what withPeers has added. */
export function withoutPeers(result: LadderResult): LadderResult {
  const methods = result.methods.filter(({ peer }) => !peer);
  if (methods.length === result.methods.length) return result;
  const results = result.results.filter(({ method }) => methods.some(({ id }) => id === method));
  return { ...result, methods, results };
}

/** The ladders of one question each that this one consists of. */
export function partsOf(result: LadderResult): readonly LadderResult[] {
  const questions = [...new Set(result.families.map(({ part }) => part))];
  if (questions.length < 2) return [result];
  return questions.map((question) => {
    const families = result.families.filter(({ part }) => part === question);
    const methods = result.methods.filter(({ part }) => part === question);
    const results = result.results.filter(({ family }) => families.some(({ id }) => id === family));
    return { ...result, question: question ?? "", families, methods, results };
  });
}
