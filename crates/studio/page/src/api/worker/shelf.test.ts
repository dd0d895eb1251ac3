import { beforeEach, describe, expect, it } from "vitest";
import { Shelf, type Store } from "./shelf";

beforeEach(() => localStorage.clear());

describe("shelf", () => {
  it("keeps files, and which was open, for the next visit", () => {
    const shelf = new Shelf(localStorage);
    localStorage.setItem("lanchester-theme", "dark");
    expect(shelf.put("a.toml", "one")).toBe(true);
    shelf.open = "a.toml";
    const next = new Shelf(localStorage);
    expect(next.all()).toEqual({ "a.toml": "one" });
    expect(next.open).toBe("a.toml");
  });

  it("says what it has no room for, and holds it as long as the page is open", () => {
    const full: Store = {
      length: 0,
      key: () => null,
      getItem: () => null,
      removeItem: () => undefined,
      setItem: () => {
        throw new DOMException("full", "QuotaExceededError");
      },
    };
    for (const store of [full, undefined]) {
      const shelf = new Shelf(store);
      expect(shelf.put("a.toml", "one")).toBe(false);
      expect(shelf.all()).toEqual({});
      shelf.hold("p.csv", "1");
      expect(shelf.all()).toEqual({ "p.csv": "1" });
      shelf.open = "a.toml";
    }
  });
});
