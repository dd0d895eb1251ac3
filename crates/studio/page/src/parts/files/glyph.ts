// A sign for a layout, seen along the crank: read off the file of a template.

export interface Glyph {
  /** Directions of the cylinders, clockwise from up [degrees]. */
  angles: number[];
  cylinders: number;
}

export function glyph(text: string): Glyph {
  const layout = /^\[layout\]([\s\S]*?)(^\[|(?![\s\S]))/m.exec(text)?.[1] ?? "";
  const type = /^type\s*=\s*"([a-z-]+)"/m.exec(layout)?.[1];
  const count = Number(/^cylinders\s*=\s*(\d+)/m.exec(layout)?.[1] ?? 1);
  const bank = Number(/^bank_angle\s*=\s*"([\d.]+) deg"/m.exec(layout)?.[1] ?? 0);
  const rows = Number(/^rows\s*=\s*(\d+)/m.exec(layout)?.[1] ?? 1);
  switch (type) {
    case "v":
    case "vr":
      return { angles: [-bank / 2, bank / 2], cylinders: count };
    case "boxer":
    case "flat":
      return { angles: [-90, 90], cylinders: count };
    case "w":
      return {
        angles: [...layout.matchAll(/angle\s*=\s*"(-?[\d.]+) deg"/g)].map((found) => Number(found[1])),
        cylinders: count,
      };
    case "radial":
      return {
        angles: Array.from({ length: count }, (_, at) => (at * 360) / count),
        cylinders: count * rows,
      };
    case undefined: {
      const own = [...text.matchAll(/^\[\[cylinder\]\][\s\S]*?^angle\s*=\s*"(-?[\d.]+) deg"/gm)];
      return { angles: [...new Set(own.map((found) => Number(found[1])))], cylinders: own.length };
    }
    default:
      return { angles: [0], cylinders: count };
  }
}
