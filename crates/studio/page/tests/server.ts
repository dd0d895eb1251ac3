// A studio for one test: the program in a folder of its own, with a copy of an engine file.
//
//   import { expect, test } from "./server";
//   test.use({ example: "in-line-3.toml" });
//   test("...", async ({ studio, page }) => {
//     await page.goto(studio.address);
//   });
//
// LANCHESTER_PROGRAM names the program; default: the debug build of this workspace. LANCHESTER_PAGE names a folder with a
// built page that is shown in place of the program's own: the page can be tested without building the program anew.
//
// LANCHESTER_WEB names what `cargo xtask web` builds, the folder or its page in one file: the same tests then walk through the studio without
// a server, but for those with the tag @server.

import { type BrowserContext, test as base } from "@playwright/test";
import { InBrowser } from "./browser";
import { type ChildProcess, spawn } from "node:child_process";
import { copyFile, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

export const PROGRAM = process.env.LANCHESTER_PROGRAM ?? resolve("../../../target/debug/lanchester");
const PAGE = process.env.LANCHESTER_PAGE;
const WEB = process.env.LANCHESTER_WEB;
const EXAMPLES = resolve("../../../examples");
/** How long the program may take until it prints its address [ms]. */
const START = 20_000;

/** What a test may do with a studio, whoever answers. */
export interface Studio {
  /** The page. */
  readonly address: string;
  /** Folder for files that a test writes. */
  readonly folder: string;
  /** Name of the engine file that is open at the start; empty: none. */
  readonly name: string;
  readonly port: number;
  readonly token: string;
  read(name?: string): Promise<string>;
  remove(name?: string): Promise<void>;
  write(text: string, name?: string): Promise<void>;
  kill(): Promise<void>;
  run(token?: string): Promise<void>;
  end(): Promise<void>;
}

export class Server implements Studio {
  /** What the program printed: the page with its token. */
  address = "";
  #process: ChildProcess | undefined;
  #said = "";

  private constructor(
    /** Folder that the server may write to. */
    readonly folder: string,
    /** Name of the engine file in it; empty: the studio was started without a file. */
    readonly name: string,
    readonly port: number,
    public token: string,
  ) {}

  /** A copy of `example` from the folder of examples in a new folder, and a server for it. */
  static async start(example: string): Promise<Server> {
    const folder = await mkdtemp(join(tmpdir(), "lanchester-studio-"));
    if (example !== "") await copyFile(join(EXAMPLES, example), join(folder, example));
    const token = `test-${crypto.randomUUID()}`;
    const studio = new Server(folder, example, await freePort(), token);
    await studio.run();
    return studio;
  }

  /** Starts the program; after `kill` again, on the same port, with the same token or another. */
  async run(token = this.token): Promise<void> {
    this.token = token;
    const file = this.name === "" ? [] : [this.name];
    const child = spawn(PROGRAM, ["studio", ...file, "--port", String(this.port), "--no-open"], {
      cwd: this.folder,
      env: { ...process.env, LANCHESTER_STUDIO_TOKEN: this.token },
      stdio: ["ignore", "pipe", "pipe"],
    });
    this.#process = child;
    this.#said = "";
    this.address = await new Promise<string>((found, failed) => {
      const late = setTimeout(
        () => failed(new Error(`no address within ${START} ms; printed: ${this.#said}`)),
        START,
      );
      const listen = (part: Buffer) => {
        this.#said += part.toString();
        const address = /https?:\/\/[^\s"'<>]+/.exec(this.#said)?.[0];
        // The line is complete: the address is too.
        if (address && /https?:\/\/[^\s"'<>]+\s/.test(this.#said)) {
          clearTimeout(late);
          found(address);
        }
      };
      child.stdout?.on("data", listen);
      child.stderr?.on("data", listen);
      child.on("error", (error) => {
        clearTimeout(late);
        failed(new Error(`${PROGRAM} does not start: ${error.message}`));
      });
      child.on("exit", (code) => {
        clearTimeout(late);
        failed(new Error(`${PROGRAM} ended with ${code} before it printed an address: ${this.#said}`));
      });
    });
  }

  /** Ends the program at once, as a crash would. */
  async kill(): Promise<void> {
    const child = this.#process;
    this.#process = undefined;
    if (!child || child.exitCode !== null || child.signalCode !== null) return;
    await new Promise((ended) => {
      child.once("exit", ended);
      child.kill("SIGKILL");
    });
  }

  /** Ends the program and takes the folder away. */
  async end(): Promise<void> {
    await this.kill();
    await rm(this.folder, { recursive: true, force: true });
  }

  /** The text of a file of the folder, as it stands on the disk. */
  read(name = this.name): Promise<string> {
    return readFile(join(this.folder, name), "utf8");
  }

  /** Takes a file of the folder away, as another program would. */
  remove(name = this.name): Promise<void> {
    return rm(join(this.folder, name));
  }

  /** Writes a file of the folder, as another program would. */
  write(text: string, name = this.name): Promise<void> {
    return writeFile(join(this.folder, name), text);
  }
}

async function freePort(): Promise<number> {
  const probe = createServer();
  return new Promise((found, failed) => {
    probe.once("error", failed);
    probe.listen(0, "127.0.0.1", () => {
      const address = probe.address();
      probe.close(() =>
        address && typeof address === "object" ? found(address.port) : failed(new Error("no free port")),
      );
    });
  });
}

interface Options {
  /** File of the folder of examples to start with; empty: none. */
  example: string;
}

/** Answers everything but questions from the folder of a built page. */
async function showPage(context: BrowserContext, folder: string) {
  await context.route(
    (address) => address.hostname === "127.0.0.1" && !address.pathname.startsWith("/api/"),
    (route) => {
      const path = new URL(route.request().url()).pathname;
      return route.fulfill({ path: join(folder, path === "/" ? "index.html" : path) });
    },
  );
}

export const test = base.extend<Options & { studio: Studio }>({
  example: ["in-line-3-counterweights.toml", { option: true }],
  context: async ({ context }, use) => {
    if (PAGE) await showPage(context, resolve(PAGE));
    await use(context);
  },
  studio: async ({ example, context }, use) => {
    const text = example === "" ? "" : await readFile(join(EXAMPLES, example), "utf8");
    const studio = WEB
      ? await InBrowser.start(context, resolve(WEB), example, text)
      : await Server.start(example);
    await use(studio);
    await studio.end();
  },
});

export { expect } from "@playwright/test";
