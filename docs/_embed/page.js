// On every page to embed, before its content: the theme that the address asks for, and the height
// for the page around it. In a window of its own it offers the HTML to embed it with.
{
  const asked = new URLSearchParams(location.search).get("theme");
  const theme = asked === "light" || asked === "dark" ? asked : "auto";
  document.body.dataset.theme = theme;
  if (theme !== "auto") document.documentElement.style.colorScheme = theme;

  const inFrame = parent !== window;
  // A number tells nothing, so any page may have it.
  const tell = () => {
    const height = Math.ceil(document.body.getBoundingClientRect().height);
    if (height > 0) parent.postMessage({ type: "contact-embed", height }, "*");
  };
  if (inFrame) {
    new ResizeObserver(tell).observe(document.body);
    // embed.js may have been loaded after this page.
    addEventListener("message", ({ source, data }) => {
      if (source === parent && data?.type === "contact-embed?") tell();
    });
  }

  // An exercise as one file: two buttons, because the compiler is most of it.
  const offerFile = () => {
    const words = document.createElement("p");
    words.className = "file";
    words.textContent =
      "Or save it as one HTML file, for a disk or a course’s files. With the compiler (about 60 MB) it needs no network.";
    const status = document.createElement("span");
    status.setAttribute("role", "status");
    const save = async (compiler) => {
      status.textContent = "The file is being made …";
      try {
        const { fileOf } = await import(
          new URL("../_static/contact/alone/save.js", document.baseURI).href
        );
        const file = await fileOf(location.origin + location.pathname, compiler);
        const link = document.createElement("a");
        link.href = URL.createObjectURL(file);
        link.download = location.pathname.split("/").pop();
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
        status.textContent = `Saved: ${(file.size / 1e6).toFixed(1)} MB.`;
      } catch (error) {
        console.warn(error);
        status.textContent = "The file could not be made: a part of the book could not be loaded.";
      }
    };
    const buttons = [
      ["Save with the compiler", true],
      ["Save without it", false],
    ].map(([label, compiler]) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = label;
      button.addEventListener("click", () => void save(compiler));
      return button;
    });
    return [words, ...buttons, status];
  };

  const offer = () => {
    const folder = new URL("../embed/", document.baseURI);
    const address = location.origin + location.pathname + location.search + location.hash;
    const quoted = (text) => text.replaceAll("&", "&amp;").replaceAll('"', "&quot;");
    const from = document.querySelector(".from");
    const code = document.createElement("textarea");
    code.readOnly = true;
    code.spellcheck = false;
    code.setAttribute("aria-label", "The HTML to embed this");
    const write = () => {
      // As high as the frame will be, with the padding below the last line.
      const height = Math.ceil(from.getBoundingClientRect().bottom + scrollY) + 12;
      code.value =
        `<iframe src="${quoted(address)}" title="${quoted(document.title)}"\n` +
        `  style="width: 100%; height: ${height}px; border: 0" allow="clipboard-write" loading="lazy"></iframe>\n` +
        `<script src="${folder.href}embed.js" async></` +
        "script>";
    };
    // A figure is another height when it is live.
    new ResizeObserver(write).observe(document.querySelector("article"));
    write();
    code.addEventListener("focus", () => code.select());
    const words = document.createElement("p");
    const more = document.createElement("a");
    more.href = "../embed.html";
    more.textContent = "Moodle, Canvas, Quarto and a page of your own";
    words.append("To show this in a page of your own, copy this HTML into it. How to: ", more, ".");
    const status = document.createElement("span");
    status.setAttribute("role", "status");
    const copy = document.createElement("button");
    copy.type = "button";
    copy.textContent = "Copy";
    copy.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(code.value);
        status.textContent = "Copied.";
      } catch {
        code.focus();
        status.textContent = "Copy the selected text.";
      }
    });
    const box = document.createElement("aside");
    box.className = "into";
    box.setAttribute("aria-label", "To embed this");
    box.append(words, code, copy, status);
    if (document.querySelector("contact-exercise")) box.append(...offerFile());
    document.querySelector(".content").append(box);
  };
  if (!inFrame && location.protocol.startsWith("http")) addEventListener("load", () => offer());
}
