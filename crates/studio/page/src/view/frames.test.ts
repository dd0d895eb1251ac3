import { expect, test } from "vitest";
import { FrameClock } from "./frames";

test("the rate is that of the last second", () => {
  const clock = new FrameClock();
  expect(clock.rate).toBeNull();
  for (let at = 0; at <= 500; at += 100) {
    clock.begin(at);
    clock.end(at + 30);
  }
  for (let at = 1600; at <= 2600; at += 25) {
    clock.begin(at);
    clock.end(at + 10);
  }
  expect(clock.rate?.frames).toBeCloseTo(40, 6);
  expect(clock.rate?.between).toBeCloseTo(25, 6);
  expect(clock.rate?.work).toBeCloseTo(10, 6);
});
