// Loads what page/wasm/build.mjs made: figures and ladders. In a browser and in Node; no dependency.

/** Where a module comes from: an address, its bytes, or compiled already. */
export type Source = string | URL | BufferSource | WebAssembly.Module;

/** The C++ stopped in the middle of a call. The message is what it said last. */
export class Stopped extends Error {
  override readonly name = "Stopped";
}

interface Exports {
  readonly memory: WebAssembly.Memory;
  _initialize?(): void;
}

/** A module's instance, and a new one after it has stopped. */
export class Program<Functions> {
  readonly #module: WebAssembly.Module;
  #exports: Functions & Exports;
  #said = "";
  #stopped: Stopped | undefined;
  /** Done when the program can be called (again). */
  ready: Promise<void> = Promise.resolve();

  private constructor(module: WebAssembly.Module) {
    this.#module = module;
    this.#exports = undefined as never; // start() sets it before anyone has the program
  }

  static async start<Functions>(source: Source): Promise<Program<Functions>> {
    const program = new Program<Functions>(await compiled(source));
    await program.#restart();
    return program;
  }

  async #restart(): Promise<void> {
    const instance = await WebAssembly.instantiate(this.#module, this.#imports());
    this.#exports = instance.exports as unknown as Functions & Exports;
    this.#said = "";
    this.#exports._initialize?.();
    this.#stopped = undefined;
  }

