// <contact-player name="20_scenes" base="…"><script type="application/json">{…}</script><img …></contact-player>
//
// The scene player. The picture inside is the fallback. When it comes near the window, its scene is
// loaded with C++ (WebAssembly) for scenes of this kind alone, and moves over the picture; if that
// fails, the picture stays. "Start the scene player" replaces it with the player and the same
// scene: only then are its script and its own, much larger C++ loaded.
//
// For other code on the page: `opening` (a promise, once it comes near), `ready` (the same, once the
// player is started), `model`, and the event `contact-change` after each picture of the player.

import { button, html } from "./dom.ts";
import { untilBuilt } from "./pending.ts";
import type { Opening } from "./scenes/opening-view.ts";
import type { Player } from "./scenes/player.ts";

/** What the page says of the scenes that can be picked. */
export interface SceneList {
  /** The one that is picked at first. */
  readonly first: string;
  readonly scenes: readonly { readonly name: string; readonly about: string }[];
}

export class ContactPlayer extends HTMLElement {
  #player: Player | undefined;
  #moving: Opening | undefined;
  /** Ends what waits for the opening. */
  readonly #started = new AbortController();
  #built = false;
  opening: Promise<void> | undefined;
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
    this.#openWhenNear(list);
  }

  disconnectedCallback(): void {
    this.#closeOpening();
    this.#player?.close();
  }

  get #base(): string {
    return new URL(this.getAttribute("base") ?? "./", document.baseURI).href;
  }

  /** Where the scenes are. */
  get #scenes(): string {
    return `${this.#base}scenes/${this.getAttribute("name")}/`;
  }

  async #untilBuilt(say: (words: string) => void, signal?: AbortSignal): Promise<void> {
    if (this.querySelector(":scope > .not-built"))
      await untilBuilt(`${this.getAttribute("name")}/scene_player`, this.#base, say, signal);
  }

  #openWhenNear(list: SceneList): void {
    const near = new IntersectionObserver(
      (entries) => {
        if (!entries.some((entry) => entry.isIntersecting)) return;
        near.disconnect();
        this.opening = this.#open(list);
        this.opening.catch((error: unknown) => {
          if (!this.#started.signal.aborted) console.warn("the player's opening scene:", error);
        });
      },
      { rootMargin: "300px" },
    );
    near.observe(this);
    this.#started.signal.addEventListener("abort", () => near.disconnect());
  }

  /** Shows the first scene moving, over its picture. */
  async #open(list: SceneList): Promise<void> {
    const { signal } = this.#started;
    const missing = this.querySelector<HTMLElement>(":scope > .not-built");
    await this.#untilBuilt((words) => {
      if (missing && missing.textContent !== words) missing.textContent = words;
    }, signal);
    const { Opening } = await import("./scenes/opening-view.ts");
    const scene = `${this.#scenes}${list.first}.json`;
    const opening = await Opening.load(scene, `${this.#base}scenes/opening.wasm`);
    if (signal.aborted) {
      opening.close();
      return;
    }
    this.#moving = opening;
    const picture = this.querySelector(":scope > :is(img, .not-built)");
    picture?.after(opening.element);
    // What is behind it is said by it.
    picture?.setAttribute("aria-hidden", "true");
    if (missing) missing.hidden = true;
    opening.shown();
  }

  #closeOpening(): void {
    this.#started.abort();
    this.#moving?.close();
    this.#moving = undefined;
    this.querySelector(":scope > img")?.removeAttribute("aria-hidden");
  }

  async #start(list: SceneList, say: (words: string) => void): Promise<void> {
    await this.#untilBuilt(say);
    const { Player } = await import("./scenes/player.ts");
    const player = new Player(list, this.#base, this.#scenes, () =>
      this.dispatchEvent(new CustomEvent("contact-change", { bubbles: true })),
    );
    await player.start();
    this.#player = player;
    this.#closeOpening();
    this.querySelector(":scope > .starting")?.remove();
    this.append(player.element);
    this.toggleAttribute("live", true);
    player.shown();
  }
}
