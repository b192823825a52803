// Makes a linked module smaller: Binaryen sees the whole of it, which neither the compiler nor the linker does. It
// keeps what each operation computes, to the bit: nothing here allows it to reorder floating-point arithmetic.
import binaryen from "binaryen";

/** What clang's generic processor has, and every browser that the book names. */
const { BulkMemory, BulkMemoryOpt, ExceptionHandling, Multivalue } = binaryen.Features;
const { MutableGlobals, NontrappingFPToInt, ReferenceTypes, SignExt } = binaryen.Features;
const features =
  BulkMemory |
  BulkMemoryOpt |
  ExceptionHandling |
  Multivalue |
  MutableGlobals |
  NontrappingFPToInt |
  ReferenceTypes |
  SignExt;

/** @param {Uint8Array} bytes @returns {Uint8Array} */
export function shrunk(bytes) {
  const module = binaryen.readBinary(bytes);
  try {
    module.setFeatures(features);
    binaryen.setOptimizeLevel(2);
    binaryen.setShrinkLevel(2);
    module.optimize();
    return module.emitBinary();
  } finally {
    module.dispose();
  }
}
