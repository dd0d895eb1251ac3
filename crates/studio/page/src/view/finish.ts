// Materials of a theme, and parts dressed in them.

import {
  AddEquation,
  AdditiveBlending,
  CustomBlending,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Mesh,
  type Object3D,
  SrcColorFactor,
  type Texture,
  ZeroFactor,
} from "three";
import type { Body } from "./bodies";
import type { Group } from "./groups";
import { glass, metal } from "./metal";
import { Sheen } from "./sheen";

export interface Look {
  dark: boolean;
  ground: string;
  ink: string;
  /** Of the part that is chosen. */
  mark: string;
}

export class Finish {
  readonly #steel: Texture;
  readonly #clear: Texture;
  readonly #lines: LineBasicMaterial;
  readonly #faint: LineBasicMaterial;
  readonly #metals = new Map<string, Material>();

  constructor(private readonly look: Look) {
    this.#steel = metal(look.dark);
    this.#clear = glass(look.dark);
    this.#lines = new LineBasicMaterial({
      color: look.dark ? "#05070a" : "#1b2430",
      transparent: true,
      opacity: look.dark ? 0.55 : 0.42,
    });
    this.#faint = new LineBasicMaterial({
      color: look.ink,
      transparent: true,
      opacity: 0.16,
      depthWrite: false,
    });
  }

  /** Faces and edges of a body. */
  dressed(body: Body): Object3D[] {
    const isGlass = body.group.id === "bore";
    const known = this.#metals.get(body.group.id);
    const material = known ?? (isGlass ? this.#glass() : this.#metal(body.group));
    this.#metals.set(body.group.id, material);
    const faces = new Mesh(body.geometry, material);
    faces.userData.body = body;
    const edges = new LineSegments(body.edges, isGlass ? this.#faint : this.#lines);
    if (isGlass) {
      faces.renderOrder = 2;
      edges.renderOrder = 3;
    }
    return [faces, edges];
  }

  #metal(group: Group): Material {
    const isWeight = group.id === "weight" || group.id === "shaft-weight";
    return new Sheen(this.#steel, this.look.dark ? group.dark : group.light, {
      // Where a weight and its web share a face the weight is seen; edges are seen on both.
      polygonOffset: true,
      polygonOffsetFactor: isWeight ? 1 : 2,
      polygonOffsetUnits: isWeight ? 2 : 8,
    });
  }

  /** Added to a dark ground, multiplied with a light one: no order of drawing is needed. */
  #glass(): Material {
    return new Sheen(this.#clear, "white", {
      depthWrite: false,
      transparent: true,
      ...(this.look.dark
        ? { blending: AdditiveBlending }
        : {
            blending: CustomBlending,
            blendEquation: AddEquation,
            blendSrc: ZeroFactor,
            blendDst: SrcColorFactor,
          }),
    });
  }

  /** Frees what the graphics card holds. */
  free() {
    const things = [this.#steel, this.#clear, this.#lines, this.#faint, ...this.#metals.values()];
    for (const thing of things) thing.dispose();
  }
}
