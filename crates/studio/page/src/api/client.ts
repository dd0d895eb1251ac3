// The only place that asks: of a server, or of this browser where the page was built so.

// A page that answers by itself has `worker/browser` in place of the server: see `web.ts`.
import { transport } from "./server";
import type { Events } from "./transport";
import type { Problem } from "./types";

export { transport };

/** What was refused, in the words of whoever answers. */
export class Refused extends Error {
  constructor(
    readonly status: number,
    readonly problem: Problem,
  ) {
    super(problem.message);
  }
}

/** Nobody answers. */
export class Gone extends Error {
  constructor() {
    super("the studio's server does not answer");
  }
}

async function send(
  method: "GET" | "POST" | "PUT",
  path: string,
  body: unknown,
  lane: string | undefined,
  signal: AbortSignal | undefined,
): Promise<Response> {
  let response: Response;
  try {
    const json = body === undefined ? null : JSON.stringify(body);
    response = await transport.ask({ method, path, body: json, lane, signal });
  } catch (error) {
    if (signal?.aborted) throw error;
    throw new Gone();
  }
  if (response.ok) return response;
  let problem: Problem;
  try {
    problem = (await response.json()) as Problem;
  } catch {
    problem = { message: `the server answered ${response.status}`, hint: null, diagnostics: [], found: null };
  }
  throw new Refused(response.status, problem);
}

/** The whole answer; a server that goes while it answers is gone too. */
async function whole<T>(read: () => Promise<T>, signal?: AbortSignal): Promise<T> {
  try {
    return await read();
  } catch (error) {
    if (signal?.aborted) throw error;
    throw new Gone();
  }
}

export async function get<T>(path: string, signal?: AbortSignal): Promise<T> {
  const response = await send("GET", path, undefined, undefined, signal);
  return whole(() => response.json() as Promise<T>, signal);
}

/** `lane`: a newer request of this window in the same lane makes the server drop an older one. */
export async function post<T>(path: string, body: unknown, lane?: string, signal?: AbortSignal): Promise<T> {
  const response = await send("POST", path, body, lane, signal);
  return whole(() => response.json() as Promise<T>, signal);
}

export async function put<T>(path: string, body: unknown): Promise<T> {
  const response = await send("PUT", path, body, undefined, undefined);
  return whole(() => response.json() as Promise<T>);
}

/** A file that is made on request: a report, a part. */
export async function postForFile(path: string, body: unknown): Promise<Blob> {
  const response = await send("POST", path, body, undefined, undefined);
  return whole(() => response.blob());
}

/** What comes by itself. */
export function events(): Events {
  return transport.events();
}
