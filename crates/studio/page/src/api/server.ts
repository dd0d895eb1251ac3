// Questions to the studio's server.

import type { Events, Question, Transport } from "./transport";

class Server implements Transport {
  readonly keeps = "folder";
  readonly absent = "The studio's server does not answer. Start it again with `lanchester studio`.";
  #token = takeToken();
  /** Tells the server which requests replace each other. */
  #client = crypto.randomUUID();

  async ask(question: Question): Promise<Response> {
    const { method, path, body, lane, signal } = question;
    const headers: Record<string, string> = {
      "X-Lanchester-Token": this.#token,
      "X-Lanchester-Client": this.#client,
    };
    if (body !== null) headers["Content-Type"] = "application/json";
    if (lane) headers["X-Lanchester-Lane"] = lane;
    const response = await fetch(path, { method, headers, body, signal: signal ?? null });
    return response.status === 401 && this.#renewed() ? this.ask(question) : response;
  }

  /** `EventSource` cannot send headers, so that the token stands in the address. */
  events(): Events {
    return new EventSource(`/api/events?token=${encodeURIComponent(this.#token)}`);
  }

  keep() {}

  /** A server that was started again has a new token; the window that it opened has left it for this one. */
  #renewed(): boolean {
    const kept = localStorage.getItem("lanchester-token");
    if (!kept || kept === this.#token) return false;
    this.#token = kept;
    return true;
  }
}

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

export const transport: Transport = new Server();
