// All sections to start from at once: each needs what the server read of the one before.

import type { Diagnostic, Reading } from "../../api/types";
import { shape } from "../engine/sketch/geometry";
import { sizesOf, type Sizes } from "./shape/sizes";
import { steps } from "./steps";

/** Asks the server. */
export type Ask = <T>(path: string, body: unknown) => Promise<T>;

export interface Started {
  /** The file with as many sections as could be added. */
  text: string;
  /** The section that could not be added, and why as far as the server says so. */
  stuck: { section: string; why: Diagnostic | undefined } | undefined;
}

const read = (ask: Ask, text: string) => ask<Reading>("/api/engine", { text, edits: [] });

/** Sizes of the engine of a file; `undefined` where it names no bore. */
async function sizesOfFile(ask: Ask, text: string): Promise<Sizes | undefined> {
  const general = await ask<{ text: string }>("/api/expanded", { text });
  const whole = shape((await read(ask, general.text)).entries);
  return whole && sizesOf(whole);
}

export async function started(ask: Ask, text: string): Promise<Started> {
  const sizes = await sizesOfFile(ask, text);
  let reading = await read(ask, text);
  const tried = new Set<string>();
  for (;;) {
    const next = reading.engine && steps(reading.engine, reading.entries, sizes).find((step) => !step.done);
    if (!next) return { text: reading.text, stuck: undefined };
    // A step that did not help would be asked for ever.
    const stuck = (why?: Diagnostic) => ({ text: reading.text, stuck: { section: next.section, why } });
    if (!next.edits || tried.has(next.section)) return stuck();
    tried.add(next.section);
    const after = await ask<Reading>("/api/engine", { text: reading.text, edits: next.edits });
    if (!after.engine) return stuck(after.diagnostics.find((one) => one.severity === "error"));
    reading = after;
  }
}
