// A ladder's measurements, as `contact ladder` writes them and the page makes them.

export interface LadderFamily {
  readonly id: string;
  readonly title: string;
  readonly n?: number;
}

export interface LadderMethod {
  readonly id: string;
  readonly title: string;
  readonly scalar: string;
  readonly exact: boolean;
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
}

export interface LadderResult {
  readonly ladder: string;
  readonly question: string;
  readonly families: readonly LadderFamily[];
  readonly methods: readonly LadderMethod[];
  readonly results: readonly LadderRow[];
}

/** From the page's worker: one row each, then the end. */
export type WorkerMessage =
  | { readonly kind: "row"; readonly row: LadderRow; readonly done: number; readonly of: number }
  | { readonly kind: "end"; readonly seconds: number }
  | { readonly kind: "error"; readonly message: string };

export function methodName({ title, scalar }: LadderMethod): string {
  return title.toLowerCase().includes(scalar.toLowerCase()) ? title : `${title}, ${scalar}`;
}
