// Looks of the parts: pictures of a lit ball ("matcaps"), which cost one look-up a pixel.

import { CanvasTexture, LinearFilter, type Texture } from "three";

const SIZE = 256;

function ball(paint: (context: CanvasRenderingContext2D) => void): Texture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = SIZE;
  const context = canvas.getContext("2d");
  if (context) paint(context);
  const texture = new CanvasTexture(canvas);
  // Nothing in these pictures is finer than a part's pixels: smaller copies to choose from would only take time.
  texture.minFilter = LinearFilter;
  texture.generateMipmaps = false;
  return texture;
}

function light(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  radius: number,
  stops: [number, string][],
) {
  const gradient = context.createRadialGradient(x * SIZE, y * SIZE, 0, x * SIZE, y * SIZE, radius * SIZE);
  for (const [at, colour] of stops) gradient.addColorStop(at, colour);
  context.fillStyle = gradient;
  context.fillRect(0, 0, SIZE, SIZE);
}

/** Machined metal, grey: the colour of a part multiplies it. A wide key light from above left, a dim window below right. */
export function metal(dark: boolean): Texture {
  return ball((context) => {
    const sky = context.createLinearGradient(0.2 * SIZE, 0, 0.6 * SIZE, SIZE);
    sky.addColorStop(0, "#ffffff");
    sky.addColorStop(0.42, dark ? "#eef1f5" : "#f4f6f8");
    sky.addColorStop(0.58, dark ? "#cfd5dc" : "#dce1e6");
    sky.addColorStop(0.76, dark ? "#98a1ad" : "#a9b1bc");
    sky.addColorStop(1, dark ? "#6a7380" : "#868f9b");
    context.fillStyle = sky;
    context.fillRect(0, 0, SIZE, SIZE);
    // The rim turns away from the lights.
    light(context, 0.5, 0.5, 0.5, [
      [0, "rgb(10 16 26 / 0%)"],
      [0.72, "rgb(10 16 26 / 0%)"],
      [0.95, "rgb(10 16 26 / 30%)"],
      [1, "rgb(10 16 26 / 48%)"],
    ]);
    light(context, 0.34, 0.28, 0.3, [
      [0, "rgb(255 255 255 / 100%)"],
      [0.35, "rgb(255 255 255 / 55%)"],
      [1, "rgb(255 255 255 / 0%)"],
    ]);
    light(context, 0.76, 0.8, 0.24, [
      [0, "rgb(214 230 255 / 50%)"],
      [1, "rgb(214 230 255 / 0%)"],
    ]);
  });
}

/** Thin glass, seen by its rim: added to a dark ground, multiplied with a light one. */
export function glass(dark: boolean): Texture {
  return ball((context) => {
    light(context, 0.5, 0.5, 0.5, [
      [0, dark ? "#020304" : "#fcfdfe"],
      [0.6, dark ? "#030507" : "#f7f9fc"],
      [0.88, dark ? "#0b1119" : "#e9eff5"],
      [0.97, dark ? "#1b2939" : "#cad8e6"],
      [1, dark ? "#26384c" : "#b9cadb"],
    ]);
  });
}
