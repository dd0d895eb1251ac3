import { expect, test } from "vitest";
import { listed } from "./task.svelte";

test("what is typed with commas between is a list, empty ones left out", () => {
  expect(listed("")).toEqual([]);
  expect(listed(" 2000 rpm ,, 4000 rpm,")).toEqual(["2000 rpm", "4000 rpm"]);
  expect(listed("force = 1 %, couple = 2 N m")).toEqual(["force = 1 %", "couple = 2 N m"]);
});
