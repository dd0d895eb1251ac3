// What the page and its workers say to each other.

/** To a worker: the module, once. */
export interface Start {
  module: WebAssembly.Module;
}

/** To a worker: a question. */
export interface Ask {
  /** Method and path. */
  head: string;
  body: string;
  /** The files, where they are others than before. */
  files: Record<string, string> | null;
}

/** From a worker: an answer. */
export interface Answer {
  status: number;
  kind: string;
  bytes: ArrayBuffer;
}

/** From a worker that is of no more use. */
export interface Broken {
  broken: string;
}
