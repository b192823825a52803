// The figure's C++ as the page sees it: named fields of doubles in, named fields of doubles out.

export interface Field {
  readonly name: string;
  readonly size: number;
}

export interface Layout {
  readonly inputs: readonly Field[];
  readonly outputs: readonly Field[];
  /** What to say for each value of the output `problem`; the first is for none. */
  readonly problems: readonly string[];
}

export type FieldValue = number | readonly number[];
export type Fields = Readonly<Record<string, FieldValue>>;

/** The C++ of a figure, ready to run. */
export interface Engine {
  readonly layout: Layout;
  /** Throws if the C++ stops in the middle; `ready` tells when it can be asked again. */
  compute(input: Fields): Fields;
  ready(): Promise<void>;
}

/** The numbers of a struct, flat, in the order of its fields. */
export function flatten(fields: readonly Field[], values: Fields): number[] {
  return fields.flatMap(({ name, size }) => {
    const value = values[name];
    const list = typeof value === "number" ? [value] : (value ?? []);
    if (list.length !== size) throw new Error(`field ${name} takes ${size} numbers`);
    return [...list];
  });
}

/** The fields of a struct from its flat numbers. Asking for another field is an error. */
export function unflatten(fields: readonly Field[], numbers: ArrayLike<number>): Fields {
  const values: Record<string, FieldValue> = {};
  let next = 0;
  for (const { name, size } of fields) {
    const list = Array.from({ length: size }, () => numbers[next++] ?? Number.NaN);
    values[name] = size === 1 ? (list[0] ?? Number.NaN) : list;
  }
  return strict(values);
}

/** A misspelt output must not read as `undefined` and quietly draw nothing. */
function strict(values: Record<string, FieldValue>): Fields {
  return new Proxy(values, {
    get(target, name) {
      if (typeof name === "string" && !(name in target) && name !== "toJSON" && name !== "then")
        throw new Error(`the figure's C++ has no field ${name}`);
      return Reflect.get(target, name);
    },
  });
}
