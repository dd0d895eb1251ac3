// Where the eye is to go: to the field of a key, or to a line of the file's text.

import { tick } from "svelte";
import { view } from "../../../state/view.svelte";

/** The path that the eye is being led to. */
let leading: string | undefined;

/** Shows the Engine tab and puts the focus into the field of `path`, or the first of that section; `false` where the form has none. */
export async function focusField(path: string): Promise<boolean> {
  // A form that opens leads to the field in hand by itself: once is enough.
  if (leading === path) return true;
  leading = path;
  try {
    view.tab = "engine";
    await tick();
    document.dispatchEvent(new CustomEvent("lanchester-field", { detail: path }));
    await tick();
    const field = document.querySelector<HTMLElement>(`[data-path="${CSS.escape(path)}"]`);
    if (!field) return await focusSection(path);
    show(field);
    return true;
  } finally {
    leading = undefined;
  }
}

/** The first field of a section, or what adds one; `false` where the form has no such section. */
async function focusSection(path: string): Promise<boolean> {
  const section = document.querySelector<HTMLElement>(`[data-section="${CSS.escape(path)}"]`);
  if (!section) return false;
  const first = (wanted: string) => section.querySelector<HTMLElement>(wanted);
  const toggle = first('button.toggle[aria-expanded="false"]');
  // Where nothing is given yet the keys that can be are listed at once.
  if (!first("[data-path]") && toggle) {
    toggle.click();
    await tick();
  }
  const field = first("[data-path]") ?? toggle ?? first("button.add") ?? first("button");
  if (!field) return false;
  show(field);
  return true;
}

/** Opens the parts of the form around a field, and leads eye and keyboard to it. */
function show(field: HTMLElement) {
  for (
    let around = field.closest("details");
    around;
    around = around.parentElement?.closest("details") ?? null
  )
    around.open = true;
  field.focus({ preventScroll: true });
  field.scrollIntoView({ block: "center", behavior: "auto" });
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
