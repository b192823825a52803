// Keeps what a student's file defines from taking the place of something in the tests. In a WebAssembly object the
// linker knows everything by the names in its section "linking", and of two inline functions of one name it keeps
// one, whichever comes first. So what the tests define gets names here that no C++ has, in all their objects alike;
// only the agreed names stay. (Natively these symbols are made local: contact_seal in cmake/ContactExercises.cmake.)

/** The prefix of each name that must not be visible from outside. */
const prefix = "of the tests: ";

const kinds = { function: 0, data: 1, global: 2, section: 3, tag: 4, table: 5 };
const flags = { local: 0x2, undefined: 0x10, explicitName: 0x40 };
const parts = { comdats: 7, symbols: 8 };

class Reader {
  /** @param {Uint8Array} bytes */
  constructor(bytes, at = 0, end = bytes.length) {
    this.bytes = bytes;
    this.at = at;
    this.end = end;
  }
  get done() {
    return this.at >= this.end;
  }
  byte() {
    return /** @type {number} */ (this.bytes[this.at++]);
  }
  number() {
    let value = 0;
    for (let factor = 1; ; factor *= 128) {
      const byte = this.byte();
      value += (byte & 127) * factor;
      if (byte < 128) return value;
    }
  }
  /** @param {number} size */
  take(size) {
    const taken = this.bytes.subarray(this.at, this.at + size);
    this.at += size;
    return taken;
  }
  text() {
    return Buffer.from(this.take(this.number())).toString("utf8");
  }
  /** What follows, as long as the number before it says. */
  inner() {
    const size = this.number();
    const from = this.at;
    this.at += size;
    return new Reader(this.bytes, from, from + size);
  }
}

