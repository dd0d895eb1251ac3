// Labels that do not lie on each other.

export interface Label {
  label: string;
  x: number;
  y: number;
  /** Ends at its place in place of beginning there. */
  left: boolean;
}

/** From line to line, and how near beside each other two stand in each other's way [px]. */
const LINE = 17;
const WIDE = 110;

function middle({ x, left }: Label): number {
  return x + (left ? -WIDE / 2 : WIDE / 2);
}

/** The same labels, the lower ones moved down as far as they must be. */
export function apart(labels: readonly Label[]): Label[] {
  const placed: Label[] = [];
  for (const one of [...labels].sort((a, b) => a.y - b.y)) {
    let y = one.y;
    for (const other of placed) {
      if (Math.abs(middle(other) - middle(one)) < WIDE && y - other.y < LINE) y = Math.max(y, other.y + LINE);
    }
    placed.push({ ...one, y });
  }
  return placed;
}
