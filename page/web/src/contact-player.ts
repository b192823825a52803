// <contact-player name="20_scenes" base="…"><script type="application/json">{…}</script><img …></contact-player>
//
// The scene player. The picture inside is the fallback; "Start the scene player" puts the player in
// its place. Only then are its script and its C++ (WebAssembly) loaded.
//
// For other code on the page: `ready` (a promise, once it is started), `model`, and the event
// `contact-change` after each picture.

import { button, html } from "./dom.ts";
import { untilBuilt } from "./pending.ts";
import type { Player } from "./scenes/player.ts";

/** What the page says of the scenes that can be picked. */
export interface SceneList {
  /** The one that is picked at first. */
  readonly first: string;
  readonly scenes: readonly { readonly name: string; readonly about: string }[];
}

export class ContactPlayer extends HTMLElement {
  #player: Player | undefined;
  #built = false;
  ready: Promise<void> = Promise.resolve();

  get model(): Player["model"] | undefined {
    return this.#player?.model;
  }

  connectedCallback(): void {
    const script = this.querySelector(':scope > script[type="application/json"]');
    if (this.#built || !script?.textContent) return;
    this.#built = true;
    const list = JSON.parse(script.textContent) as SceneList;
    const status = html("span", { class: "status", role: "status" });
    const start = button("Start the scene player", () => {
      start.disabled = true;
      status.textContent = "Loading …";
      this.ready = this.#start(list, (words) => {
        status.textContent = words;
      });
      this.ready.catch((error: unknown) => {
        console.warn("scene player:", error);
        start.disabled = false;
        status.textContent = "The scene player could not be loaded; this is a picture of it.";
      });
    });
    this.append(html("div", { class: "buttons starting" }, start, status));
  }

  disconnectedCallback(): void {
    this.#player?.close();
  }

  async #start(list: SceneList, say: (words: string) => void): Promise<void> {
    const base = new URL(this.getAttribute("base") ?? "./", document.baseURI).href;
    if (this.querySelector(".not-built"))
      await untilBuilt(`${this.getAttribute("name")}/scene_player`, base, say);
    const { Player } = await import("./scenes/player.ts");
    const scenes = `${base}scenes/${this.getAttribute("name")}/`;
    const player = new Player(list, base, scenes, () =>
      this.dispatchEvent(new CustomEvent("contact-change", { bubbles: true })),
    );
    await player.start();
    this.#player = player;
    this.querySelector(":scope > .starting")?.remove();
    this.append(player.element);
    this.toggleAttribute("live", true);
    player.shown();
  }
}