class Writer {
  /** @type {Uint8Array[]} */
  #pieces = [];
  /** @param {Uint8Array} piece */
  bytes(piece) {
    this.#pieces.push(piece);
    return this;
  }
  /** @param {number} value */
  byte(value) {
    return this.bytes(Uint8Array.of(value));
  }
  /** @param {number} value */
  number(value) {
    const digits = [];
    for (; value >= 128; value = Math.floor(value / 128)) digits.push((value % 128) + 128);
    return this.bytes(Uint8Array.from([...digits, value]));
  }
  /** @param {Uint8Array} content with its size before it */
  sized(content) {
    return this.number(content.length).bytes(content);
  }
  /** @param {string} value */
  text(value) {
    return this.sized(Buffer.from(value));
  }
  all() {
    return new Uint8Array(Buffer.concat(this.#pieces));
  }
}

/** The sections of an object: number, name if it is a custom one, and content.
 * @param {Uint8Array} object */
function* sections(object) {
  const reader = new Reader(object, 8);
  while (!reader.done) {
    const id = reader.byte();
    const content = reader.inner();
    const name = id === 0 ? new Reader(object, content.at, content.end).text() : "";
    yield { id, name, content };
  }
}

/** The names of what is imported, by kind and in order. @param {Uint8Array} object */
function imports(object) {
  /** @type {Map<number, string[]>} */
  const names = new Map();
  // How an import says what it is, and what a symbol calls that.
  const kindOf = [kinds.function, kinds.table, undefined, kinds.global, kinds.tag];
  for (const { id, content } of sections(object)) {
    if (id !== 2) continue;
    for (let left = content.number(); left > 0; --left) {
      content.text();
      const name = content.text();
      const sort = content.byte();
      const limits = () => {
        const bounded = content.number() & 1;
        content.number();
        if (bounded) content.number();
      };
      if (sort === 0) content.number();
      else if (sort === 1) {
        content.byte();
        limits();
      } else if (sort === 2) limits();
      else if (sort === 3) content.take(2);
      else {
        content.byte();
        content.number();
      }
      const kind = kindOf[sort];
      if (kind !== undefined) names.set(kind, [...(names.get(kind) ?? []), name]);
    }
  }
  return names;
}

/** @typedef {{ kind: number, flag: number, name: string | undefined, index: number, place: number[] }} Symbol
 *   `place` is where a data symbol lies */

/** @param {Reader} reader @param {Map<number, string[]>} imported @returns {Symbol} */
function readSymbol(reader, imported) {
  const kind = reader.byte();
  const flag = reader.number();
  const isDefined = (flag & flags.undefined) === 0;
  if (kind === kinds.data) {
    const name = reader.text();
    const place = isDefined ? [reader.number(), reader.number(), reader.number()] : [];
    return { kind, flag, name, index: 0, place };
  }
  const index = reader.number();
  if (kind === kinds.section) return { kind, flag, name: undefined, index, place: [] };
  const named = isDefined || (flag & flags.explicitName) !== 0;
  const name = named ? reader.text() : imported.get(kind)?.[index];
  if (name === undefined) throw new Error(`a symbol of kind ${kind} without a name`);
  return { kind, flag, name, index, place: [] };
}

/** @param {Writer} writer @param {Symbol} symbol @param {string | undefined} name its name from now on */
function writeSymbol(writer, symbol, name) {
  const renamed = name !== symbol.name && symbol.kind !== kinds.data;
  const isDefined = (symbol.flag & flags.undefined) === 0;
  const flag = renamed && !isDefined ? symbol.flag | flags.explicitName : symbol.flag;
  writer.byte(symbol.kind).number(flag);
  if (symbol.kind === kinds.data) {
    writer.text(String(name));
    for (const number of symbol.place) writer.number(number);
    return;
  }
  writer.number(symbol.index);
  if (symbol.kind === kinds.section) return;
  if (isDefined || (flag & flags.explicitName) !== 0) writer.text(String(name));
}

/** @param {Uint8Array} object @returns {Symbol[]} */
function symbols(object) {
  const imported = imports(object);
  for (const { name, content } of sections(object)) {
    if (name !== "linking") continue;
    content.text();
    content.number();
    while (!content.done) {
      const part = content.byte();
      const inside = content.inner();
      if (part !== parts.symbols) continue;
      return Array.from({ length: inside.number() }, () => readSymbol(inside, imported));
    }
  }
  throw new Error("this is not an object for the linker");
}

/** The names that an object defines for others. @param {Uint8Array} object @returns {Set<string>} */
export function definedNames(object) {
  const names = symbols(object)
    .filter(
      ({ kind, flag }) => kind !== kinds.section && (flag & (flags.undefined | flags.local)) === 0,
    )
    .map(({ name }) => String(name));
  return new Set(names);
}

/**
 * Renames what an object defines, and what it uses of the objects sealed with it.
 * @param {Uint8Array} object @param {Set<string>[]} others what those objects define
 * @param {string[]} keep the names that stay @returns {Uint8Array}
 */
export function sealed(object, others, keep) {
  const own = new Set([...definedNames(object), ...others.flatMap((names) => [...names])]);
  for (const name of keep) own.delete(name);
  const imported = imports(object);
  const writer = new Writer().bytes(object.subarray(0, 8));
  for (const { id, name, content } of sections(object)) {
    if (name === "name") continue; // for people; where objects were merged, the linker refuses its own
    const bytes = object.subarray(content.at, content.end);
    writer.byte(id).sized(name === "linking" ? linking(new Reader(bytes), own, imported) : bytes);
  }
  return writer.all();
}

/** @param {Reader} reader @param {Set<string>} own @param {Map<number, string[]>} imported */
function linking(reader, own, imported) {
  const writer = new Writer().text(reader.text()).number(reader.number());
  while (!reader.done) {
    const part = reader.byte();
    const inside = reader.inner();
    const changed = new Writer();
    if (part === parts.symbols) {
      const count = inside.number();
      changed.number(count);
      for (let i = 0; i < count; ++i) {
        const symbol = readSymbol(inside, imported);
        const { name, flag } = symbol;
        const hide = name !== undefined && own.has(name) && (flag & flags.local) === 0;
        writeSymbol(changed, symbol, hide ? prefix + name : name);
      }
    } else if (part === parts.comdats) {
      // Groups of which the linker keeps one of each name: everything inline that the tests define is in one.
      const count = inside.number();
      changed.number(count);
      for (let i = 0; i < count; ++i) {
        changed.text(prefix + inside.text()).number(inside.number());
        const members = inside.number();
        changed.number(members);
        for (let member = 0; member < members; ++member)
          changed.byte(inside.byte()).number(inside.number());
      }
    } else {
      changed.bytes(inside.bytes.subarray(inside.at, inside.end));
    }
    writer.byte(part).sized(changed.all());
  }
  return writer.all();
}
