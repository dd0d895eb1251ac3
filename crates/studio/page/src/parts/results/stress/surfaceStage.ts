// The picture of a loaded surface. It draws only when something changed; three.js comes with this file.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  ColorManagement,
  DynamicDrawUsage,
  Group as Node,
  LinearSRGBColorSpace,
  LineSegments,
  Mesh,
  PerspectiveCamera,
  Scene as World,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { type Preset, fit, lookFrom, orbit } from "../../../view/camera";
import { isSoftware } from "../../../view/software";
import { Contours } from "./contours";
import { sharpEdges } from "./edges";
import type { Surface } from "./superposition";

ColorManagement.enabled = false;

export class SurfaceStage {
  /** Called after each frame. */
  onframe: () => void = () => {};
  readonly #renderer: WebGLRenderer;
  readonly #world = new World();
  /** The crankshaft; mirrored for an engine that turns the other way. */
  readonly #root = new Node();
  readonly #camera = new PerspectiveCamera(22, 1, 0.01, 100);
  readonly #controls: OrbitControls;
  readonly #look = new Contours();
  readonly #software = isSoftware();
  #surface: Surface | undefined;
  #faces = new BufferGeometry();
  #lines = new BufferGeometry();
  #values = new BufferAttribute(new Float32Array(0), 1);
  #moved = new BufferAttribute(new Float32Array(0), 3);
  #factor = 0;
  #frame = 0;
  #size: [number, number] = [1, 1];
  #preset: Preset | undefined;

