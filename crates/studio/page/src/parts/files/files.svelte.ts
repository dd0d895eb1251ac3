// What is done with whole files: new, open, save, report, share; with the dialogs that it needs.

import { Gone, Refused, post, postForFile, transport } from "../../api/client";
import type { FileState, TemplateInfo } from "../../api/types";
import { engine } from "../../state/engine.svelte";
import { adopt, checked, current, link } from "../../state/link";
import { server } from "../../state/server.svelte";
import { view } from "../../state/view.svelte";
import { download } from "./download";

export type FileDialog =
  | { kind: "new" }
  | { kind: "open" }
  | { kind: "save-as" }
  | { kind: "unsaved"; then: () => void }
  | { kind: "removed"; name: string }
  | { kind: "conflict"; theirs: FileState };

/** A message stays for so long [ms]. */
const STAYS = 5000;

class Files {
  dialog = $state.raw<FileDialog | null>(null);
  /** What was done, or why not. */
  said = $state.raw<{ text: string; good: boolean } | null>(null);
  /** Why the name of "save as" does not do. */
  refusal = $state("");
  #then: (() => void) | undefined;
  #openings = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;

  say(text: string, good = true) {
    this.said = { text, good };
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => (this.said = null), STAYS);
  }

  /** Does `then` at once, or after the question whether to save first. */
  async guard(then: () => void) {
    await typed();
    if (engine.unsaved) this.dialog = { kind: "unsaved", then };
    else then();
  }

  async startNew(template: TemplateInfo) {
    this.dialog = null;
    view.speed = undefined;
    await engine.open(null, template.text, template.name);
  }

  async open(name: string) {
    const opening = ++this.#openings;
    await this.#try(async () => {
      const file = await post<FileState>("/api/file/open", { name });
      // Another one was picked meanwhile.
      if (opening !== this.#openings) return;
      server.onDisk = file;
      view.speed = undefined;
      await engine.open(file, file.text);
      this.dialog = null;
    });
  }

  /** An engine file or a state from anywhere on the computer, with the files that it names where no folder has them. */
  async openFromComputer(chosen: File[]) {
    const own = (file: File) => /\.(toml|json)$/.test(file.name);
    const beside = transport.keeps === "browser" ? chosen.filter((file) => !own(file)) : [];
    for (const file of beside) transport.keep(file.name, await file.text());
    const file = chosen.find((file) => !beside.includes(file));
    if (file) await this.#openOne(file);
    else {
      this.dialog = null;
      this.say(`Kept for engines that name it: ${beside.map((file) => file.name).join(", ")}`);
    }
  }

  async #openOne(file: File) {
    const text = await file.text();
    const state = checked(text);
    if (state) await adopt(state);
    else if (file.name.endsWith(".json")) {
      this.say(`${file.name} is no state of the studio: a file is needed that "Share" has written`, false);
      return;
    } else {
      view.speed = undefined;
      await engine.open(null, text, file.name.replace(/\.toml$/, ""));
    }
    this.dialog = null;
  }

  async save() {
    await typed();
    if (engine.file) await this.write();
    else this.saveAs();
  }

  saveAs() {
    this.dialog = { kind: "save-as" };
  }

  /** Lets a text go whose file is gone: another engine is picked in its place. */
  discard() {
    this.#then = undefined;
    this.dialog = { kind: "new" };
  }

  /** Saves and goes on with what the question was about. */
  saveFirst(then: () => void) {
    this.#then = then;
    this.dialog = null;
    void this.save();
  }

  async write(name?: string, over?: string | null) {
    this.refusal = "";
    const target = name ?? engine.file?.name ?? "";
    try {
      await engine.save(name, over);
      this.dialog = null;
      this.say(`Saved ${target}`);
      const then = this.#then;
      this.#then = undefined;
      then?.();
    } catch (error) {
      if (!(error instanceof Refused)) this.#complain(error);
      else if (error.problem.found === "removed") this.dialog = { kind: "removed", name: target };
      else if (error.problem.found !== null) await this.#conflict(target);
      else if (this.dialog?.kind === "save-as") this.refusal = sentence(error.problem);
      else this.#complain(error);
    }
  }

  /** The name is taken, or the file is another one than was read here. */
  async #conflict(name: string) {
    await this.#try(async () => {
      this.dialog = { kind: "conflict", theirs: await post<FileState>("/api/file/open", { name }) };
    });
  }

  close() {
    const dialog = this.dialog;
    this.dialog = null;
    this.refusal = "";
    this.#then = undefined;
    // The server goes on watching the file that is open here.
    if (dialog?.kind === "conflict" && engine.file && engine.file.name !== dialog.theirs.name)
      void post("/api/file/open", { name: engine.file.name }).catch(() => undefined);
  }

  async report() {
    await typed();
    await this.#try(async () => {
      const name = engine.file?.name ?? `${engine.untitled}.toml`;
      const page = await postForFile("/api/report", { text: engine.valid, name });
      download(page, name.replace(/\.toml$/, "") + ".html");
      this.say("The report is in your downloads");
    });
  }

  async copyLink() {
    await typed();
    try {
      await navigator.clipboard.writeText(await link());
      this.say(
        transport.keeps === "folder"
          ? "Link copied: it holds this very state, and stays on this computer's studio"
          : "Link copied: it holds this very state, for wherever this page opens",
      );
    } catch {
      this.say("The browser lets nothing be copied: download the state as a file instead", false);
    }
  }

  async saveFile() {
    await typed();
    const name = engine.file?.name ?? `${engine.untitled}.toml`;
    download(new Blob([engine.text], { type: "application/toml" }), name);
    this.say("The engine file is in your downloads");
  }

  async saveState() {
    await typed();
    const state = current();
    const name = state.name.replace(/\.toml$/, "") + ".state.json";
    download(new Blob([JSON.stringify(state, null, 1)], { type: "application/json" }), name);
    this.say("The state is in your downloads; Open reads it again");
  }

  async #try(act: () => Promise<void>) {
    try {
      await act();
    } catch (error) {
      this.#complain(error);
    }
  }

  #complain(error: unknown) {
    if (error instanceof Refused) this.say(sentence(error.problem), false);
    else if (error instanceof Gone) {
      server.lost();
      this.say("Not done: the studio's server does not answer", false);
    } else throw error;
  }
}

/** What is still being typed counts: fields hand it on when the focus leaves them. */
export function handOn() {
  const at = document.activeElement;
  if (at instanceof HTMLElement && at.matches("input, textarea")) {
    at.blur();
    at.focus({ preventScroll: true });
  }
}

async function typed() {
  handOn();
  await engine.settled();
}

function sentence(problem: { message: string; hint: string | null }): string {
  return problem.hint ? `${problem.message}. Hint: ${problem.hint}` : problem.message;
}

export const files = new Files();
