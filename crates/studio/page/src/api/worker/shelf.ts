// Files that the browser keeps: they are there again the next time, and other windows of the page see them.

const FILE = "lanchester-file:";
const OPEN = "lanchester-open";

/** Where the browser keeps texts. */
export type Store = Pick<Storage, "getItem" | "setItem" | "removeItem" | "key" | "length">;

export class Shelf {
  /** What the store has no room for, or all where there is no store: kept as long as the page is open. */
  #here = new Map<string, string>();

  constructor(private readonly store: Store | undefined) {}

  /** Every file by its name. */
  all(): Record<string, string> {
    const files: Record<string, string> = {};
    for (let at = 0; at < (this.store?.length ?? 0); at++) {
      const key = this.store?.key(at);
      if (key?.startsWith(FILE)) files[key.slice(FILE.length)] = this.store?.getItem(key) ?? "";
    }
    for (const [name, text] of this.#here) files[name] = text;
    return files;
  }

  /** Keeps a file for the next visits; `false` where there is no room for it. */
  put(name: string, text: string): boolean {
    try {
      if (!this.store) return false;
      this.store.setItem(FILE + name, text);
    } catch {
      return false;
    }
    this.#here.delete(name);
    return true;
  }

  /** Keeps a file as long as the page is open at least. */
  hold(name: string, text: string) {
    if (!this.put(name, text)) this.#here.set(name, text);
  }

  /** Name of the file that was opened or saved last. */
  get open(): string | null {
    return this.store?.getItem(OPEN) ?? null;
  }

  set open(name: string) {
    try {
      this.store?.setItem(OPEN, name);
    } catch {
      // Then the next visit begins with the gallery.
    }
  }

  /** Whether a change of the store is one of a file. */
  static isFile(key: string | null): boolean {
    return key === null || key.startsWith(FILE);
  }
}

/** The store of this browser, if it lets pages have one. */
export function storeOfBrowser(): Store | undefined {
  try {
    return window.localStorage;
  } catch {
    return undefined;
  }
}
