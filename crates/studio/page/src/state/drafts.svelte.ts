// Drafts: what no file holds yet, kept by the browser so that it is there again after a reload.

import type { Edit } from "../api/types";
import { engine } from "./engine.svelte";
import { server } from "./server.svelte";

/** What the browser keeps of an engine that is not saved. */
export interface Draft {
  text: string;
  /** Edits that are not in the text yet: the page went before the server had written them there. */
  edits: Edit[];
  /** Name of its file; `null`: none yet. */
  name: string | null;
  /** Name in place of a file that is not there yet. */
  untitled: string;
  /** The file that the changes began from. */
  revision: string | null;
  /** When it was kept [ms since 1970]. */
  at: number;
}

const DRAFT = "lanchester-draft:";
/** Key of the draft that this window has in hand: a reload keeps it, another window has its own. */
const HELD = "lanchester-draft-held";
/** A draft is written when nothing has changed for so long [ms]. */
const RESTS = 300;

/** Where a draft is kept: by the folder of the studio and the name of the file. */
export function keyOf(folder: string, name: string | null): string {
  return `${DRAFT}${folder}\n${name ?? ""}`;
}

/** A draft as the browser kept it; `undefined` for what is none. */
export function kept(json: string | null): Draft | undefined {
  if (json === null) return undefined;
  try {
    const { text, edits, name, untitled, revision, at } = JSON.parse(json) as Partial<Draft>;
    if (typeof text !== "string" || typeof at !== "number") return undefined;
    return {
      text,
      edits: Array.isArray(edits) ? edits : [],
      name: typeof name === "string" ? name : null,
      untitled: typeof untitled === "string" ? untitled : "engine",
      revision: typeof revision === "string" ? revision : null,
      at,
    };
  } catch {
    return undefined;
  }
}

/** What becomes of a draft at the start: it is taken up where this window had it in hand and the file is still that of then; else it is offered. */
export function fate(draft: Draft, held: boolean, onDisk: { revision: string; text: string } | null) {
  if (onDisk && draft.text === onDisk.text && draft.edits.length === 0) return "useless";
  if (!held) return "offer";
  return draft.name === null || !onDisk || draft.revision === onDisk.revision ? "take" : "offer";
}

class Drafts {
  /** Changes that came back with the reload, until they are saved or let go. */
  restored = $state.raw<Draft>();
  /** A draft that waits for a decision; `newer`: the file changed since. */
  offered = $state.raw<{ draft: Draft; key: string; newer: boolean }>();
  #key = "";
  #started = $state(false);
  #timer: ReturnType<typeof setTimeout> | undefined;

  #folder(): string {
    return server.session?.folder ?? "";
  }

  /** Opens what the session has, with the draft that belongs to it; `false` where there is neither. */
  async start(): Promise<boolean> {
    const file = server.session?.file ?? null;
    const held = read(sessionStorage, HELD);
    const own = keyOf(this.#folder(), file?.name ?? null);
    const keys = [held ?? "", own, keyOf(this.#folder(), null)];
    for (const key of keys) {
      const draft = kept(read(localStorage, key));
      if (!draft || !key.startsWith(keyOf(this.#folder(), ""))) continue;
      const onDisk = draft.name === file?.name ? file : null;
      const what = fate(draft, key === held, onDisk);
      if (what === "useless") write(localStorage, key, null);
      else if (what === "offer")
        this.offered ??= { draft, key, newer: onDisk !== null && onDisk.revision !== draft.revision };
      else {
        await this.#take(draft, onDisk !== null);
        this.offered = undefined;
        this.begin();
        return true;
      }
    }
    if (file) await engine.open(file, file.text);
    this.begin();
    return file !== null;
  }

  /** Keeps what is typed from now on. */
  begin() {
    this.#key = this.#now();
    // A state from a link does not write over a draft that nobody was asked about.
    const draft = kept(read(localStorage, this.#key));
    if (draft && draft.text !== engine.text && draft.at !== this.restored?.at)
      this.offered ??= { draft, key: this.#key, newer: false };
    this.#started = true;
    engine.whenOpened(() => {
      // Whoever opened another engine was asked about the changes of this one.
      if (this.#started) this.#forget();
    });
  }

  #now(): string {
    return keyOf(this.#folder(), engine.file?.name ?? null);
  }

  /** To be called within an effect. */
  watch() {
    if (!this.#started) return;
    const { unsaved, text } = engine;
    const key = this.#now();
    if (key !== this.#key) this.#forget();
    this.#key = key;
    write(sessionStorage, HELD, key);
    clearTimeout(this.#timer);
    // What waits for a decision is not written over.
    if (this.offered?.key === key) return;
    if (!unsaved) this.#forget();
    else if (text !== "") this.#timer = setTimeout(() => this.#keep(), RESTS);
  }

  /** At once: the page may be on its way out. */
  flush() {
    if (this.#started && engine.unsaved && this.offered?.key !== this.#key) this.#keep();
  }

  #keep() {
    const draft: Draft = {
      text: engine.text,
      edits: engine.pending,
      name: engine.file?.name ?? null,
      untitled: engine.untitled,
      revision: engine.file?.revision ?? null,
      at: Date.now(),
    };
    write(localStorage, this.#key, JSON.stringify(draft));
  }

  #forget() {
    clearTimeout(this.#timer);
    if (this.offered?.key !== this.#key) write(localStorage, this.#key, null);
    this.restored = undefined;
  }

  async #take(draft: Draft, isFile: boolean) {
    const file = server.session?.file ?? null;
    if (isFile && file) {
      await engine.open(file, file.text);
      await this.#put(draft);
    } else await this.#open(draft);
    this.restored = draft;
  }

  async #put(draft: Draft) {
    await engine.set(draft.text, "Take up the draft", "draft");
    if (draft.edits.length > 0) await engine.edit(draft.edits, "Take up the draft", "draft");
  }

  /** As an engine without a file. */
  async #open(draft: Draft) {
    await engine.open(null, draft.text, draft.name?.replace(/\.toml$/, "") ?? draft.untitled);
    if (draft.edits.length > 0) await engine.edit(draft.edits, "Take up the draft");
  }

  /** Takes up what was offered, in place of what is open; undo brings back the text of its file. */
  async accept() {
    const { draft, key } = this.offered ?? {};
    if (!draft || !key) return;
    this.offered = undefined;
    const same = draft.name !== null && draft.name === engine.file?.name;
    write(localStorage, key, null);
    if (same) await this.#put(draft);
    else await this.#open(draft);
    this.restored = draft;
  }

  /** Lets a draft go: what was offered, or what came back. */
  async discard() {
    if (this.offered) {
      write(localStorage, this.offered.key, null);
      this.offered = undefined;
      return;
    }
    this.restored = undefined;
    const template = server.session?.templates[0];
    if (engine.file) await engine.set(engine.file.text, "Discard the draft");
    else if (template) await engine.open(null, template.text, template.name);
  }
}

function read(store: Storage, key: string): string | null {
  try {
    return store.getItem(key);
  } catch {
    return null;
  }
}

function write(store: Storage, key: string, value: string | null) {
  try {
    if (value === null) store.removeItem(key);
    else store.setItem(key, value);
  } catch {
    // Where the browser keeps nothing, drafts end with the page.
  }
}

export const drafts = new Drafts();
