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
