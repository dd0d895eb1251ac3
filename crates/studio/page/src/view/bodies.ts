// The parts of a scene put together to as few meshes as there are bodies that move alike and colours.

import { BufferAttribute, BufferGeometry, EdgesGeometry, Matrix4 } from "three";
import type { Scene, SceneMesh, SceneMotion, ScenePart } from "../api/types";
import { type Group, groupOf } from "./groups";
import { type Pose, pose } from "./pose";

/** Edges are drawn where faces meet at more than this [°]. */
export const EDGE = 32;

/** Parts of one colour that move as one. */
export interface Body {
  group: Group;
  /** Indices of its parts; all of one motion but for their place on it. */
  parts: number[];
  motion: SceneMotion;
  geometry: BufferGeometry;
  edges: BufferGeometry;
  /** Number of the first triangle of each part, in the order of `parts`. */
  first: number[];
}

const AT: Pose = { x: 0, y: 0, z: 0, angle: 0 };

/** Moves by a pose: place and turn about z. */
export function matrixOf({ x, y, z, angle }: Pose, out: Matrix4): Matrix4 {
  return out.makeRotationZ(angle).setPosition(x, y, z);
}

/** What moves alike has one key; the part's own place on its body is left. */
function carrier(part: ScenePart, index: number): { key: string; motion: SceneMotion; place: Pose } {
  const { motion } = part;
  if (motion.kind === "turn") {
    const { x, y, z, angle, ratio } = motion;
    return {
      key: `turn ${x} ${y} ${ratio}`,
      motion: { kind: "turn", x, y, z: 0, angle: 0, ratio },
      place: { x: 0, y: 0, z, angle },
    };
  }
  const fixed: SceneMotion = { kind: "fixed", x: 0, y: 0, z: 0, angle: 0 };
  if (motion.kind === "fixed") return { key: "fixed", motion: fixed, place: { ...pose(motion, 0, AT) } };
  return { key: `own ${index}`, motion, place: { x: 0, y: 0, z: 0, angle: 0 } };
}

export function bodies(scene: Scene): Body[] {
  const sets = new Map<string, { group: Group; motion: SceneMotion; parts: number[]; places: Pose[] }>();
  scene.parts.forEach((part, index) => {
    const group = groupOf(part.kind);
    const { key, motion, place } = carrier(part, index);
    const set = sets.get(`${group.id} ${key}`);
    if (set) {
      set.parts.push(index);
      set.places.push(place);
    } else sets.set(`${group.id} ${key}`, { group, motion, parts: [index], places: [place] });
  });
  const edges = new Map<number, Float32Array>();
  return [...sets.values()].map(({ group, motion, parts, places }) => {
    const meshes = parts.map((part) =>
      group.id === "bore" ? inside(meshOf(scene, part)) : meshOf(scene, part),
    );
    const first: number[] = [];
    let triangles = 0;
    for (const mesh of meshes) {
      first.push(triangles);
      triangles += mesh.indices.length / 3;
    }
    const lines = parts.map((part) => {
      const mesh = scene.parts[part]?.mesh ?? 0;
      const known = edges.get(mesh) ?? edgesOf(meshOf(scene, part));
      edges.set(mesh, known);
      return known;
    });
    return { group, motion, parts, first, geometry: merged(meshes, places), edges: joined(lines, places) };
  });
}

export function meshOf(scene: Scene, part: number): SceneMesh {
  const mesh = scene.meshes[scene.parts[part]?.mesh ?? -1];
  if (!mesh) throw new Error(`the scene has no shape for part ${part}`);
  return mesh;
}

/** Of a liner what faces its axis: only the far side of its wall is seen, and half as much is drawn. */
function inside(mesh: SceneMesh): SceneMesh {
  const { positions, normals, indices } = mesh;
  const faces: number[] = [];
  for (let k = 0; k < indices.length; k += 3) {
    const at = 3 * (indices[k] ?? 0);
    const out =
      (positions[at + 1] ?? 0) * (normals[at + 1] ?? 0) + (positions[at + 2] ?? 0) * (normals[at + 2] ?? 0);
    if (out <= 0) faces.push(...indices.slice(k, k + 3));
  }
  return { positions, normals, indices: faces };
}

/** The shape of one part as a geometry, in its own frame. */
export function geometryOf(mesh: SceneMesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(mesh.positions), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(mesh.normals), 3));
  geometry.setIndex(mesh.indices);
  return geometry;
}

function edgesOf(mesh: SceneMesh): Float32Array {
  const geometry = geometryOf(mesh);
  const edges = new EdgesGeometry(geometry, EDGE);
  const lines = edges.getAttribute("position").array as Float32Array;
  geometry.dispose();
  edges.dispose();
  return lines;
}

function merged(meshes: SceneMesh[], places: Pose[]): BufferGeometry {
  const points = meshes.reduce((sum, mesh) => sum + mesh.positions.length, 0);
  const positions = new Float32Array(points);
  const normals = new Float32Array(points);
  const indices: number[] = [];
  let at = 0;
  meshes.forEach((mesh, number) => {
    const place = places[number] as Pose;
    for (const index of mesh.indices) indices.push(index + at / 3);
    turned(mesh.positions, place, positions, at);
    turned(mesh.normals, { x: 0, y: 0, z: 0, angle: place.angle }, normals, at);
    at += mesh.positions.length;
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setIndex(indices);
  return geometry;
}

function joined(lines: Float32Array[], places: Pose[]): BufferGeometry {
  const all = new Float32Array(lines.reduce((sum, line) => sum + line.length, 0));
  let at = 0;
  lines.forEach((line, number) => {
    turned(line, places[number] as Pose, all, at);
    at += line.length;
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(all, 3));
  return geometry;
}

/** Points moved by a pose, written from `at` on. */
function turned(points: ArrayLike<number>, { x, y, z, angle }: Pose, out: Float32Array, at: number) {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  for (let k = 0; k < points.length; k += 3) {
    const [px, py, pz] = [points[k] as number, points[k + 1] as number, points[k + 2] as number];
    out[at + k] = x + cos * px - sin * py;
    out[at + k + 1] = y + sin * px + cos * py;
    out[at + k + 2] = z + pz;
  }
}
