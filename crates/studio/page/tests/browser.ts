// A studio without a server, for one test: the built page from a file server or from the disk, files in the browser's storage.

import type { BrowserContext, Page } from "@playwright/test";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { type Server, createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";
import { pathToFileURL } from "node:url";

const FILE = "lanchester-file:";
const OPEN = "lanchester-open";
/** As a plain file server says it; one that does not know what a module is says nothing of it. */
const KINDS: Record<string, string> = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".txt": "text/plain",
};

export class InBrowser {
  readonly port = 0;
  readonly token = "";

  private constructor(
    readonly address: string,
    /** Folder for what a test writes. */
    readonly folder: string,
    readonly name: string,
    /** Another page of the same origin: it sees the same files. */
    private readonly other: Page,
    private readonly server: Server | undefined,
  ) {}

  /** `place`: the built folder, or the page that is one file. With `text` the browser keeps an engine file `name`, which was open last. */
  static async start(context: BrowserContext, place: string, name: string, text: string): Promise<InBrowser> {
    const folder = await mkdtemp(join(tmpdir(), "lanchester-studio-"));
    const server = place.endsWith(".html") ? undefined : await serve(place);
    const origin = server
      ? `http://127.0.0.1:${(server.address() as AddressInfo).port}/`
      : pathToFileURL(join(place, "..")).href + "/";
    const other = await context.newPage();
    await other.goto(origin + "third-party.txt");
    const studio = new InBrowser(server ? origin : pathToFileURL(place).href, folder, name, other, server);
    if (name !== "") {
      await studio.write(text);
      await other.evaluate(([key, name]) => localStorage.setItem(key, name), [OPEN, name] as const);
    }
    return studio;
  }

  async read(name = this.name): Promise<string> {
    const text = await this.other.evaluate((key) => localStorage.getItem(key), FILE + name);
    if (text === null) throw new Error(`the browser keeps no ${name}`);
    return text;
  }

  remove(name = this.name): Promise<void> {
    return this.other.evaluate((key) => localStorage.removeItem(key), FILE + name);
  }

  write(text: string, name = this.name): Promise<void> {
    return this.other.evaluate(([key, text]) => localStorage.setItem(key, text), [
      FILE + name,
      text,
    ] as const);
  }

  kill(): Promise<void> {
    return Promise.reject(new Error("there is no server to kill"));
  }

  run(): Promise<void> {
    return this.kill();
  }

  async end(): Promise<void> {
    await this.other.close();
    this.server?.closeAllConnections();
    this.server?.close();
    await rm(this.folder, { recursive: true, force: true });
  }
}

/** A file server that knows nothing of the studio. */
async function serve(folder: string): Promise<Server> {
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url ?? "/", "http://a").pathname);
    const file = join(folder, path === "/" ? "index.html" : path);
    readFile(file).then(
      (bytes) => {
        const kind = KINDS[extname(file)];
        response.writeHead(200, kind ? { "Content-Type": kind } : {}).end(bytes);
      },
      () => response.writeHead(404).end(),
    );
  });
  await new Promise<void>((ready) => server.listen(0, "127.0.0.1", ready));
  return server;
}
