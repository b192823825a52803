/** The compiler counts columns in bytes of UTF-8, from 1; the editor counts units of UTF-16, from 0. */
export function columnToOffset(line: string, column: number): number {
  let bytes = 1;
  let offset = 0;
  for (const character of line) {
    if (bytes >= column) break;
    const code = character.codePointAt(0)!;
    bytes += code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    offset += character.length;
  }
  return offset;
}
