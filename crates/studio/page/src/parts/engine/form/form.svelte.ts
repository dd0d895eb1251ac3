// What the form shows beside what the file holds.

import { SvelteSet } from "svelte/reactivity";
import type { PlacedDiagnostic } from "../../../api/types";
import { engine } from "../../../state/engine.svelte";
import { server } from "../../../state/server.svelte";
import { Tables, join, missed, subject, within } from "./tables";

class Form {
  /** Keys and tables whose empty fields are shown although the file does not have them yet. */
  readonly asked = new SvelteSet<string>();

  /** Parts of the form that are open: one that opened itself for a mistake stays open when the mistake is mended. */
  readonly opened = new SvelteSet<string>();

  readonly tables = $derived(new Tables(server.session?.tables ?? []));
  readonly entries = $derived(engine.reading?.entries ?? []);
  readonly layout = $derived(String(engine.value("layout.type") ?? ""));
  readonly diagnostics = $derived.by((): PlacedDiagnostic[] => {
    const reading = engine.reading;
    return (
      reading?.diagnostics.map((one) => {
        const path = subject(reading, one);
        // What is missing in a table belongs to the empty field of its key.
        const field = path === null ? undefined : join(path, missed(one.message) ?? "");
        const known = field !== undefined && this.tables.key(field) && this.tables.shape(field) === "value";
        return { ...one, path: known ? field : path };
      }) ?? []
    );
  });

  constructor() {
    engine.whenOpened(() => {
      this.asked.clear();
      this.opened.clear();
    });
  }

  /** What a part of the form does when it is opened or closed. */
  folds(part: string) {
    return (event: Event) => {
      if ((event.currentTarget as HTMLDetailsElement).open) this.opened.add(part);
      else this.opened.delete(part);
    };
  }

  /** Shows empty fields for a key and for the tables around it. */
  ask(path: string) {
    const steps = path.split(".");
    steps.forEach((_, depth) => this.asked.add(steps.slice(0, depth + 1).join(".")));
  }

  /** No field is asked for within `path` any more. */
  forget(path: string) {
    for (const asked of [...this.asked]) if (within(asked, path)) this.asked.delete(asked);
  }

  /** What is said about the value of a key, places within a list included. */
  about(path: string): PlacedDiagnostic[] {
    return this.diagnostics.filter(
      (one) => one.path === path || (one.path?.startsWith(`${path}[`) && !one.path.includes("].")),
    );
  }

  /** What is said about a key and everything below it. */
  below(path: string): PlacedDiagnostic[] {
    return this.diagnostics.filter((one) => one.path !== null && within(one.path, path));
  }
}

export const form = new Form();
