// The module behind its door: texts in, answers out. `crates/web/src/door.rs` has the other side.

import type { Answer } from "./messages";

interface Exports {
  memory: WebAssembly.Memory;
  room(length: number): number;
  head(): void;
  ask(): number;
  length(): number;
  reply(): number;
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();
const LINE_FEED = 10;

export class Door {
  private constructor(private readonly module: Exports) {}

  static async open(module: WebAssembly.Module): Promise<Door> {
    const instance = await WebAssembly.instantiate(module, imports(module));
    return new Door(instance.exports as unknown as Exports);
  }

  ask(head: string, body: string): Answer {
    this.#write(head);
    this.module.head();
    this.#write(body);
    const status = this.module.ask();
    const start = this.module.reply();
    const reply = new Uint8Array(this.module.memory.buffer, start, this.module.length());
    const end = reply.indexOf(LINE_FEED);
    // A copy: the memory is the module's.
    const bytes = reply.slice(end + 1).buffer;
    return { status, kind: decoder.decode(reply.slice(0, end)), bytes };
  }

  #write(text: string) {
    const bytes = encoder.encode(text);
    const start = this.module.room(bytes.length);
    // The memory may have grown: a view is taken anew each time.
    new Uint8Array(this.module.memory.buffer, start, bytes.length).set(bytes);
  }
}

/** The clock; and, for what a dependency would ask of the page for random numbers, which nobody draws, a refusal. */
function imports(module: WebAssembly.Module): WebAssembly.Imports {
  const all: Record<string, Record<string, () => number>> = { page: { now: () => performance.now() } };
  for (const { module: from, name } of WebAssembly.Module.imports(module))
    (all[from] ??= {})[name] ??= () => {
      throw new Error(`${name}: the page has no such function`);
    };
  return all;
}
