// Where the camera stands.

import { Matrix4, type PerspectiveCamera, Vector3 } from "three";

export const PRESETS = ["front", "side", "top", "iso"] as const;
export type Preset = (typeof PRESETS)[number];

/**
 * Direction from the engine to the camera, of length 1. From the front the free end is seen, y to the right; from the side and
 * from the top z goes to the right.
 */
export function lookFrom(preset: Preset): [number, number, number] {
  const [x, y, z] = {
    front: [0, 0, -1],
    side: [0, 1, 0],
    // Not quite from above: up would have no direction.
    top: [1, 0.002, 0],
    iso: [0.42, 0.72, -0.8],
  }[preset] as [number, number, number];
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}

export interface Fit {
  /** What the camera looks at [m]. */
  target: Vector3;
  /** How far it stands [m]. */
  far: number;
}

/** Where the camera stands so that all points (x, y, z after each other) are just seen. */
export function fit(points: Float32Array, direction: Vector3, camera: PerspectiveCamera): Fit {
  const high = Math.tan((camera.fov * Math.PI) / 360);
  const wide = high * camera.aspect;
  const [right, up, back] = [new Vector3(), new Vector3(), new Vector3()];
  new Matrix4().lookAt(direction, new Vector3(), camera.up).extractBasis(right, up, back);
  const point = new Vector3();
  const each = (see: (right: number, up: number, back: number) => void) => {
    for (let k = 0; k < points.length; k += 3) {
      point.fromArray(points, k);
      see(point.dot(right), point.dot(up), point.dot(back));
    }
  };
  const [low, top] = [
    new Vector3(Infinity, Infinity, Infinity),
    new Vector3(-Infinity, -Infinity, -Infinity),
  ];
  each((a, b, c) => {
    low.min(point.clone().set(a, b, c));
    top.max(point.set(a, b, c));
  });
  const middle = low.add(top).multiplyScalar(0.5);
  let far = 0;
  each((a, b, c) => {
    const across = Math.max(Math.abs(a - middle.x) / wide, Math.abs(b - middle.y) / high);
    far = Math.max(far, c - middle.z + across);
  });
  const target = new Vector3()
    .addScaledVector(right, middle.x)
    .addScaledVector(up, middle.y)
    .addScaledVector(back, middle.z);
  return { target, far: 1.05 * far };
}

/** Moves the camera round a target [rad], to the right and up, but not over the poles. */
export function orbit(camera: PerspectiveCamera, target: Vector3, right: number, up: number) {
  const offset = camera.position.clone().sub(target);
  const height = offset.angleTo(camera.up);
  const tilt = Math.min(Math.max(height - up, 0.02), Math.PI - 0.02) - height;
  offset.applyAxisAngle(camera.up.clone().cross(offset).normalize(), tilt).applyAxisAngle(camera.up, right);
  camera.position.copy(target).add(offset);
}
