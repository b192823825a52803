// A WebAssembly module that esbuild puts into the script.
declare module "*.wasm" {
  const bytes: Uint8Array<ArrayBuffer>;
  export default bytes;
}

// Its package has types, under a name that TypeScript does not look for.
declare module "*/Box2D.compat.mjs" {
  type Types =
    typeof import("../../../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.d.ts");
  const make: Types["default"];
  export default make;
}
