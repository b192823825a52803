// Packs a tree of files as the compiler's own unpacker wants it: names of at most 100 bytes, folders before what is
// in them and without a slash at the end, everything of one date, so that the same files give the same bytes.

/** @typedef {import('./compiler.mjs').Tree} Tree */

/** @param {string} name @param {number} size @param {'0' | '5'} type a file or a folder */
function header(name, size, type) {
  if (Buffer.byteLength(name) > 100) throw new Error(`too long a name for the tar: ${name}`);
  const block = Buffer.alloc(512);
  const octal = (/** @type {number} */ number, /** @type {number} */ digits) =>
    `${number.toString(8).padStart(digits, "0")}\0`;
  block.write(name, 0);
  block.write(octal(0o644, 7), 100);
  block.write(octal(0, 7), 108);
  block.write(octal(0, 7), 116);
  block.write(octal(size, 11), 124);
  block.write(octal(0, 11), 136);
  block.write(" ".repeat(8), 148);
  block.write(type, 156);
  block.write("ustar\x0000", 257);
  const sum = block.reduce((total, byte) => total + byte, 0);
  block.write(`${octal(sum, 6)} `, 148);
  return block;
}

/** @param {Tree} tree @returns {Uint8Array} */
export function tar(tree) {
  /** @type {Uint8Array[]} */
  const blocks = [];
  const walk = (/** @type {Tree} */ folder, /** @type {string} */ prefix) => {
    for (const name of Object.keys(folder).sort()) {
      const entry = folder[name];
      const full = prefix + name;
      if (entry instanceof Uint8Array || typeof entry === "string") {
        const bytes = typeof entry === "string" ? new TextEncoder().encode(entry) : entry;
        blocks.push(header(full, bytes.length, "0"), bytes);
        if (bytes.length % 512 > 0) blocks.push(Buffer.alloc(512 - (bytes.length % 512)));
      } else if (entry) {
        blocks.push(header(full, 0, "5"));
        walk(entry, `${full}/`);
      }
    }
  };
  walk(tree, "");
  blocks.push(Buffer.alloc(1024));
  return new Uint8Array(Buffer.concat(blocks));
}
