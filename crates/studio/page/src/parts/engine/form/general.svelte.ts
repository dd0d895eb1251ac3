// Throws and cylinders of the engine: the short form of a file leaves their places to the server, its general form names them.

import type { Reading } from "../../../api/types";
import { engine } from "../../../state/engine.svelte";
import { Resource } from "../../../state/resource.svelte";
import { shape } from "../sketch/geometry";

export class General {
  readonly #written = new Resource<{ text: string }>("general-form", () =>
    engine.valid === "" ? null : { path: "/api/expanded", body: { text: engine.valid } },
  );
  readonly #read = new Resource<Reading>("general-form-read", () =>
    this.#written.value ? { path: "/api/engine", body: { text: this.#written.value.text, edits: [] } } : null,
  );
  readonly shape = $derived(this.#read.value && shape(this.#read.value.entries));
  readonly problem = $derived(this.#read.problem ?? this.#written.problem);
}
