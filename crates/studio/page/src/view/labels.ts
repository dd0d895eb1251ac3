// Labels at the tips of arrows: none lies on another or out of the picture, and none jumps while arrows turn.

/** A text and the arrow that it belongs to, on the canvas [px]. */
export interface Label {
  /** The same from frame to frame, whatever the text says. */
  id: string;
  label: string;
  colour: string;
  /** Tip of the arrow. */
  x: number;
  y: number;
  /** From its foot to its tip. */
  right: number;
  down: number;
}

/** A label with the middle of its text. */
export interface Placed extends Label {
  middle: { x: number; y: number };
  width: number;
}

type Point = { x: number; y: number };

/** Height of a text with its rim, and the air between a tip and its text [px]. */
export const LINE = 18;
const AIR = 9;
/** Between two texts side by side, and from a text to the rim of the picture [px]. */
const GAP = 6;
const RIM = 4;
/** An arrow shorter than this on the canvas points nowhere in particular: its text lies nearer to its tip [px]. */
const SHORT = 24;
/** How far a text moves in a frame relative to its tip [px], and how far it slides round another [rad]. */
const STEP = 9;
const SLIDE = 0.12;
/** A tip that moves further in a frame has not turned: another view was asked for [px]. */
const LEAP = 90;
const ROUNDS = 40;

const clamp = (x: number, least: number, most: number) => Math.min(Math.max(x, least), Math.max(least, most));
const turnBetween = (from: number, to: number) => Math.atan2(Math.sin(to - from), Math.cos(to - from));

/** Beyond the tip, in the direction of the arrow: it goes round the tip without a leap as the arrow turns. */
function ideal({ x, y, right, down }: Label, width: number): Point {
  const length = Math.hypot(right, down, SHORT);
  return { x: x + (right / length) * (width / 2 + AIR), y: y + (down / length) * (LINE / 2 + AIR) };
}

interface Kept {
  tip: Point;
  middle: Point;
  width: number;
}

/** Lays out the labels of each frame, near to where they were in the frame before. */
export class Layout {
  #kept = new Map<string, Kept>();
  #size = "";

  /** `widthOf`: width of a text [px]. `corner`: width and height of what stands in the lower left corner [px]. */
  constructor(
    private readonly widthOf: (text: string) => number,
    private readonly corner: readonly [number, number] = [0, 0],
  ) {}

  place(labels: readonly Label[], [width, height]: readonly [number, number]): Placed[] {
    const size = `${width} ${height}`;
    const leapt = labels.some((one) => {
      const before = this.#kept.get(one.id);
      return before && Math.hypot(one.x - before.tip.x, one.y - before.tip.y) > LEAP;
    });
    if (leapt || size !== this.#size) this.#kept.clear();
    this.#size = size;

    const boxes = labels.map((one) => {
      const before = this.#kept.get(one.id);
      // A digit more or less does not move the others to and fro.
      const wide = Math.max(this.widthOf(one.label), before?.width ?? 0);
      const wanted = this.#inside(ideal(one, wide), wide, width, height);
      return { one, wide, wanted, middle: before ? this.#drawn(one, before, wanted) : { ...wanted } };
    });
    for (let round = 0; round < ROUNDS; round++) {
      let isFree = true;
      for (const [index, box] of boxes.entries()) {
        box.middle = this.#inside(box.middle, box.wide, width, height);
        for (const other of boxes.slice(0, index)) isFree = this.#part(box, other, round) && isFree;
      }
      if (isFree) break;
    }
    // Where the rim leaves no room on either side: one below the other.
    if (boxes.some((box, index) => boxes.slice(0, index).some((other) => overlap(box, other) !== null)))
      stack(boxes, height);
    this.#kept = new Map(
      boxes.map(({ one, middle, wide }) => [
        one.id,
        { tip: { x: one.x, y: one.y }, middle: { ...middle }, width: wide },
      ]),
    );
    return boxes.map(({ one, middle, wide }) => ({ ...one, middle, width: wide }));
  }

  /** Carried along with its tip, and a step towards where it would stand alone. */
  #drawn(one: Label, before: Kept, wanted: Point): Point {
    const from = {
      x: before.middle.x + one.x - before.tip.x,
      y: before.middle.y + one.y - before.tip.y,
    };
    const far = Math.hypot(wanted.x - from.x, wanted.y - from.y);
    const share = far > STEP ? STEP / far : 1;
    return { x: from.x + share * (wanted.x - from.x), y: from.y + share * (wanted.y - from.y) };
  }