  /**
   * Calls into the C++. If it stops (a throw, an assertion, a trap), that is a `Stopped` with the words it
   * printed; a fresh instance is then made, and calls until it is there fail likewise (see `ready`).
   */
  call<Result>(use: (functions: Functions & Exports) => Result): Result {
    if (this.#stopped) throw this.#stopped;
    this.#said = "";
    try {
      const result = use(this.#exports);
      if (this.#said !== "") console.warn(this.#said.trimEnd());
      return result;
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) throw error;
      this.#stopped = new Stopped(this.#said.trim() || error.message, { cause: error });
      // The stack of a stopped instance is where it stopped: it cannot be used again.
      this.ready = this.#restart();
      // If it does not even start, calls go on saying what stopped it.
      this.ready.catch(() => {});
      throw this.#stopped;
    }
  }

  /** The text at an address, up to its 0. */
  text(address: number): string {
    const bytes = new Uint8Array(this.#exports.memory.buffer, address);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  /** The doubles at an address, in place. Memory may move in a call: ask again after each. */
  numbers(address: number, count: number): Float64Array {
    return new Float64Array(this.#exports.memory.buffer, address, count);
  }

  /** What the C++ may ask of its host: the time, and to print. Anything else is "not supported". */
  #imports(): WebAssembly.Imports {
    const unsupported = 52;
    const imports: Record<string, Record<string, (...args: number[]) => number>> = {};
    for (const { module, name } of WebAssembly.Module.imports(this.#module)) {
      imports[module] ??= {};
      imports[module][name] = () => unsupported;
    }
    if (imports["env"]?.["now"]) imports["env"]["now"] = () => performance.now();
    const system = imports["wasi_snapshot_preview1"];
    if (system?.["fd_write"])
      system["fd_write"] = (_file, list = 0, count = 0, total = 0) =>
        this.#print(list, count, total);
    return imports;
  }

  #print(list: number, count: number, total: number): number {
    const { buffer } = this.#exports.memory;
    const view = new DataView(buffer);
    let length = 0;
    for (let i = 0; i < count; ++i) {
      const address = view.getUint32(list + 8 * i, true);
      const size = view.getUint32(list + 8 * i + 4, true);
      this.#said += new TextDecoder().decode(new Uint8Array(buffer, address, size));
      length += size;
    }
    view.setUint32(total, length, true);
    return 0;
  }
}

async function compiled(source: Source): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (typeof source !== "string" && !(source instanceof URL)) return WebAssembly.compile(source);
  const response = await fetch(source);
  if (!response.ok) throw new Error(`${String(source)}: ${response.status} ${response.statusText}`);
  // Not compileStreaming: a static host need not know the media type of WebAssembly.
  return WebAssembly.compile(await response.arrayBuffer());
}

export interface Field {
  readonly name: string;
  readonly size: number;
}

export interface FigureLayout {
  readonly inputs: readonly Field[];
  readonly outputs: readonly Field[];
  /** What to say for each value of the output `problem`; the first is for none. */
  readonly problems: readonly string[];
}

interface FigureFunctions {
  layout(): number;
  input(): number;
  output(): number;
  compute(): void;
}

export type Numbers = Readonly<Record<string, readonly number[]>>;

export interface Figure {
  readonly layout: FigureLayout;
  /** Every field with its numbers, flat. Throws `Stopped` if the C++ does not return. */
  compute(inputs: Numbers): Numbers;
  /** After a `Stopped`: resolves when `compute` can be called again. */
  ready(): Promise<void>;
}

export async function loadFigure(source: Source): Promise<Figure> {
  const program = await Program.start<FigureFunctions>(source);
  const layout = JSON.parse(
    program.text(program.call((figure) => figure.layout())),
  ) as FigureLayout;
  const total = (fields: readonly Field[]) => fields.reduce((sum, { size }) => sum + size, 0);
  return {
    layout,
    ready: () => program.ready,
    compute(inputs) {
      const given = layout.inputs.flatMap(({ name, size }) => {
        const numbers = inputs[name];
        if (numbers?.length !== size) throw new Error(`${name} takes ${size} numbers`);
        return numbers;
      });
      program
        .numbers(
          program.call((figure) => figure.input()),
          given.length,
        )
        .set(given);
      program.call((figure) => figure.compute());
      const place = program.call((figure) => figure.output());
      const result = program.numbers(place, total(layout.outputs));
      const outputs: Record<string, number[]> = {};
      let next = 0;
      for (const { name, size } of layout.outputs) {
        outputs[name] = [...result.subarray(next, next + size)];
        next += size;
      }
      return outputs;
    },
  };
}

/** A method that the page has in JavaScript: the ladder asks it in numbers and judges what it answers. */
export interface LadderPeer {
  readonly id: string;
  readonly title: string;
  readonly scalar: string;
  /** Numbers of a question. */
  readonly asks: number;
  /** Numbers of an answer. */
  readonly tells: number;
  readonly part: string;
}

export interface LadderLayout {
  readonly question: string;
  readonly families: readonly {
    readonly id: string;
    readonly title: string;
    /** The question, if the ladder has several: a method answers those of its part. */
    readonly part: string;
  }[];
  readonly methods: readonly {
    readonly id: string;
    readonly title: string;
    readonly scalar: string;
    readonly exact: boolean;
    readonly part: string;
  }[];
  readonly peers: readonly LadderPeer[];
}

/** A method's answers compared with the truth. */
export interface LadderJudgement {
  readonly n: number;
  readonly wrong: number;
  readonly undecided: number;
  /** NaN where the question has no value to be off by. */
  readonly error_median: number;
  readonly error_max: number;
}

export interface LadderResult extends LadderJudgement {
  readonly ns_median: number;
  readonly ns_q1: number;
  readonly ns_q3: number;
  readonly repeats: number;
}

interface LadderFunctions {
  layout(): number;
  prepare(family: number, n: number): void;
  pass(method: number): void;
  run(method: number): number;
  given(peer: number): number;
  questions(peer: number): number;
  answers(peer: number): number;
  judge(peer: number): number;
}

export interface Ladder {
  readonly layout: LadderLayout;
  /** Makes n inputs of the family with this number, and their true answers. */
  prepare(family: number, n: number): void;
  /** Answers each of them once. */
  pass(method: number): void;
  /** Times a method on them and compares its answers with the truth. */
  run(method: number): LadderResult;
  /** What the questions of the peer with this number refer to, such as meshes; often nothing. */
  given(peer: number): Float64Array;
  /** The inputs as the peer gets them. */
  questions(peer: number, n: number): Float64Array;
  /** Compares a peer's answers to all of them with the truth. */
  judge(peer: number, answers: Float64Array): LadderJudgement;
}

export async function loadLadder(source: Source): Promise<Ladder> {
  const program = await Program.start<LadderFunctions>(source);
  const layout = JSON.parse(
    program.text(program.call((ladder) => ladder.layout())),
  ) as LadderLayout;
  return {
    layout,
    prepare: (family, n) => program.call((ladder) => ladder.prepare(family, n)),
    pass: (method) => program.call((ladder) => ladder.pass(method)),
    run(method) {
      const place = program.call((ladder) => ladder.run(method));
      const [n, wrong, undecided, error_median, error_max, ns_median, ns_q1, ns_q3, repeats] = [
        ...program.numbers(place, 9),
      ] as [number, number, number, number, number, number, number, number, number];
      return { n, wrong, undecided, error_median, error_max, ns_median, ns_q1, ns_q3, repeats };
    },
    given(peer) {
      const place = program.call((ladder) => ladder.given(peer));
      const [size] = program.numbers(place, 1) as unknown as [number];
      return program.numbers(place, 1 + size).slice(1);
    },
    questions(peer, n) {
      const place = program.call((ladder) => ladder.questions(peer));
      return program.numbers(place, n * layout.peers[peer]!.asks).slice();
    },
    judge(peer, answers) {
      const room = program.call((ladder) => ladder.answers(peer));
      program.numbers(room, answers.length).set(answers);
      const place = program.call((ladder) => ladder.judge(peer));
      const [n, wrong, undecided, error_median, error_max] = [...program.numbers(place, 5)] as [
        number,
        number,
        number,
        number,
        number,
      ];
      return { n, wrong, undecided, error_median, error_max };
    },
  };
}
