// The only place that talks to the server.

import type { Problem } from "./types";

/** What the server refused, in its own words. */
export class Refused extends Error {
  constructor(
    readonly status: number,
    readonly problem: Problem,
  ) {
    super(problem.message);
  }
}

/** The server does not answer. */
export class Gone extends Error {
  constructor() {
    super("the studio's server does not answer");
  }
}

let token = takeToken();
/** Tells the server which requests replace each other. */
const client = crypto.randomUUID();

/** The token comes in the address once and is kept for this origin: links to states work in other windows. */
function takeToken(): string {
  const address = new URL(location.href);
  const given = address.searchParams.get("token");
  if (given) {
    localStorage.setItem("lanchester-token", given);
    address.searchParams.delete("token");
    history.replaceState(null, "", address);
  }
  return given ?? localStorage.getItem("lanchester-token") ?? "";
}

/** A server that was started again has a new token; the window that it opened has left it for this one. */
function renewed(): boolean {
  const kept = localStorage.getItem("lanchester-token");
  if (!kept || kept === token) return false;
  token = kept;
  return true;
}

async function send(
  method: string,
  path: string,
  body: unknown,
  lane: string | undefined,
  signal: AbortSignal | undefined,
): Promise<Response> {
  const headers: Record<string, string> = { "X-Lanchester-Token": token, "X-Lanchester-Client": client };
  if (body !== undefined) headers["Content-Type"] = "application/json";
  if (lane) headers["X-Lanchester-Lane"] = lane;
  let response: Response;
  try {
    response = await fetch(path, {
      method,
      headers,
      body: body === undefined ? null : JSON.stringify(body),
      signal: signal ?? null,
    });
  } catch (error) {
    if (signal?.aborted) throw error;
    throw new Gone();
  }
  if (response.ok) return response;
  if (response.status === 401 && renewed()) return send(method, path, body, lane, signal);
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

/** A file that the server makes: a report, a part. */
export async function postForFile(path: string, body: unknown): Promise<Blob> {
  const response = await send("POST", path, body, undefined, undefined);
  return whole(() => response.blob());
}

/** Events of the server; `EventSource` cannot send headers, so that the token stands in the address. */
export function events(): EventSource {
  return new EventSource(`/api/events?token=${encodeURIComponent(token)}`);
}
