// What carries questions to whoever answers them: a server, or a module in workers of this browser.

export interface Question {
  method: "GET" | "POST" | "PUT";
  path: string;
  /** JSON; `null`: none. */
  body: string | null;
  /** A newer question of this window in the same lane takes the place of an older one. */
  lane?: string | undefined;
  signal?: AbortSignal | undefined;
}

/** What comes by itself: events `file`, each with the open file as JSON, or `null`. */
export interface Events {
  addEventListener(type: "file", listener: (event: Event) => void): void;
  onerror: ((event: Event) => unknown) | null;
  close(): void;
}

export interface Transport {
  /** Where files are kept. */
  readonly keeps: "folder" | "browser";
  /** What is told when nobody answers at the start. */
  readonly absent: string;
  /** The answer, whatever its status; fails where nobody answers. */
  ask(question: Question): Promise<Response>;
  events(): Events;
  /** Keeps a file that answers may need; nothing where files stand in a folder. */
  keep(name: string, text: string): void;
}
