import { existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { join, resolve } from "node:path";
import { describe, expect, it } from "vitest";
import { blocks, inline, section, slug } from "./section";
import { TERMS, ofKey, ofTitle } from "./terms";

const BOOK = resolve("../../../docs/src");

/** All components of the page. */
function sources(folder: string): string[] {
  return readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? sources(path) : path.endsWith(".svelte") ? [path] : [];
  });
}

describe("terms", () => {
  it("lead to a page and a heading of the book", () => {
    for (const { name, book } of TERMS) {
      const [page = "", anchor = ""] = book.split("#");
      const path = join(BOOK, `${page}.md`);
      expect(existsSync(path), `${name}: ${path}`).toBe(true);
      const found = section(readFileSync(path, "utf8"), anchor);
      expect(found, `${name}: ${book}`).not.toBeNull();
      expect(blocks(found ?? "").length, `${name}: ${book}`).toBeGreaterThan(1);
    }
  });
  it("have one explanation each, a sentence", () => {
    expect(new Set(TERMS.map(({ name }) => name)).size).toBe(TERMS.length);
    for (const { name, words } of TERMS) expect(words, name).toMatch(/^[A-Z].*\.$/);
  });
  it("are those of titles of plots and of keys of the file", () => {
    const known = new Set<string | undefined>(TERMS.map(({ name }) => name));
    const of = [
      "Force on the block",
      "Roll moment by order",
      "Hodograph of the couple",
      "Campbell diagram",
    ].map(ofTitle);
    expect(of).toEqual(["shaking force", "order", "ellipse of an order", "critical speed"]);
    expect(ofTitle("Piston position")).toBeUndefined();
    const keys = ["layout.spacing", "shaft[1].weights", "mount[2].loss_factor", "piston.mass", "gas.file"];
    for (const key of keys) expect(known.has(ofKey(key)), key).toBe(true);
    expect(ofKey("layout.spacing")).toBe("cylinder spacing");
    expect(ofKey("name")).toBeUndefined();
  });
  it("are known wherever the page explains one", () => {
    const used = sources(resolve("src")).flatMap((path) =>
      [...readFileSync(path, "utf8").matchAll(/<Term of="([^"]+)"/g)].map(([, name = ""]) => name),
    );
    expect(used.length).toBeGreaterThan(20);
    const known = new Set(TERMS.map(({ name }) => name));
    expect(used.filter((name) => !known.has(name))).toEqual([]);
  });
});

describe("a section of the book", () => {
  const page =
    "# Page\n\nFirst.\n\n## One (1.2)\n\nText *a* of `b`.\n\n```formula\n# no heading\n```\n\n### Below\n\n## Two\n";
  it("is found by its anchor and ends at the next heading of its rank", () => {
    expect(slug("The cylinder's own frame")).toBe("the-cylinders-own-frame");
    expect(section(page, "one-12")).toBe(
      "## One (1.2)\n\nText *a* of `b`.\n\n```formula\n# no heading\n```\n\n### Below",
    );
    expect(section(page, "")).toBe("# Page\n\nFirst.");
    expect(section(page, "three")).toBeNull();
  });
  it("is taken apart into what can be shown", () => {
    expect(blocks(section(page, "one-12") ?? "").map(({ kind }) => kind)).toEqual([
      "heading",
      "paragraph",
      "code",
      "heading",
    ]);
    expect(inline("a **b** [c](d.md) `e`")).toEqual([
      { kind: "text", text: "a " },
      { kind: "strong", text: "b" },
      { kind: "text", text: " " },
      { kind: "text", text: "c" },
      { kind: "text", text: " " },
      { kind: "code", text: "e" },
    ]);
    const [table] = blocks("| a | b |\n|---|---|\n| 1 | x \\| y |");
    expect(table).toMatchObject({ kind: "table", rows: [[[{ text: "1" }], [{ text: "x | y" }]]] });
  });
});
