// The engine being worked on: its file's text is the whole truth, and everything else follows from it.

import { post, put } from "../api/client";
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

/** A job in its turn. */
interface Waiting {
  job: Job;
  /** Whether it is a step of undo. */
  remember: boolean;
  done: () => void;
}

class EngineDocument {
  text = $state("");
  /** What the server read in `text`: mistakes, keys, the engine in short. */
  reading = $state.raw<Reading>();
  /** The last text that makes an engine: results belong to it. */
  valid = $state("");
  /** The first such text since the engine was opened: what changes are measured against. */
  first = $state("");
  /** The engine of `valid` in short: cards stay while a value is half typed. */
  summary = $state.raw<EngineSummary>();
  #past = $state.raw<Step[]>([]);
  #future = $state.raw<Step[]>([]);
  #kind = "";
  #at = 0;
  #opened: (() => void)[] = [];
  /** The file as it was when it was opened or saved. */
  file = $state.raw<FileState | null>(null);
  /** Name in place of a file that is not there yet. */
  untitled = $state("engine");
  problem = $state.raw<Problem>();
  /** Edits that were made and are not in the text yet, the oldest one first. */
  pending = $state.raw<Edit[]>([]);

  /** Another program removed the file since it was opened or saved here. */
  removedOutside = $derived(
    this.file !== null && server.onDisk === null && server.session?.files.includes(this.file.name) === false,
  );
  dirty = $derived(this.removedOutside || this.text !== (this.file?.text ?? ""));
  /** Something would be lost with this text: an untouched template of the gallery would not. */
  unsaved = $derived(
    this.pending.length > 0 ||
      (this.dirty &&
        this.text !== "" &&
        !(this.file === null && server.session?.templates.some((template) => template.text === this.text))),
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
    this.#drop();
    this.file = file;
    this.untitled = untitled;
    this.#past = [];
    this.#future = [];
    this.#kind = "";
    this.text = text;
    this.first = "";
    for (const act of this.#opened) act();
    await this.#do({ text, what: "open", kind: "" }, false);
    // A file without an engine has no results: those of the engine before are not its own.
    if (this.text === text && this.reading?.text === text && !this.reading.engine) {
      this.valid = "";
      this.summary = undefined;
    }
  }

  /** Calls `act` whenever another engine takes the place of this one: what was found for this one is no use then. */
  whenOpened(act: () => void) {
    this.#opened.push(act);
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
    const edit = this.#edits()[0];
    // An edit that is still being read is what was done last: it is taken back alone, and nothing comes after it.
    if (edit && !back) return;
    this.#drop();
    if (edit && !this.#goesOn(edit.job.kind)) return;
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

  /** Whether an edit of this kind belongs to the last step. */
  #goesOn(kind: string): boolean {
    return kind !== "" && kind === this.#kind && performance.now() - this.#at < ONE_STEP;
  }

  #remember(what: string, kind: string) {
    const goesOn = this.#goesOn(kind);
    this.#kind = kind;
    this.#at = performance.now();
    this.#future = [];
    if (!goesOn) this.#past = [...this.#past, { text: this.text, what }].slice(-MOST_STEPS);
  }

  // One request at a time; while it is under way only the newest job of each kind waits.
  #waiting: Waiting[] = [];
  /** The job whose reading is on the way. */
  #current: Waiting | undefined;
  #running = false;
  #work: Promise<void> = Promise.resolve();

  constructor() {
    server.whenBack(() => this.#start());
  }

  /** Everything that was asked for is read, or the server is gone. */
  settled(): Promise<void> {
    return this.#work;
  }

  #do(job: Job, remember: boolean): Promise<void> {
    return new Promise((done) => {
      const replaced = (waiting: Waiting) =>
        (job.text !== undefined && waiting.job.text !== undefined) ||
        (job.kind !== "" && waiting.job.kind === job.kind);
      for (const waiting of this.#waiting.filter(replaced)) waiting.done();
      this.#waiting = this.#waiting.filter((waiting) => !replaced(waiting));
      this.#waiting.push({ job, remember, done });
      this.#tell();
      this.#start();
    });
  }

  /** Edits that are not in the text yet, the oldest one first. */
  #edits(): Waiting[] {
    return [this.#current, ...this.#waiting].filter((one) => one?.job.edits !== undefined) as Waiting[];
  }

  /** Nothing of what is under way is wanted any more. */
  #drop() {
    for (const one of [...this.#waiting, ...(this.#current ? [this.#current] : [])]) one.done();
    this.#waiting = [];
    this.#current = undefined;
    this.#tell();
  }

  #tell() {
    const edits = this.#edits().flatMap(({ job }) => job.edits ?? []);
    if (edits.length > 0 || this.pending.length > 0) this.pending = edits;
  }

  #start() {
    if (!this.#running) this.#work = this.#run();
  }

  async #run() {
    this.#running = true;
    try {
      for (let next = this.#waiting.shift(); next; next = this.#waiting.shift()) {
        this.#current = next;
        this.#tell();
        if (!(await this.#read(next))) break;
      }
    } finally {
      this.#current = undefined;
      this.#running = false;
      this.#tell();
    }
  }

  /** Does one job; `false` where the server is gone. */
  async #read(next: Waiting): Promise<boolean> {
    const { job, remember, done } = next;
    const before = this.text;
    try {
      const body = { text: job.text ?? before, edits: job.edits ?? [] };
      const reading = await post<Reading>("/api/engine", body, "engine");
      if (this.#current !== next) return true;
      // What was typed or written meanwhile is newer: it has a reading of its own.
      if (this.text === (job.text ?? before)) {
        if (remember && reading.text !== this.text) this.#remember(job.what, job.kind);
        this.#take(reading);
      } else if (job.edits) {
        // The edit belongs into the newer text too.
        this.#waiting.unshift(next);
        return true;
      }
    } catch (error) {
      if (this.#current !== next) return true;
      const refused = server.refusal(error);
      if (!refused) {
        // Nothing is lost: the job is done when the server is back.
        this.#waiting.unshift(next);
        return false;
      }
      this.problem = refused;
    }
    done();
    return true;
  }

  #take(reading: Reading) {
    this.text = reading.text;
    this.reading = reading;
    this.problem = undefined;
    if (!reading.engine) return;
    this.valid = reading.text;
    this.summary = reading.engine;
    if (this.first === "") this.first = reading.text;
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
