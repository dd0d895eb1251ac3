// The part that is chosen: tinted, with its edges seen through all others.

import { EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial } from "three";
import type { Scene, SceneMotion } from "../api/types";
import { EDGE, geometryOf, matrixOf, meshOf } from "./bodies";
import { type Pose, pose } from "./pose";

export class Mark extends Group {
  readonly #motion: SceneMotion | undefined;
  readonly #faces: Mesh;
  readonly #edges: LineSegments;
  readonly #at: Pose = { x: 0, y: 0, z: 0, angle: 0 };

  constructor(
    scene: Scene,
    readonly part: number,
    colour: string,
  ) {
    super();
    const geometry = geometryOf(meshOf(scene, part));
    this.#motion = scene.parts[part]?.motion;
    this.#faces = new Mesh(
      geometry,
      new MeshBasicMaterial({ color: colour, transparent: true, opacity: 0.5, depthWrite: false }),
    );
    this.#edges = new LineSegments(
      new EdgesGeometry(geometry, EDGE),
      new LineBasicMaterial({ color: colour, depthTest: false, transparent: true }),
    );
    this.#faces.renderOrder = this.#edges.renderOrder = 5;
    this.matrixAutoUpdate = false;
    this.add(this.#faces, this.#edges);
  }

  pose(theta: number) {
    if (!this.#motion) return;
    matrixOf(pose(this.#motion, theta, this.#at), this.matrix);
    this.matrixWorldNeedsUpdate = true;
  }

  /** Frees what the graphics card holds. */
  free() {
    for (const one of [this.#faces, this.#edges]) {
      one.geometry.dispose();
      (one.material as MeshBasicMaterial | LineBasicMaterial).dispose();
    }
  }
}
