// A question: its key from the script that the build writes, its texts (HTML) from the fallback.

interface Common {
  /** "02_triangles/beta-sign" */
  readonly id: string;
  readonly text: string;
  readonly explain: string;
  readonly wrong?: readonly { readonly answer: unknown; readonly why: string }[];
}

export interface Predict extends Common {
  readonly kind: "predict";
  readonly answer: number;
  readonly unit: string;
  readonly tolerance: number;
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

export type Question = Predict | Choose | Order | Construct;
