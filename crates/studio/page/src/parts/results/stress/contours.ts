// Faces with bands of colour, and edges, that move by a factor times their displacement: nothing is reckoned for a new factor.

import { Color, DoubleSide, LineBasicMaterial, ShaderMaterial } from "three";
import { ABOVE, BANDS } from "./palette";

const MOVED = `
attribute vec3 moved;
uniform float factor;
`;

const FACE = `${MOVED}
attribute float value;
varying float shown;
varying vec3 eye;

void main() {
  vec4 place = modelViewMatrix * vec4(position + factor * moved, 1.0);
  shown = value;
  eye = place.xyz;
  gl_Position = projectionMatrix * place;
}`;

// The light comes from the eye's upper left; each triangle is flat, so that nothing is smoothed over sharp edges.
const PIXEL = `
uniform vec3 bands[${BANDS.length}];
uniform vec3 above;
varying float shown;
varying vec3 eye;

void main() {
  vec3 away = normalize(cross(dFdx(eye), dFdy(eye)));
  float light = 0.66 + 0.34 * max(0.0, dot(away, normalize(vec3(-0.3, 0.45, 0.85))));
  vec3 colour = shown > 1.0 ? above : bands[int(clamp(floor(shown * ${BANDS.length}.0), 0.0, ${BANDS.length - 1}.0))];
  gl_FragColor = vec4(colour * light, 1.0);
}`;

const EDGE = `${MOVED}
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position + factor * moved, 1.0);
}`;

const LINE = `
uniform vec3 ink;

void main() {
  gl_FragColor = vec4(ink, 0.55);
}`;

export class Contours {
  readonly faces = new ShaderMaterial({
    uniforms: {
      factor: { value: 0 },
      bands: { value: BANDS.map((band) => new Color(band)) },
      above: { value: new Color(ABOVE) },
    },
    vertexShader: FACE,
    fragmentShader: PIXEL,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 2,
  });
  readonly edges = new ShaderMaterial({
    uniforms: { factor: { value: 0 }, ink: { value: new Color("#05070a") } },
    vertexShader: EDGE,
    fragmentShader: LINE,
    transparent: true,
  });
  /** Of the crankshaft where no load acts. */
  readonly ghost = new LineBasicMaterial({ transparent: true, opacity: 0.5 });

  set factor(factor: number) {
    for (const { uniforms } of [this.faces, this.edges]) if (uniforms.factor) uniforms.factor.value = factor;
  }

  set ink(ink: string) {
    this.ghost.color.set(ink);
  }

  free() {
    for (const material of [this.faces, this.edges, this.ghost]) material.dispose();
  }
}
