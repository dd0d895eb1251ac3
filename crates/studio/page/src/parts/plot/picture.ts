// What is seen as a file of its own: SVG with its colours and fonts written out, and PNG.

export interface Key {
  name: string;
  /** As the page writes it: `var(--series-1)`. */
  colour: string;
  dash: string;
  /** A patch in place of a line. */
  filled: boolean;
}

const STYLES = [
  "fill",
  "fill-opacity",
  "stroke",
  "stroke-width",
  "stroke-opacity",
  "stroke-dasharray",
  "stroke-linejoin",
  "stroke-linecap",
  "opacity",
  "paint-order",
  "font-family",
  "font-size",
  "font-weight",
  "text-anchor",
  "dominant-baseline",
] as const;
/** What SVG assumes by itself. */
const ASSUMED: Record<string, string> = {
  "fill-opacity": "1",
  "stroke-opacity": "1",
  "stroke-dasharray": "none",
  stroke: "none",
  opacity: "1",
  "paint-order": "normal",
  "stroke-linejoin": "miter",
  "stroke-linecap": "butt",
  "text-anchor": "start",
  "dominant-baseline": "auto",
};
const NAMESPACE = "http://www.w3.org/2000/svg";
const ROW = 18;

/** `svg` without what only a screen needs (`data-screen`), with title and legend above. */
export function standalone(svg: SVGSVGElement, title: string, keys: readonly Key[]): string {
  const { width, height } = svg.getBoundingClientRect();
  const copy = svg.cloneNode(true) as SVGSVGElement;
  writeOut(svg, copy);
  for (const element of copy.querySelectorAll("[data-screen]")) element.remove();
  const style = getComputedStyle(svg);
  const family = style.fontFamily;
  const ink = style.getPropertyValue("--ink").trim();
  const lines = laidOut(keys, width, family);
  const top = 26 + ROW * (lines.at(-1)?.line ?? -1) + (lines.length ? ROW : 0) + 4;

  const out = document.createElementNS(NAMESPACE, "svg");
  const whole = { width: round(width), height: round(height + top) };
  out.setAttribute("xmlns", NAMESPACE);
  out.setAttribute("width", String(whole.width));
  out.setAttribute("height", String(whole.height));
  out.setAttribute("viewBox", `0 0 ${whole.width} ${whole.height}`);
  const add = (parent: Element, name: string, attributes: Record<string, string | number>, text = "") => {
    const element = document.createElementNS(NAMESPACE, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
    element.textContent = text;
    parent.append(element);
    return element;
  };
  add(out, "title", {}, title);
  add(out, "rect", {
    width: whole.width,
    height: whole.height,
    fill: style.getPropertyValue("--panel").trim(),
  });
  const font = { "font-family": family, fill: ink };
  add(out, "text", { x: 8, y: 19, ...font, "font-size": 14, "font-weight": 650 }, title);
  for (const { key, x, line } of lines) {
    const y = 26 + ROW * line + ROW / 2;
    const drawn = colourOf(svg, key.colour);
    if (key.filled) add(out, "rect", { x, y: y - 5, width: 18, height: 10, fill: drawn });
    else
      add(out, "path", {
        d: `M${x} ${y}h18`,
        stroke: drawn,
        "stroke-width": 2,
        "stroke-dasharray": key.dash || "none",
      });
    add(out, "text", { x: x + 24, y: y + 4, ...font, "font-size": 12 }, key.name);
  }
  const inner = add(out, "g", { transform: `translate(0 ${top})` });
  inner.append(...copy.childNodes);
  return new XMLSerializer().serializeToString(out);
}

/** Copies what style sheets say onto the elements themselves. */
function writeOut(from: Element, to: Element) {
  const style = getComputedStyle(from);
  for (const name of STYLES) {
    const value = style.getPropertyValue(name);
    if (value && value !== ASSUMED[name]) to.setAttribute(name, value);
  }
  to.removeAttribute("class");
  to.removeAttribute("style");
  for (let i = 0; i < from.children.length; i++) {
    writeOut(from.children[i] as Element, to.children[i] as Element);
  }
}

function colourOf(beside: Element, colour: string): string {
  const probe = document.createElementNS(NAMESPACE, "rect");
  probe.style.fill = colour;
  beside.append(probe);
  const found = getComputedStyle(probe).fill;
  probe.remove();
  return found;
}

function laidOut(keys: readonly Key[], width: number, family: string) {
  const pen = document.createElement("canvas").getContext("2d");
  if (pen) pen.font = `12px ${family}`;
  let [x, line] = [8, 0];
  return keys.map((key) => {
    const wide = 24 + (pen?.measureText(key.name).width ?? 7 * key.name.length) + 16;
    if (x > 8 && x + wide > width) [x, line] = [8, line + 1];
    const at = { key, x: round(x), line };
    x += wide;
    return at;
  });
}

function round(value: number): number {
  return Math.round(value * 10) / 10;
}

/** Drawn at `times` the size on the screen. */
export async function png(svg: string, times = 2): Promise<Blob> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = Math.round(image.width * times);
  canvas.height = Math.round(image.height * times);
  const pen = canvas.getContext("2d");
  if (!pen) throw new Error("the browser has no canvas");
  pen.scale(times, times);
  pen.drawImage(image, 0, 0);
  return new Promise((done, fail) =>
    canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error("the picture is too large"))), "image/png"),
  );
}

export function download(content: Blob | string, name: string, type = "text/plain") {
  const blob = typeof content === "string" ? new Blob([content], { type: `${type};charset=utf-8` }) : content;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
