// Questions that this browser answers itself: a module in workers, files that the browser keeps.

import type { Events, Question, Transport } from "../transport";
import type { FileState, Problem, Session } from "../types";
import AnsweringWorker from "./answering?worker&inline";
import type { Answer } from "./messages";
import { loadModule } from "./module";
import { Pool } from "./pool";
import { Shelf, storeOfBrowser } from "./shelf";

/** More workers would take memory and help little: the page asks a few questions at a time. */
const MOST_WORKERS = 4;

const response = ({ status, kind, bytes }: Answer) =>
  new Response(bytes, { status, headers: { "Content-Type": kind } });

const noRoom = (name: string): Problem => ({
  message: `this browser has no room to keep ${name}`,
  hint: "the text is still here: download the engine file from Share",
  diagnostics: [],
  found: null,
});

class Browser implements Transport {
  readonly keeps = "browser";
  readonly absent =
    "The studio's module cannot be loaded. This page needs a browser with WebAssembly, and its files side by side on a file server; " +
    "the page that is one file opens from anywhere.";
  #shelf = new Shelf(storeOfBrowser());
  #pool: Promise<Pool> | undefined;

  async ask(question: Question): Promise<Response> {
    const { method, path, body, lane, signal } = question;
    const pool = await this.#ready();
    // Another window may have changed a file, and nobody may have told yet.
    if (path.startsWith("/api/file")) pool.files = this.#shelf.all();
    const answer = await pool.ask(`${method} ${path}`, body ?? "", lane, signal);
    if (answer.status !== 200) return response(answer);
    if (path === "/api/session") return this.#session(pool, answer);
    if (path === "/api/file/open" || path === "/api/file") {
      const file = json<FileState>(answer);
      const kept = method !== "PUT" || this.#shelf.put(file.name, file.text);
      // The worker that answered has it, the others not yet; or none shall have it.
      if (method === "PUT") pool.files = this.#shelf.all();
      if (!kept) return Response.json(noRoom(file.name), { status: 422 });
      this.#shelf.open = file.name;
    }
    return response(answer);
  }

  events(): Events {
    return new ShelfEvents(() => this.#open());
  }

  keep(name: string, text: string) {
    this.#shelf.hold(name, text);
    void this.#ready().then((pool) => (pool.files = this.#shelf.all()));
  }

  #ready(): Promise<Pool> {
    this.#pool ??= loadModule().then((module) => {
      const most = Math.max(2, Math.min(MOST_WORKERS, (navigator.hardwareConcurrency || 2) - 1));
      const pool = new Pool(module, () => new AnsweringWorker(), most);
      pool.files = this.#shelf.all();
      window.addEventListener("storage", ({ key }) => {
        if (Shelf.isFile(key)) pool.files = this.#shelf.all();
      });
      return pool;
    });
    return this.#pool;
  }

  /** Which file was open last is known here: workers come and go. */
  async #session(pool: Pool, answer: Answer): Promise<Response> {
    const session = json<Session>(answer);
    session.file = await this.#open(pool);
    return Response.json(session);
  }

  async #open(pool?: Pool): Promise<FileState | null> {
    const name = this.#shelf.open;
    if (name === null) return null;
    pool ??= await this.#ready();
    const answer = await pool.ask("POST /api/file/open", JSON.stringify({ name }));
    return answer.status === 200 ? json<FileState>(answer) : null;
  }
}

/** Tells when another window changes the open file. */
class ShelfEvents extends EventTarget implements Events {
  onerror = null;
  #heard = ({ key }: StorageEvent) => {
    if (Shelf.isFile(key)) void this.#tell();
  };

  constructor(private readonly open: () => Promise<FileState | null>) {
    super();
    window.addEventListener("storage", this.#heard);
  }

  async #tell() {
    const data = JSON.stringify(await this.open());
    this.dispatchEvent(new MessageEvent("file", { data }));
  }

  close() {
    window.removeEventListener("storage", this.#heard);
  }
}

function json<T>(answer: Answer): T {
  return JSON.parse(new TextDecoder().decode(answer.bytes)) as T;
}

export const transport: Transport = new Browser();
