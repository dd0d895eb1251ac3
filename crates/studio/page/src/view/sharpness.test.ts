import { describe, expect, test } from "vitest";
import { Sharpness } from "./sharpness";

/** Half a second of frames as a machine draws them: `fixed` ms and `full` ms for all pixels. */
function drawn(sharpness: Sharpness, fixed: number, full: number) {
  for (let k = 0; k < 15; k++) sharpness.frame(fixed + full * sharpness.ratio ** 2);
}

describe("sharpness of moving pictures", () => {
  test("is full where frames come in time", () => {
    const sharpness = new Sharpness();
    for (let k = 0; k < 20; k++) drawn(sharpness, 8, 24);
    expect(sharpness.ratio).toBe(1);
  });

  test("gives way to the goal and goes no further than it must", () => {
    const sharpness = new Sharpness();
    for (let k = 0; k < 20; k++) drawn(sharpness, 8, 40);
    expect(sharpness.ratio).toBe(0.8);
  });

  test("has an end, however slow the frames are", () => {
    const sharpness = new Sharpness();
    for (let k = 0; k < 20; k++) drawn(sharpness, 200, 40);
    expect(sharpness.ratio).toBe(0.6);
  });

  test("comes back where there is time, and does not swing", () => {
    const sharpness = new Sharpness();
    for (let k = 0; k < 20; k++) drawn(sharpness, 8, 60);
    expect(sharpness.ratio).toBe(0.6);
    const ratios = new Set<number>();
    for (let k = 0; k < 40; k++) {
      drawn(sharpness, 8, 40);
      if (k >= 20) ratios.add(sharpness.ratio);
    }
    expect([...ratios]).toEqual([0.7]);
    for (let k = 0; k < 20; k++) drawn(sharpness, 4, 12);
    expect(sharpness.ratio).toBe(1);
  });

  test("one slow frame changes nothing", () => {
    const sharpness = new Sharpness();
    sharpness.frame(90);
    for (let k = 0; k < 29; k++) sharpness.frame(20);
    expect(sharpness.ratio).toBe(1);
  });
});
