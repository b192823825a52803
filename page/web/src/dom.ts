// Making elements without a framework.

type Child = Node | string;

export function html<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Record<string, string> = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

export function button(label: string, pressed: () => void, className = ""): HTMLButtonElement {
  const element = html("button", { type: "button" }, label);
  if (className) element.className = className;
  element.addEventListener("click", pressed);
  return element;
}

/** A name with a subscript after `_`: italic as a variable, unless it is a word. */
export function symbol(name: string, className = ""): HTMLElement {
  const word = /[A-Za-z]{3}/.test(name);
  const classes = [word ? "word" : "", className].filter(Boolean).join(" ");
  const element = html(word ? "span" : "var", classes ? { class: classes } : {});
  for (const part of name.split(/(_[A-Za-z0-9]+)/)) {
    if (part.startsWith("_")) element.append(html("sub", {}, part.slice(1)));
    else if (part) element.append(part);
  }
  return element;
}

/** Calls at most once a frame, whatever is asked in between. */
export function onceAFrame(work: () => void): () => void {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      work();
    });
  };
}

let last = 0;
/** An id that no other element of the page has. */
export function freshId(stem: string): string {
  last += 1;
  return `contact-${stem}-${last}`;
}
