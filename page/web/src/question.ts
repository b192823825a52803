// A question: its key from the script that the build writes, its texts (HTML) from the fallback.

interface Common {
  /** "02_triangles/beta-sign" */
  readonly id: string;
  readonly text: string;
  readonly explain: string;
  readonly wrong?: readonly Wrong[];
}

interface Wrong {
  readonly answer: unknown;
  readonly why: string;
}

/** A number that is asked for. */
export interface NumberKey {
  readonly answer: number;
  readonly unit: string;
  readonly tolerance: number;
  /** False: the number must be given in this very unit. */
  readonly convert?: boolean;
  readonly wrong?: readonly Wrong[];
}

export interface Predict extends Common, NumberKey {
  readonly kind: "predict";
}

export interface Complete extends Common {
  readonly kind: "complete";
  /** HTML of the steps or the table; the gap called `id` is an element of class `gap-id`. */
  readonly lines: string;
  readonly gaps: readonly (NumberKey & { readonly id: string; readonly label: string })[];
}

export interface SayWhy extends Common {
  readonly kind: "say-why";
  /** HTML of what a good answer says; `explain` is the model answer. */
  readonly criteria: readonly string[];
}

export interface Choose extends Common {
  readonly kind: "choose";
  readonly options: readonly string[];
  readonly answer: number;
}

export interface Order extends Common {
  readonly kind: "order";
  readonly items: readonly string[];
  readonly answer: readonly number[];
}

export interface Construct extends Common {
  readonly kind: "construct";
  /** The figure on this page, and its output that is at least 1 when the construction is right. */
  readonly figure: string;
  readonly goal: string;
}

export type Question = Predict | Choose | Order | Construct | Complete | SayWhy;
