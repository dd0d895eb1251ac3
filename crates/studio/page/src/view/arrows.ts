// Arrows of forces, and rings with an arrow head for couples.

import {
  BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  TorusGeometry,
  Vector3,
} from "three";

/** What an arrow shows: a vector across the crank, or about the crank axis. */
export interface Shown {
  id: string;
  colour: string;
  kind: "force" | "couple" | "roll";
  /** As a share of the largest that is shown with the same length. */
  x: number;
  y: number;
  /** What stands at its tip; nothing where many would only hide each other. */
  label?: string;
  /** About z; for `roll`. */
  z?: number;
}

const UP = new Vector3(0, 1, 0);
const ALONG = new Vector3(0, 0, 1);
/** Part of a turn that the ring of a couple goes round. */
const ROUND = 1.5 * Math.PI;

/** One arrow: a shaft that is stretched and a head that keeps its shape; around the shaft of a couple a ring. */
class Arrow extends Group {
  readonly #shaft: Mesh;
  readonly #head: Mesh;
  readonly #ring = new Group();
  readonly #material: MeshBasicMaterial;
  readonly #direction = new Vector3();
  readonly #turn = new Quaternion();
  /** Of its shaft, in the frame of all arrows [m]. */
  readonly tip = new Vector3();

  constructor(
    readonly shown: Shown["kind"],
    colour: string,
    private readonly size: number,
  ) {
    super();
    this.#material = new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true });
    const thick = size * (shown === "force" ? 0.016 : 0.009);
    const shaft = new CylinderGeometry(thick, thick, 1, 12).translate(0, 0.5, 0);
    const head = new ConeGeometry(size * 0.042, size * 0.12, 20).translate(0, -size * 0.06, 0);
    this.#shaft = this.#part(shaft);
    this.#head = this.#part(head);
    this.add(this.#shaft, this.#head);
    if (shown !== "force") {
      const radius = size * 0.34;
      this.#ring.add(this.#part(new TorusGeometry(radius, size * 0.014, 8, 40, ROUND)));
      const tip = this.#part(new ConeGeometry(size * 0.045, size * 0.12, 20));
      tip.position.set(radius * Math.cos(ROUND), radius * Math.sin(ROUND), 0);
      // The head points on along the ring, a little inwards as the ring bends.
      tip.rotation.z = ROUND + 0.12;
      this.#ring.add(tip);
      this.add(this.#ring);
    }
    this.renderOrder = 10;
  }

  #part(geometry: BufferGeometry): Mesh {
    const mesh = new Mesh(geometry, this.#material);
    mesh.renderOrder = 10;
    return mesh;
  }

  /** Shows the vector; a very small one is hidden. */
  show({ x, y, z = 0 }: Shown) {
    const length = Math.hypot(x, y, z);
    this.visible = length > 0.004;
    if (!this.visible) return;
    this.#direction.set(x, y, z).divideScalar(length);
    if (this.shown === "force") {
      this.#place(length * this.size);
    } else {
      this.#place(0.55 * this.size * Math.max(length, 0.25));
      this.#turn.setFromUnitVectors(ALONG, this.#direction);
      this.#ring.quaternion.copy(this.#turn);
      this.#ring.scale.setScalar(Math.sqrt(length));
    }
  }

  #place(length: number) {
    this.#turn.setFromUnitVectors(UP, this.#direction);
    const head = Math.min(0.12 * this.size, 0.7 * length);
    this.#shaft.scale.set(1, Math.max(length - 0.9 * head, 1e-6), 1);
    this.#shaft.quaternion.copy(this.#turn);
    this.#head.scale.setScalar(head / (0.12 * this.size));
    this.tip.copy(this.#direction).multiplyScalar(length);
    this.#head.position.copy(this.tip);
    this.#head.quaternion.copy(this.#turn);
  }

  /** Frees what the graphics card holds. */
  free() {
    this.traverse((child) => child instanceof Mesh && (child.geometry as BufferGeometry).dispose());
    this.#material.dispose();
  }
}

/** All arrows, each by its name; those that are not named any more go. */
export class Arrows extends Group {
  readonly #named = new Map<string, Arrow>();
  #labels: { id: string; label: string; colour: string; arrow: Arrow }[] = [];

  /** `size`: the length of the largest [m]. */
  show(shown: Shown[], size: number) {
    const named = ({ id, colour }: Shown) => `${id} ${colour} ${size.toFixed(4)}`;
    const names = new Set(shown.map(named));
    for (const [name, arrow] of this.#named) {
      if (names.has(name)) continue;
      this.remove(arrow);
      arrow.free();
      this.#named.delete(name);
    }
    this.#labels = [];
    for (const one of shown) {
      const arrow = this.#named.get(named(one)) ?? new Arrow(one.kind, one.colour, size);
      this.#named.set(named(one), arrow);
      this.add(arrow);
      arrow.show(one);
      if (one.label && arrow.visible) {
        const { id, label, colour } = one;
        this.#labels.push({ id, label, colour, arrow });
      }
    }
  }

  /** Labels with the tips that they belong to, in the world [m]. */
  labels(): { id: string; label: string; colour: string; at: Vector3 }[] {
    return this.#labels.map(({ arrow, ...one }) => ({ ...one, at: this.localToWorld(arrow.tip.clone()) }));
  }
}
