import { describe, expect, it } from "vitest";
import { askedFor, missing } from "./typical.svelte";

describe("typical values", () => {
  const file =
    (...paths: string[]) =>
    (path: string) =>
      paths.includes(path);

  it("are offered for sections that the file does not have", () => {
    expect(missing(["gas", "friction"], file("friction"))).toEqual(["gas"]);
    expect(missing(["block", "mount"], file())).toEqual(["block", "mount"]);
    expect(missing(["gas"], file("gas"))).toEqual([]);
  });

  it("are offered for what a message asks for first", () => {
    const inertia =
      "free speed needs the moment of inertia of the crankshaft: give `inertia` in [flywheel], or [crank.body]";
    expect(askedFor(inertia)).toBe("flywheel");
    expect(askedFor("the block cannot move: the file has no [[mount]]; add it")).toBe("mount");
    expect(askedFor("the file has no [layout]; give [flywheel]")).toBeUndefined();
    expect(askedFor("the load never ends")).toBeUndefined();
  });

  it("are offered for details of a table where the table is there", () => {
    expect(missing(["crank"], file("crank"))).toEqual(["crank.web_distance", "crank.body", "crank.material"]);
    expect(missing(["crank"], file())).toEqual([]);
    expect(missing(["counterweights"], file())).toEqual([]);
  });
});
