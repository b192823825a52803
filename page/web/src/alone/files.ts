// The files of an exercise saved as one file (save.ts): each is a <script type="text/plain" data-file="…"> with its bytes in
// base64, named by its path in …/_static/contact/. They are answered for wherever the checker asks for them: by
// fetch(), in the browser's cache, and as scripts of workers. What is not in the file comes from the book's server.

const PIECE = 1 << 20; // base64 letters, a multiple of four

/** The bytes that base64 stands for. */
export function decoded(text: string): Uint8Array<ArrayBuffer> {
  const padding = text.endsWith("==") ? 2 : text.endsWith("=") ? 1 : 0;
  const bytes = new Uint8Array((text.length / 4) * 3 - padding);
  for (let at = 0, to = 0; at < text.length; at += PIECE) {
    const piece = atob(text.slice(at, at + PIECE));
    for (let i = 0; i < piece.length; i += 1) bytes[to++] = piece.charCodeAt(i);
  }
  return bytes;
}

/**
 * The part of a worker's script that comes first: where it finds what the page has. The files come as the first message,
 * because in a page that was opened from a file a worker may not fetch a blob: address.
 */
const before = (names: Readonly<Record<string, string>>): string => `{
Object.assign(globalThis,${JSON.stringify(names)});
let files=new Map;
const take=(event)=>{removeEventListener("message",take);if(!(event.data instanceof Map))return;files=event.data;event.stopImmediatePropagation()};
addEventListener("message",take);
const store={match:async(at)=>files.has(at)?new Response(files.get(at)):undefined,put:async()=>{},delete:async()=>false,keys:async()=>[]};
Object.defineProperty(globalThis,"caches",{value:{open:async()=>store}});
}
`;

/** @param base the address of …/_static/contact/ at the book's server */
export function useFiles(base: string): void {
  const blobs = new Map<string, Blob>();
  let contactProgram = "";
  for (const script of document.querySelectorAll<HTMLScriptElement>("script[data-file]")) {
    const address = new URL(script.dataset["file"] ?? "", base).href;
    const bytes = decoded(script.textContent ?? "");
    blobs.set(address, new Blob([bytes]));
    if (address.endsWith("/program-worker.js")) contactProgram = new TextDecoder().decode(bytes);
    script.remove();
  }
  const { host } = new URL(base);
  const forCompiler = new Map([...blobs].filter(([address]) => address.startsWith(`${base}cpp/`)));

  const network = globalThis.fetch.bind(globalThis);
  const at = (input: RequestInfo | URL) =>
    blobs.get(input instanceof Request ? input.url : new URL(input, document.baseURI).href);
  globalThis.fetch = async (input, init) => {
    const kept = at(input);
    return kept ? new Response(kept) : network(input, init);
  };
  const store = {
    match: async (address: string) => (blobs.has(address) ? new Response(at(address)) : undefined),
    put: async () => {},
    delete: async () => false,
    keys: async () => [],
  };
  Object.defineProperty(globalThis, "caches", { value: { open: async () => store } });

  const script = (name: string, names: Readonly<Record<string, string>>): string | undefined => {
    const code = blobs.get(`${base}${name}.js`);
    const parts = code && [before(names), code];
    return parts && URL.createObjectURL(new Blob(parts, { type: "text/javascript" }));
  };
  const saved = { contactSavedFrom: host };
  Object.assign(globalThis, saved);
  const workers = new Map([
    [`${base}compile-worker.js`, script("compile-worker", saved)],
    [`${base}run-worker.js`, script("run-worker", { ...saved, contactProgram })],
  ]);
  const Native = globalThis.Worker;
  globalThis.Worker = class extends Native {
    constructor(address: string | URL) {
      // No module: a browser lets a page that was opened from a file import nothing.
      super(workers.get(String(address)) ?? address);
      if (String(address) === `${base}compile-worker.js`) this.postMessage(forCompiler);
    }
  };
}
