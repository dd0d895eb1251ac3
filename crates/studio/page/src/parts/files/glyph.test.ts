import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { describe, expect, it } from "vitest";
import { glyph } from "./glyph";

const template = (name: string) => readFileSync(resolve(`../../file/templates/${name}.toml`), "utf8");

describe("glyph", () => {
  it.each([
    ["in-line-3", [0], 3],
    ["v6-60", [-30, 30], 6],
    ["boxer-4", [-90, 90], 4],
    ["w12-broad-arrow", [-60, 0, 60], 12],
    ["radial-5", [0, 72, 144, 216, 288], 5],
    ["radial-14", [0, 1, 2, 3, 4, 5, 6].map((at) => (at * 360) / 7), 14],
    ["square-4", [0], 4],
    ["opposed-piston-3", [0, 180], 6],
  ])("of %s", (name, angles, cylinders) => {
    expect(glyph(template(name))).toEqual({ angles, cylinders });
  });
});
