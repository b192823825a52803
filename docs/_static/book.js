// On every page, and not a module, so that it also runs in a page that was opened from a file.
{
  // A listing that is wider than the page can be reached and scrolled from the keyboard.
  const reach = () => {
    for (const pre of document.querySelectorAll("div.highlight > pre")) {
      if (pre.scrollWidth > pre.clientWidth) pre.tabIndex = 0;
      else pre.removeAttribute("tabindex");
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
    const name = location.hash.slice(1);
    const target =
      name && (document.getElementById(name) ?? document.getElementById(decodeURI(name)));
    if (!target?.closest("details.deeper:not([open])")) return;
    openAround(target);
    target.scrollIntoView();
  };
  addEventListener("hashchange", openAddress);
  openAddress();
  addEventListener("load", () => {
    // What Sphinx's search marked.
    for (const word of document.querySelectorAll("details.deeper .highlighted")) openAround(word);
  });
  let closedOnScreen = [];
  addEventListener("beforeprint", () => {
    closedOnScreen = [...document.querySelectorAll("details.deeper:not([open])")];
    for (const box of closedOnScreen) box.open = true;
  });
  addEventListener("afterprint", () => {
    for (const box of closedOnScreen) box.open = false;
  });
  document.addEventListener("toggle", reach, true);

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
  if (location.protocol.startsWith("http") && "serviceWorker" in navigator) {
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
