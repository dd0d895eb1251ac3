import { expect, test } from "vitest";
import { orderName, orderTitle } from "./order";

test("orders are decimals, as short as they are", () => {
  expect([0.5, 1, 4.5, 3.0000000001, 4 / 3].map(orderName)).toEqual(["0.5", "1", "4.5", "3", "1.333"]);
  expect(orderTitle(4.5)).toBe("order 4.5");
});
