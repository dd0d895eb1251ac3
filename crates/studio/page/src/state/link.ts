// A link that holds the whole state, packed into the fragment of the address: it never reaches a server.

import { engine } from "./engine.svelte";
import { units, SYSTEMS, type System } from "./units.svelte";
import { TABS, view, type Pin, type Tab } from "./view.svelte";

/** Raised when the meaning of a field changes. */
const VERSION = 1;
const MARK = "#state=";

export interface State {
  version: number;
  name: string;
  text: string;
  tab: Tab;
  theta: number;
  speed: number | null;
  units: System;
  pins: Pin[];
}

export function current(): State {
  return {
    version: VERSION,
    name: engine.file?.name ?? engine.untitled,
    text: engine.text,
    tab: view.tab,
    theta: view.theta,
    speed: view.speed ?? null,
    units: units.system,
    pins: view.pins,
  };
}

/** The state as a word for an address. */
export async function packed(state: State): Promise<string> {
  const bytes = await through(
    new TextEncoder().encode(JSON.stringify(state)),
    new CompressionStream("deflate-raw"),
  );
  let word = "";
  for (const byte of bytes) word += String.fromCharCode(byte);
  return btoa(word).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** `undefined` for what is no state. */
export async function unpacked(word: string): Promise<State | undefined> {
  try {
    const binary = atob(word.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
    return checked(new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw"))));
  } catch {
    return undefined;
  }
}

/** A state from text, as a link or a file holds it. */
export function checked(json: string): State | undefined {
  let state: Partial<State>;
  try {
    state = JSON.parse(json) as Partial<State>;
  } catch {
    return undefined;
  }
  if (
    typeof state !== "object" ||
    state === null ||
    state.version !== VERSION ||
    typeof state.text !== "string"
  )
    return undefined;
  return {
    version: VERSION,
    name: typeof state.name === "string" ? state.name : "engine",
    text: state.text,
    tab: TABS.find((tab) => tab === state.tab) ?? "engine",
    theta: typeof state.theta === "number" ? state.theta : 0,
    speed: typeof state.speed === "number" ? state.speed : null,
    units: SYSTEMS.find((system) => system === state.units) ?? "mm-g",
    pins: Array.isArray(state.pins) ? state.pins.filter(isPin) : [],
  };
}

function isPin(pin: unknown): pin is Pin {
  const { name, text, colour } = (pin ?? {}) as Partial<Pin>;
  return typeof name === "string" && typeof text === "string" && typeof colour === "number";
}

export async function adopt(state: State) {
  view.tab = state.tab;
  view.theta = state.theta;
  view.speed = state.speed ?? undefined;
  view.pins = state.pins;
  units.set(state.units);
  // It is a copy: saving it asks for a name.
  await engine.open(null, state.text, state.name.replace(/\.toml$/, ""));
}

/** Takes the state out of the address, if it holds one. */
export async function restore(): Promise<boolean> {
  if (!location.hash.startsWith(MARK)) return false;
  const state = await unpacked(location.hash.slice(MARK.length));
  history.replaceState(null, "", location.pathname + location.search);
  if (!state) return false;
  await adopt(state);
  return true;
}

export async function link(): Promise<string> {
  const address = new URL(location.href);
  address.search = "";
  address.hash = MARK + (await packed(current()));
  return address.href;
}

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array> {
  const out = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(out).arrayBuffer());
}
