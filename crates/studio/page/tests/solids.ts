// What files for CAD hold, read as another program would.

import { expect } from "@playwright/test";

type Vector = [number, number, number];

export interface Mesh {
  triangles: number;
  /** In the unit of the file, cubed. */
  volume: number;
  least: Vector;
  most: Vector;
}

/** A binary STL; every edge must be shared by two triangles that run along it in opposite senses, or it encloses nothing. */
export function stl(file: Buffer): Mesh {
  const triangles = file.readUInt32LE(80);
  expect(file.length, "length of a binary STL").toBe(84 + 50 * triangles);
  const edges = new Map<string, number>();
  const mesh: Mesh = {
    triangles,
    volume: 0,
    least: [Infinity, Infinity, Infinity],
    most: [-Infinity, -Infinity, -Infinity],
  };
  for (let at = 84; at < file.length; at += 50) {
    const corner = (n: number) =>
      [0, 4, 8].map((offset) => file.readFloatLE(at + 12 + 12 * n + offset)) as Vector;
    const [a, b, c] = [corner(0), corner(1), corner(2)];
    mesh.volume += determinant(a, b, c) / 6;
    for (const one of [a, b, c])
      one.forEach((value, axis) => {
        mesh.least[axis] = Math.min(mesh.least[axis]!, value);
        mesh.most[axis] = Math.max(mesh.most[axis]!, value);
      });
    for (const [from, to] of [
      [a, b],
      [b, c],
      [c, a],
    ] as const) {
      const [key, sense] =
        from.join() < to.join() ? [`${from.join()}|${to.join()}`, 1] : [`${to.join()}|${from.join()}`, -1];
      edges.set(key, (edges.get(key) ?? 0) + sense);
    }
  }
  expect(
    [...edges.values()].filter((sum) => sum !== 0).length,
    "edges with a triangle on one side alone",
  ).toBe(0);
  return mesh;
}

function determinant([a, b, c]: Vector, [d, e, f]: Vector, [g, h, i]: Vector): number {
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}

/** Solids of a STEP file. */
export function step(file: Buffer): { solids: number; unit: string } {
  const text = file.toString("utf8");
  expect(text).toMatch(/^ISO-10303-21;\s*HEADER;/);
  expect(text.trimEnd()).toMatch(/ENDSEC;\s*END-ISO-10303-21;$/);
  const named = new Set([...text.matchAll(/^#(\d+)\s*=/gm)].map((found) => found[1]));
  const used = [...text.matchAll(/[(,]#(\d+)/g)].map((found) => found[1]);
  expect(
    used.filter((number) => !named.has(number)),
    "numbers that stand for nothing",
  ).toEqual([]);
  return {
    solids: [...text.matchAll(/=\s*MANIFOLD_SOLID_BREP\(/g)].length,
    unit: /SI_UNIT\((\.\w+\.),\.METRE\.\)/.exec(text)?.[1] ?? "",
  };
}

/** Names of the bodies of a binary glTF. */
export function glb(file: Buffer): { bodies: string[] } {
  expect(file.toString("latin1", 0, 4)).toBe("glTF");
  expect(file.readUInt32LE(4), "version").toBe(2);
  expect(file.readUInt32LE(8), "length").toBe(file.length);
  const length = file.readUInt32LE(12);
  expect(file.toString("latin1", 16, 20)).toBe("JSON");
  const scene = JSON.parse(file.toString("utf8", 20, 20 + length)) as {
    nodes: { name?: string; mesh?: number }[];
    buffers: { byteLength: number }[];
  };
  const binary = file.readUInt32LE(20 + length);
  expect(file.toString("latin1", 24 + length, 27 + length)).toBe("BIN");
  expect(scene.buffers[0]?.byteLength).toBeLessThanOrEqual(binary);
  return { bodies: scene.nodes.filter((node) => node.mesh !== undefined).map((node) => node.name ?? "") };
}

/** Closed contours of a DXF as areas, arcs included, the outer ones positive. */
export function dxf(file: Buffer): { area: number; contours: number } {
  const lines = file
    .toString("utf8")
    .split(/\r?\n/)
    .map((line) => line.trim());
  const pairs = Array.from({ length: Math.floor(lines.length / 2) }, (_, at) => ({
    code: Number(lines[2 * at]),
    value: lines[2 * at + 1] ?? "",
  }));
  expect(pairs.find((pair) => pair.code === 0)?.value).toBe("SECTION");
  expect(pairs.findLast((pair) => pair.code === 0)?.value).toBe("EOF");
  const contours: { x: number; y: number; bulge: number }[][] = [];
  let entity = "";
  for (const { code, value } of pairs) {
    if (code === 0) entity = value;
    if (code === 0 && value === "POLYLINE") contours.push([]);
    if (code === 0 && value === "VERTEX") contours.at(-1)?.push({ x: 0, y: 0, bulge: 0 });
    const vertex = entity === "VERTEX" ? contours.at(-1)?.at(-1) : undefined;
    if (!vertex) continue;
    if (code === 10) vertex.x = Number(value);
    if (code === 20) vertex.y = Number(value);
    if (code === 42) vertex.bulge = Number(value);
  }
  const areas = contours.map((corners) =>
    corners.reduce((sum, from, at) => {
      const to = corners[(at + 1) % corners.length]!;
      // A bulge is the tangent of a quarter of the arc's angle; a positive one runs anticlockwise.
      const angle = 4 * Math.atan(from.bulge);
      const chord = Math.hypot(to.x - from.x, to.y - from.y);
      const radius = chord / (2 * Math.sin(angle / 2));
      const segment = from.bulge === 0 ? 0 : (radius ** 2 * (angle - Math.sin(angle))) / 2;
      return sum + (from.x * to.y - to.x * from.y) / 2 + segment;
    }, 0),
  );
  return { area: areas.reduce((sum, area) => sum + area, 0), contours: contours.length };
}
