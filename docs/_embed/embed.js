// For the page around embedded parts of Contact Hours: gives each of their frames the height of its
// content. A message counts only from a frame of this page that shows a page of this script's origin.
{
  const { origin } = new URL(document.currentScript.src);
  const TALLEST = 20000;

  const frameOf = (source) =>
    [...document.querySelectorAll("iframe")].find((frame) => frame.contentWindow === source);

  addEventListener("message", (event) => {
    if (event.origin !== origin || event.data?.type !== "contact-embed") return;
    const height = Number(event.data.height);
    const frame = frameOf(event.source);
    if (!frame || !(height > 0 && height <= TALLEST)) return;
    // With the frame's border, if its box includes it.
    const whole = getComputedStyle(frame).boxSizing === "border-box";
    const border = whole ? frame.offsetHeight - frame.clientHeight : 0;
    frame.style.height = `${Math.ceil(height) + border}px`;
  });

  // Those that were loaded before this script have told their height already.
  const ask = () => {
    for (const frame of document.querySelectorAll("iframe"))
      if (frame.src.startsWith(`${origin}/`))
        frame.contentWindow?.postMessage({ type: "contact-embed?" }, origin);
  };
  if (document.readyState === "loading") addEventListener("DOMContentLoaded", ask);
  else ask();
}
