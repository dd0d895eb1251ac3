import { describe, expect, it } from "vitest";
import { type Label, LINE, Layout, type Placed, leader } from "./labels";

const SIZE = [800, 450] as const;
const widthOf = (text: string) => 7.5 * text.length;

function label(id: string, x: number, y: number, right = 0, down = 0): Label {
  return { id, label: `${id} 1234 N m`, colour: "red", x, y, right, down };
}

/** Boxes of the texts: left, right, top, bottom. */
const box = ({ middle, width }: Placed) => ({
  left: middle.x - width / 2,
  right: middle.x + width / 2,
  top: middle.y - LINE / 2,
  bottom: middle.y + LINE / 2,
});

function readable(placed: Placed[]) {
  for (const [index, one] of placed.entries()) {
    const a = box(one);
    expect(a.left).toBeGreaterThanOrEqual(0);
    expect(a.right).toBeLessThanOrEqual(SIZE[0]);
    expect(a.top).toBeGreaterThanOrEqual(0);
    expect(a.bottom).toBeLessThanOrEqual(SIZE[1]);
    for (const other of placed.slice(0, index)) {
      const b = box(other);
      const isApart = a.left >= b.right || b.left >= a.right || a.top >= b.bottom || b.top >= a.bottom;
      expect(isApart, `${one.label} on ${other.label}`).toBe(true);
    }
  }
}

/** Arrows that turn about one foot at their own rates, frame by frame; the longest step of a text relative to its tip. */
function turning(rates: number[], reach: number[], foot = { x: 400, y: 225 }): number {
  const layout = new Layout(widthOf, [90, 90]);
  let before: Placed[] = [];
  let most = 0;
  for (let frame = 0; frame < 1440; frame++) {
    const labels = rates.map((rate, index) => {
      const angle = (rate * frame * Math.PI) / 360 + 0.3 * index;
      const [right, down] = [
        (reach[index] ?? 0) * Math.cos(angle),
        0.6 * (reach[index] ?? 0) * Math.sin(angle),
      ];
      return label("FMZ"[index] ?? "", foot.x + right, foot.y + down, right, down);
    });
    const placed = layout.place(labels, SIZE);
    readable(placed);
    for (const [index, one] of placed.entries()) {
      const last = before[index];
      if (!last) continue;
      const moved = (of: Placed) => ({ x: of.middle.x - of.x, y: of.middle.y - of.y });
      most = Math.max(most, Math.hypot(moved(one).x - moved(last).x, moved(one).y - moved(last).y));
    }
    before = placed;
  }
  return most;
}

describe("labels", () => {
  it("stand beyond their tips where there is room", () => {
    const [one] = new Layout(widthOf).place([label("F", 400, 200, 300, 0)], SIZE);
    expect(box(one as Placed).left).toBeGreaterThan(400);
    const [two] = new Layout(widthOf).place([label("F", 400, 200, 0, -300)], SIZE);
    expect(two?.middle.x).toBeCloseTo(400);
    expect(box(two as Placed).bottom).toBeLessThan(200);
  });
  it("never lie on each other, also where all arrows end in one point or at the rim", () => {
    for (const [x, y] of [
      [400, 200],
      [799, 449],
      [0, 0],
      [2, 448],
      [-50, 225],
      [400, 600],
    ] as const)
      readable(
        new Layout(widthOf).place(
          ["F", "M", "Mz"].map((id) => label(id, x, y)),
          SIZE,
        ),
      );
  });
  it("that had to give way have a line to their tips", () => {
    const placed = new Layout(widthOf).place(
      ["F", "M", "Mz", "a", "b"].map((id) => label(id, 400, 200)),
      SIZE,
    );
    readable(placed);
    expect(placed.filter((one) => leader(one) !== null)).not.toHaveLength(0);
    expect(leader(new Layout(widthOf).place([label("F", 400, 200, 300, 0)], SIZE)[0] as Placed)).toBeNull();
  });
  it("keep out of the corner", () => {
    const [one] = new Layout(widthOf, [90, 90]).place([label("F", 5, 445)], SIZE);
    const { left, bottom } = box(one as Placed);
    expect(left >= 90 || bottom <= SIZE[1] - 90).toBe(true);
  });
  it("do not jump while arrows turn past each other", () => {
    // Against each other, at twice the speed as in second order, short ones, and about a foot at the rim.
    expect(turning([1, -1], [150, 150])).toBeLessThan(40);
    expect(turning([1, 2, 1], [160, 90, 120])).toBeLessThan(40);
    expect(turning([1, -2, 3], [20, 30, 10])).toBeLessThan(40);
    expect(turning([1, -1, 1], [120, 120, 20], { x: 60, y: 400 })).toBeLessThan(60);
  });
});
