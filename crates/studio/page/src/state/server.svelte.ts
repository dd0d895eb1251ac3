// Whether the server answers, and what it tells by itself.

import { Gone, Refused, events, get } from "../api/client";
import type { FileState, Problem, Session } from "../api/types";

class Server {
  /** What the server said at the start. */
  session = $state.raw<Session>();
  gone = $state(false);
  /** Counts the times that the server came back. */
  epoch = $state(0);
  /** The file as it stands on the disk. */
  onDisk = $state.raw<FileState | null>(null);
  #waiting = false;
  #seen = 0;
  #back: (() => void)[] = [];

  /** Calls `act` each time the server answers again. */
  whenBack(act: () => void) {
    this.#back.push(act);
  }

  /** The session anew: files may have come to the folder. */
  async refresh() {
    this.session = await get<Session>("/api/session");
  }

  async start(): Promise<Session> {
    const session = await get<Session>("/api/session");
    this.session = session;
    this.onDisk = session.file;
    this.#listen();
    return session;
  }

  #listen() {
    const source = events();
    source.addEventListener("file", (event) => {
      void this.#see(JSON.parse((event as MessageEvent<string>).data) as FileState | null);
    });
    source.onerror = () => {
      source.close();
      this.lost();
    };
  }

  /** The file as it stands on the disk now. Where there is none the folder tells whether it was removed. */
  async #see(file: FileState | null) {
    const seen = ++this.#seen;
    if (file === null) await this.refresh().catch(() => this.lost());
    if (seen === this.#seen) this.onDisk = file;
  }

  /** What the server refused; one that is gone is waited for, and anything else is a mistake of the page. */
  refusal(error: unknown): Problem | undefined {
    if (error instanceof Refused) return error.problem;
    if (!(error instanceof Gone)) throw error;
    this.lost();
    return undefined;
  }

  /** Tries once a second until the server answers again. */
  lost() {
    this.gone = true;
    if (this.#waiting) return;
    this.#waiting = true;
    const again = async () => {
      try {
        const session = await get<Session>("/api/session");
        this.session = session;
        this.onDisk = session.file;
        this.gone = false;
        this.#waiting = false;
        this.epoch += 1;
        this.#listen();
        for (const act of this.#back) act();
      } catch {
        setTimeout(again, 1000);
      }
    };
    setTimeout(again, 1000);
  }
}

export const server = new Server();
