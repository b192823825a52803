// On every page, and not a module, so that it also runs in a page that was opened from a file.
{
  // A listing that is wider than the page can be reached and scrolled from the keyboard.
  const reach = () => {
    for (const pre of document.querySelectorAll("div.highlight > pre")) {
      if (pre.scrollWidth > pre.clientWidth) {
        pre.tabIndex = 0;
        pre.setAttribute("role", "group");
        pre.setAttribute("aria-label", "Listing, scrolls sideways");
      } else for (const name of ["tabindex", "role", "aria-label"]) pre.removeAttribute(name);
    }
  };
  addEventListener("resize", reach);
  document.fonts.ready.then(reach);
  reach();

  // A Deeper box opens where an address, a search or the printer leads into it.
  const openAround = (node) => {
    for (
      let box = node?.closest("details.deeper");
      box;
      box = box.parentElement.closest("details.deeper")
    )
      box.open = true;
  };
  const openAddress = () => {
    const target = document.getElementById(location.hash.slice(1));
    if (!target?.closest("details.deeper:not([open])")) return;
    openAround(target);
    target.scrollIntoView();
  };
  addEventListener("hashchange", openAddress);
  openAddress();
  // Sphinx's search marks words a moment after the page is there.
  const openMarked = () => {
    for (const word of document.querySelectorAll("details.deeper .highlighted")) openAround(word);
  };
  addEventListener("load", () => setTimeout(openMarked, 100));
  let closedOnScreen = [];
  addEventListener("beforeprint", () => {
    closedOnScreen = [...document.querySelectorAll("details.deeper:not([open])")];
    for (const box of closedOnScreen) box.open = true;
  });
  addEventListener("afterprint", () => {
    for (const box of closedOnScreen) box.open = false;
  });
  document.addEventListener("toggle", reach, true);

  // A linked term shows its definition when it is pointed at, focused or tapped.
  const definitions = new Map();
  for (const node of document.querySelectorAll(".definitions > .definition"))
    for (const name of node.dataset.terms.split(" ")) definitions.set(name, node);
  /** The link whose definition is shown, and the box that shows it. */
  let shown;
  let waiting = 0;
  const hideTerm = () => {
    clearTimeout(waiting);
    shown?.box.remove();
    shown?.link.removeAttribute("aria-describedby");
    shown = undefined;
  };
  const hideSoon = () => {
    clearTimeout(waiting);
    waiting = setTimeout(hideTerm, 200);
  };
  const stay = () => clearTimeout(waiting);
  const showTerm = (link, definition) => {
    stay();
    // A term in a definition leads to its entry as any link does.
    if (shown?.link === link || link.closest(".term-shown")) return;
    hideTerm();
    const box = document.createElement("div");
    box.className = "term-shown";
    const words = definition.cloneNode(true);
    words.id = "term-shown";
    const entry = document.createElement("p");
    entry.className = "entry";
    const there = document.createElement("a");
    there.href = link.href;
    there.textContent = "In the glossary";
    entry.append(there);
    box.append(words, entry);
    box.addEventListener("pointerenter", stay);
    box.addEventListener("pointerleave", hideSoon);
    // In the article, for its fonts; what it stands on scrolls with it.
    const paper = link.closest("article");
    paper.append(box);
    const at = link.getClientRects()[0];
    const width = document.documentElement.clientWidth;
    const left = Math.max(8, Math.min(at.left, width - box.offsetWidth - 8));
    const above = at.bottom + box.offsetHeight + 8 > innerHeight && at.top > box.offsetHeight + 60;
    const from = (box.offsetParent ?? document.documentElement).getBoundingClientRect();
    box.style.left = `${left - from.left}px`;
    box.style.top = `${(above ? at.top - box.offsetHeight - 4 : at.bottom + 4) - from.top}px`;
    link.setAttribute("aria-describedby", "term-shown");
    shown = { link, box };
  };
  // Asked of the document, because questions and exercises write their links anew.
  const termAt = (target) => {
    const link = target instanceof Element && target.closest("article a:has(> .std-term)");
    return link && definitions.has(link.hash.slice(1)) ? link : undefined;
  };
  const definitionOf = (link) => definitions.get(link.hash.slice(1));
  document.addEventListener("pointerover", ({ target, pointerType }) => {
    const link = termAt(target);
    if (!link || pointerType !== "mouse") return;
    stay();
    if (shown?.link !== link) waiting = setTimeout(() => showTerm(link, definitionOf(link)), 150);
  });
  document.addEventListener("pointerout", ({ target, pointerType }) => {
    if (termAt(target) && pointerType === "mouse") hideSoon();
  });
  document.addEventListener("focusin", ({ target }) => {
    const link = termAt(target);
    if (link?.matches(":focus-visible")) showTerm(link, definitionOf(link));
  });
  document.addEventListener("focusout", ({ target }) => {
    if (termAt(target)) hideSoon();
  });
  document.addEventListener("click", (event) => {
    const link = termAt(event.target);
    if (!link || event.pointerType !== "touch" || link.closest(".term-shown")) return;
    event.preventDefault();
    showTerm(link, definitionOf(link));
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hideTerm();
  });
  document.addEventListener("pointerdown", (event) => {
    if (shown && !shown.box.contains(event.target) && !shown.link.contains(event.target))
      hideTerm();
  });

  // On the search page: what is shown of a find is the paragraph or the entry that its address names. Sphinx shows the
  // named element alone, which is empty if it is a place in the index.
  if (typeof Search !== "undefined")
    Search.htmlToText = (html, anchor) => {
      const page = new DOMParser().parseFromString(html, "text/html").querySelector("[role=main]");
      const noise = ".headerlink, script, style, .katex-html, annotation, .definitions";
      for (const node of page?.querySelectorAll(noise) ?? []) node.remove();
      const named = anchor ? page?.querySelector(anchor) : undefined;
      const block = named?.closest("p, li, dt, dd, td, details, section");
      const entry = block?.matches("dt")
        ? block.parentElement.querySelector(`${anchor} ~ dd`)
        : null;
      return [block ?? page, entry]
        .map((node) => node?.textContent ?? "")
        .join(" ")
        .trim();
    };

  /** The site's root, as the page names it. */
  const root = new URL(document.documentElement.dataset.content_root ?? "./", document.baseURI);

  // Keeps what is read, so that it can be read again offline (page/web/src/offline/sw.ts).
  const keep = async () => {
    const workers = navigator.serviceWorker;
    const early = workers.controller !== null;
    await workers.register(new URL("sw.js", root));
    const { active } = await workers.ready;
    if (early) return;
    // The worker has not seen this page being loaded, nor what is still on its way to it.
    new PerformanceObserver((list) => {
      const addresses = list.getEntries().map(({ name }) => name);
      active.postMessage({ kind: "visited", addresses });
    }).observe({ type: "resource", buffered: true });
  };
  // A page to embed is not kept: it has nothing that its lesson does not have.
  const alone = document.body.classList.contains("embedded");
  if (!alone && location.protocol.startsWith("http") && "serviceWorker" in navigator) {
    const quietly = () => keep().catch(() => {});
    if (document.readyState === "complete") quietly();
    else addEventListener("load", quietly);
  }

  // A browser runs no module and fetches nothing for a page that was opened from a file.
  if (location.protocol === "file:") {
    const note = document.createElement("aside");
    note.className = "opened-from-file";
    note.setAttribute("aria-label", "Opened from a file");
    note.innerHTML = `<p><strong>This page was opened from a file.</strong> It shows the text and the
      pictures, but runs nothing: figures do not move, and questions and exercises are not checked,
      because browsers allow no scripts of this kind there.</p><p>In the project’s folder,
      <code>./contact serve</code> shows the book as it is meant. Any other web server does as well:
      in the folder of these pages, <code>python3 -m http.server</code>.</p>`;
    (document.querySelector("[role=main]") ?? document.body).prepend(note);
  }
}
