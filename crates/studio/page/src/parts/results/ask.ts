// Questions about the engine at the speed in view.

import { engine } from "../../state/engine.svelte";
import type { Question } from "../../state/resource.svelte";
import { view } from "../../state/view.svelte";

export function atSpeed(path: string): Question {
  if (engine.valid === "") return null;
  return {
    path,
    body: view.speed === undefined ? { text: engine.valid } : { text: engine.valid, speed: view.speed },
  };
}
