import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";

/** Relative luminance of WCAG 2.1. */
function luminance(colour: string): number {
  const [red, green, blue] = [1, 3, 5].map((at) => {
    const part = parseInt(colour.slice(at, at + 2), 16) / 255;
    return part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red! + 0.7152 * green! + 0.0722 * blue!;
}

function contrast(a: string, b: string): number {
  const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (light! + 0.05) / (dark! + 0.05);
}

const style = readFileSync("src/style.css", "utf8");
const THEMES = [
  ["light", /:root \{([^}]*)\}/],
  ["dark", /:root\[data-theme="dark"\] \{([^}]*)\}/],
] as const;

describe.each(THEMES)("colours of the %s theme", (_, block) => {
  const tokens = new Map(
    [...(block.exec(style)?.[1] ?? "").matchAll(/--([\w-]+): (#[0-9a-f]{6});/g)].map((match) => [
      match[1]!,
      match[2]!,
    ]),
  );
  const between = (a: string, b: string) => contrast(tokens.get(a)!, tokens.get(b)!);

  it("hold AA for text on every ground it stands on", () => {
    const words = ["ink", "quiet", "accent", "good", "warn", "bad"];
    for (const word of words) {
      for (const ground of ["ground", "panel", "sunk"]) {
        expect(between(word, ground), `${word} on ${ground}`).toBeGreaterThanOrEqual(4.5);
      }
    }
    for (const word of ["accent", "good", "warn", "bad"]) {
      expect(between(word, `${word}-ground`), word).toBeGreaterThanOrEqual(4.5);
    }
    expect(between("on-accent", "accent")).toBeGreaterThanOrEqual(4.5);
  });

  it("hold AA for lines of plots and edges of fields", () => {
    for (const line of ["strong-line", ...[1, 2, 3, 4, 5, 6].map((number) => `series-${number}`)]) {
      expect(between(line, "panel"), line).toBeGreaterThanOrEqual(3);
    }
  });
});