  /** In the picture, beside or above what stands in its corner. */
  #inside({ x, y }: Point, wide: number, width: number, height: number): Point {
    const [left, bottom] = [wide / 2 + RIM, height - LINE / 2 - RIM];
    const [over, up] = [left + this.corner[0] - x, y - (bottom - this.corner[1])];
    const isBeside = over <= 0 || up <= 0 || this.corner[0] === 0;
    const at = isBeside ? { x, y } : over < up ? { x: x + over, y } : { x, y: y - up };
    return { x: clamp(at.x, left, width - left), y: clamp(at.y, LINE / 2 + RIM, bottom) };
  }

  /** Two texts on each other move apart, half the way each; round each other, if they would rather stand the other way. */
  #part(a: Box, b: Box, round: number): boolean {
    const on = overlap(a, b);
    if (!on) return true;
    const { across } = on;
    const now = Math.atan2(on.y, on.x);
    const wish = Math.atan2((a.wanted.y - b.wanted.y) / LINE, (a.wanted.x - b.wanted.x) / across);
    const turned = round === 0 ? now + clamp(turnBetween(now, wish), -SLIDE, SLIDE) : now;
    const [x, y] = [Math.cos(turned), Math.sin(turned)];
    // Just off the edge, so that rounding leaves nothing to part.
    const far = 1.001 / Math.max(Math.abs(x), Math.abs(y));
    const centre = { x: (a.middle.x + b.middle.x) / 2, y: (a.middle.y + b.middle.y) / 2 };
    const half = { x: (x * far * across) / 2, y: (y * far * LINE) / 2 };
    a.middle = { x: centre.x + half.x, y: centre.y + half.y };
    b.middle = { x: centre.x - half.x, y: centre.y - half.y };
    return false;
  }
}

interface Box {
  wide: number;
  wanted: Point;
  middle: Point;
}

/** From `b` to `a` as shares of the distance at which they touch; nothing where they are apart. */
function overlap(a: Box, b: Box): { x: number; y: number; across: number } | null {
  const across = (a.wide + b.wide) / 2 + GAP;
  const [x, y] = [(a.middle.x - b.middle.x) / across, (a.middle.y - b.middle.y) / LINE];
  if (Math.abs(x) >= 1 || Math.abs(y) >= 1) return null;
  // One exactly on the other: below it.
  return x === 0 && y === 0 ? { x: 0, y: 1e-3, across } : { x, y, across };
}

function stack(boxes: Box[], height: number) {
  const sorted = [...boxes].sort((a, b) => a.middle.y - b.middle.y);
  let floor = height - LINE / 2 - RIM;
  for (const box of sorted.reverse()) {
    box.middle.y = Math.min(box.middle.y, floor);
    floor = box.middle.y - 1.001 * LINE;
  }
}

/** Where a line to the tip begins at a text that had to give way; nothing where the text stands at its tip. */
export function leader({ x, y, middle, width }: Placed): { x1: number; y1: number } | null {
  const x1 = clamp(x, middle.x - width / 2, middle.x + width / 2);
  const y1 = clamp(y, middle.y - LINE / 2, middle.y + LINE / 2);
  return Math.hypot(x - x1, y - y1) > 2 * AIR ? { x1, y1 } : null;
}
