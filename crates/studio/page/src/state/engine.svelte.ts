// The engine being worked on: its file's text is the whole truth, and everything else follows from it.

import { Gone, Refused, post, put } from "../api/client";
import type { Edit, EngineSummary, FileState, Problem, Reading } from "../api/types";
import { server } from "./server.svelte";

/** Edits of one kind within this time are one step of undo [ms]. */
const ONE_STEP = 800;
const MOST_STEPS = 500;

interface Step {
  text: string;
  /** What was done, for the tooltip of undo. */
  what: string;
}

type Job = { edits?: Edit[]; text?: string; what: string; kind: string };

class EngineDocument {
  text = $state("");
  /** What the server read in `text`: mistakes, keys, the engine in short. */
  reading = $state.raw<Reading>();
  /** The last text that makes an engine: results belong to it. */
  valid = $state("");
  /** That engine in short. */
  summary = $state.raw<EngineSummary>();
  #past = $state.raw<Step[]>([]);
  #future = $state.raw<Step[]>([]);
  #kind = "";
  #at = 0;
  /** The file as it was when it was opened or saved. */
  file = $state.raw<FileState | null>(null);
  /** Name in place of a file that is not there yet. */
  untitled = $state("engine");
  problem = $state.raw<Problem>();

  dirty = $derived(this.text !== (this.file?.text ?? ""));
  /** Something would be lost with this text: an untouched template of the gallery would not. */
  unsaved = $derived(
    this.dirty &&
      this.text !== "" &&
      !(this.file === null && server.session?.templates.some((template) => template.text === this.text)),
  );
  undoes = $derived(this.#past.at(-1)?.what);
  redoes = $derived(this.#future.at(-1)?.what);
  /** Another program changed the file since it was opened or saved here. */
  changedOutside = $derived(
    this.file !== null &&
      server.onDisk !== null &&
      server.onDisk.name === this.file.name &&
      server.onDisk.revision !== this.file.revision &&
      server.onDisk.text !== this.text,
  );

  /** Another engine in place of this one; history starts anew. */
  async open(file: FileState | null, text: string, untitled = "engine") {
    this.file = file;
    this.untitled = untitled;
    this.#past = [];
    this.#future = [];
    this.text = text;
    await this.#do({ text, what: "open", kind: "" }, false);
    // A file without an engine has no results: those of the engine before are not its own.
    if (this.text === text && this.reading?.text === text && !this.reading.engine) {
      this.valid = "";
      this.summary = undefined;
    }
  }

  /** New text, as typed or as adopted from a result; `kind`: what belongs to one step of undo. */
  async set(text: string, what: string, kind = ""): Promise<void> {
    if (text === this.text) return;
    this.#remember(what, kind);
    this.text = text;
    await this.#do({ text, what, kind }, false);
  }

  /** Sets keys of the file, its comments kept; a value of `null` takes the key out. */
  async edit(edits: Edit[], what: string, kind = ""): Promise<void> {
    await this.#do({ edits, what, kind }, true);
  }

  /** The value of a key as it stands in the text; `undefined` where it does not. */
  value(path: string): unknown {
    return this.reading?.entries.find((entry) => entry.path === path)?.value;
  }

  undo() {
    this.#step(true);
  }

  redo() {
    this.#step(false);
  }

  #step(back: boolean) {
    const [from, to] = back ? [this.#past, this.#future] : [this.#future, this.#past];
    const step = from.at(-1);
    if (!step) return;
    const rest = from.slice(0, -1);
    const other = [...to, { text: this.text, what: step.what }];
    [this.#past, this.#future] = back ? [rest, other] : [other, rest];
    this.#kind = "";
    this.text = step.text;
    void this.#do({ text: step.text, what: step.what, kind: "" }, false);
  }

  #remember(what: string, kind: string) {
    const now = performance.now();
    const goesOn = kind !== "" && kind === this.#kind && now - this.#at < ONE_STEP;
    this.#kind = kind;
    this.#at = now;
    this.#future = [];
    if (!goesOn) this.#past = [...this.#past, { text: this.text, what }].slice(-MOST_STEPS);
  }

  // One request at a time; while it is under way only the newest job of each kind waits.
  #waiting: { job: Job; remember: boolean; done: () => void }[] = [];
  #running = false;

  constructor() {
    server.whenBack(() => void this.#run());
  }

  #do(job: Job, remember: boolean): Promise<void> {
    return new Promise((done) => {
      const replaced = (waiting: { job: Job }) =>
        (job.text !== undefined && waiting.job.text !== undefined) ||
        (job.kind !== "" && waiting.job.kind === job.kind);
      for (const waiting of this.#waiting.filter(replaced)) waiting.done();
      this.#waiting = this.#waiting.filter((waiting) => !replaced(waiting));
      this.#waiting.push({ job, remember, done });
      void this.#run();
    });
  }

  async #run() {
    if (this.#running) return;
    this.#running = true;
    for (;;) {
      const next = this.#waiting.shift();
      if (!next) break;
      const { job, remember, done } = next;
      const before = this.text;
      try {
        const body = { text: job.text ?? before, edits: job.edits ?? [] };
        const reading = await post<Reading>("/api/engine", body, "engine");
        // Text that was typed meanwhile is newer: its own reading is on the way.
        if (this.text === before || job.text === this.text) {
          if (remember && reading.text !== this.text) this.#remember(job.what, job.kind);
          this.text = reading.text;
          this.reading = reading;
          this.problem = undefined;
          if (reading.engine) {
            this.valid = reading.text;
            this.summary = reading.engine;
          }
        } else if (job.edits) {
          // The edit belongs into the newer text too.
          this.#waiting.unshift(next);
          continue;
        }
      } catch (error) {
        if (error instanceof Refused) this.problem = error.problem;
        else if (error instanceof Gone) {
          // Nothing is lost: the job is done when the server is back.
          this.#waiting.unshift(next);
          server.lost();
          break;
        } else throw error;
      }
      done();
    }
    this.#running = false;
  }

  /**
   * Writes the file; `Refused` with status 409 where another program changed it. `over`: revision that it may replace,
   * `null` for none.
   */
  async save(name?: string, over?: string | null): Promise<void> {
    const target = name ?? this.file?.name;
    if (!target) throw new Error("a file that is not there yet needs a name");
    const own = target === this.file?.name ? this.file.revision : null;
    const revision = over === undefined ? own : over;
    const file = await put<FileState>("/api/file", { name: target, text: this.text, revision });
    this.file = file;
    server.onDisk = file;
  }

  /** What another program wrote is what this text replaces from now on. */
  keepMine(theirs: FileState) {
    this.file = theirs;
  }

  /** What another program wrote in place of this text; undo brings this one back. */
  async takeTheirs(theirs: FileState) {
    this.file = theirs;
    await this.set(theirs.text, `take ${theirs.name} from the disk`);
  }
}

export const engine = new EngineDocument();
