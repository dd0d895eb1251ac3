// Whether a pointer is down: what is about to be clicked must not move.

let down = false;
const waiting = new Set<() => void>();

function up() {
  down = false;
  // The click comes behind the pointer.
  setTimeout(() => {
    if (down) return;
    for (const act of waiting) act();
    waiting.clear();
  });
}

if (typeof document !== "undefined") {
  document.addEventListener("pointerdown", () => (down = true), true);
  document.addEventListener("pointerup", up, true);
  document.addEventListener("pointercancel", up, true);
}

/** Acts as soon as no pointer is down. */
export function whenUp(act: () => void) {
  if (down) waiting.add(act);
  else act();
}