  constructor(canvas: HTMLCanvasElement) {
    this.#renderer = new WebGLRenderer({
      canvas,
      antialias: !this.#software,
      powerPreference: "high-performance",
    });
    this.#renderer.outputColorSpace = LinearSRGBColorSpace;
    this.#renderer.setPixelRatio(this.#software ? 1 : Math.min(devicePixelRatio, 2));
    this.#world.add(this.#root);
    this.#camera.up.set(1, 0, 0);
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.enableDamping = false;
    this.#controls.zoomToCursor = true;
    this.#controls.addEventListener("change", () => this.#changed());
    this.#controls.addEventListener("start", () => (this.#preset = undefined));
  }

  /** Draws soon; several changes make one frame. */
  #changed() {
    if (this.#frame !== 0) return;
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.#renderer.render(this.#world, this.#camera);
      this.onframe();
    });
  }

  resize(width: number, height: number) {
    if (width < 1 || height < 1) return;
    this.#size = [width, height];
    this.#camera.aspect = width / height;
    this.#camera.updateProjectionMatrix();
    this.#renderer.setSize(width, height, false);
    if (this.#preset) this.look(this.#preset);
    this.#changed();
  }

  theme(ground: string, ink: string) {
    this.#world.background = new Color(ground);
    this.#look.ink = ink;
    this.#changed();
  }

  /** Another surface; the camera stays where it was, if there was one. */
  show(surface: Surface, mirrored: boolean) {
    const isFirst = this.#surface === undefined;
    this.#surface = surface;
    this.#clear();
    this.#root.scale.y = mirrored ? -1 : 1;
    const count = surface.nodes.length / 3;
    const position = new BufferAttribute(surface.nodes, 3);
    this.#values = new BufferAttribute(new Float32Array(count), 1).setUsage(DynamicDrawUsage);
    this.#moved = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    this.#faces = new BufferGeometry();
    this.#lines = new BufferGeometry();
    for (const geometry of [this.#faces, this.#lines]) {
      geometry.setAttribute("position", position);
      geometry.setAttribute("moved", this.#moved);
    }
    this.#faces.setAttribute("value", this.#values);
    this.#faces.setIndex(new BufferAttribute(surface.triangles, 1));
    this.#lines.setIndex(new BufferAttribute(sharpEdges(surface), 1));
    const drawn = [
      new Mesh(this.#faces, this.#look.faces),
      new LineSegments(this.#lines, this.#look.edges),
      new LineSegments(this.#lines, this.#look.ghost),
    ];
    // Where they are moved to is known on the graphics card alone.
    for (const one of drawn) one.frustumCulled = false;
    this.#root.add(...drawn);
    this.#root.updateMatrixWorld(true);
    if (isFirst) this.look("iso");
    this.#changed();
  }

  #clear() {
    this.#root.clear();
    this.#faces.dispose();
    this.#lines.dispose();
  }

  /** Values over the end of the scale, and displacements [m], of all nodes. */
  paint(values: Float32Array, moved: Float32Array) {
    if (values.length !== this.#values.count) return;
    this.#values.copyArray(values).needsUpdate = true;
    this.#moved.copyArray(moved).needsUpdate = true;
    this.#changed();
  }

  /** By how much displacements are shown. */
  magnify(factor: number) {
    this.#factor = factor;
    this.#look.factor = factor;
    this.#changed();
  }

  /** Whether the crankshaft without loads is seen too. */
  ghost(seen: boolean) {
    this.#look.ghost.visible = seen;
    this.#changed();
  }

  /** Where a node is on the canvas [px], as it is shown. */
  place(node: number): { x: number; y: number } | null {
    if (!this.#surface || node >= this.#values.count) return null;
    const { x, y } = this.#at(node).project(this.#camera);
    return { x: ((1 + x) / 2) * this.#size[0], y: ((1 - y) / 2) * this.#size[1] };
  }

  /** Of a node in the picture [m]. */
  #at(node: number): Vector3 {
    const at = new Vector3().fromArray(this.#surface?.nodes ?? [], 3 * node);
    at.addScaledVector(new Vector3().fromBufferAttribute(this.#moved, node), this.#factor);
    return at.applyMatrix4(this.#root.matrixWorld);
  }

  look(preset: Preset) {
    if (!this.#surface) return;
    this.#preset = preset;
    const direction = new Vector3(...lookFrom(preset));
    const points = this.#surface.nodes.slice();
    if (this.#root.scale.y < 0) for (let k = 1; k < points.length; k += 3) points[k] = -(points[k] as number);
    const { target, far } = fit(points, direction, this.#camera);
    if (far > 0) this.#stand(target, direction, 1.06 * far);
  }

  #stand(target: Vector3, direction: Vector3, far: number) {
    this.#controls.target.copy(target);
    this.#camera.position.copy(target).addScaledVector(direction, far);
    this.#camera.near = far / 60;
    this.#camera.far = far * 8;
    this.#camera.updateProjectionMatrix();
    this.#controls.update();
    this.#changed();
  }

  /** Looks at a node from where its surface is seen. */
  face(node: number) {
    if (!this.#surface) return;
    this.#preset = undefined;
    const direction = outwards(this.#surface, node);
    // From the side rather than along the crank, where the next web stands in the way.
    direction.z *= 0.2;
    direction.y *= this.#root.scale.y;
    // Up is x: straight from above there would be none.
    if (Math.hypot(direction.y, direction.z) < 0.2 * direction.length())
      direction.y += 0.25 * direction.length();
    const far = this.#camera.position.distanceTo(this.#controls.target);
    this.#stand(this.#at(node), direction.normalize(), far);
  }

  orbit(right: number, up: number) {
    this.#preset = undefined;
    orbit(this.#camera, this.#controls.target, right, up);
    this.#controls.update();
    this.#changed();
  }

  zoom(factor: number) {
    this.#preset = undefined;
    this.#camera.position.lerp(this.#controls.target, 1 - 1 / factor);
    this.#controls.update();
    this.#changed();
  }

  dispose() {
    cancelAnimationFrame(this.#frame);
    this.#clear();
    this.#look.free();
    this.#controls.dispose();
    this.#renderer.dispose();
  }
}

/** Direction in which a surface faces at a node: of its triangles there, by their areas. */
function outwards({ nodes, triangles }: Surface, node: number): Vector3 {
  const sum = new Vector3();
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  for (let k = 0; k < triangles.length; k += 3) {
    if (triangles[k] !== node && triangles[k + 1] !== node && triangles[k + 2] !== node) continue;
    [a, b, c].forEach((corner, at) => corner.fromArray(nodes, 3 * (triangles[k + at] as number)));
    sum.add(b.sub(a).cross(c.sub(a)));
  }
  return sum.lengthSq() > 0 ? sum.normalize() : sum.set(0, 1, 0);
}
