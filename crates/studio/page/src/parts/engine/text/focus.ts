// Where the eye is to go: to the field of a key, or to a line of the file's text.

import { tick } from "svelte";
import { view } from "../../../state/view.svelte";

/** Shows the Engine tab and puts the focus into the field of `path`; `false` where the form has none. */
export async function focusField(path: string): Promise<boolean> {
  view.tab = "engine";
  await tick();
  document.dispatchEvent(new CustomEvent("lanchester-field", { detail: path }));
  await tick();
  const field = document.querySelector<HTMLElement>(`[data-path="${CSS.escape(path)}"]`);
  if (!field) return false;
  for (
    let around = field.closest("details");
    around;
    around = around.parentElement?.closest("details") ?? null
  )
    around.open = true;
  field.focus({ preventScroll: true });
  field.scrollIntoView({ block: "center", behavior: "auto" });
  return true;
}

/** The focus stays on the tab when what had it has done its work and is gone. */
export async function keepFocus() {
  await tick();
  if (document.activeElement === document.body || document.activeElement === null)
    document.getElementById("panel")?.focus({ preventScroll: true });
}

/** Attributes of a part of the sketch that leads to the field of `path`, by mouse and by keyboard. */
export function leadsTo(path: string) {
  const go = () => void focusField(path);
  return {
    role: "button" as const,
    tabindex: 0,
    onclick: go,
    onkeydown(event: KeyboardEvent) {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      go();
    },
  };
}

/** Shows the Engine tab with a place of the text [UTF-16 offset] in view. */
export async function focusText(at: number) {
  view.tab = "engine";
  await tick();
  document.dispatchEvent(new CustomEvent("lanchester-text", { detail: at }));
}
