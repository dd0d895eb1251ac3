// The picture in three dimensions. It draws only when something changed; three.js comes with this file, after the first paint.

import {
  Box3,
  Color,
  ColorManagement,
  Group as Node,
  LinearSRGBColorSpace,
  type Mesh,
  PerspectiveCamera,
  Raycaster,
  Scene as World,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Scene } from "../api/types";
import type { BlockPose } from "../parts/simulate/simulated";
import { Arrows, type Shown } from "./arrows";
import { type Body, bodies, matrixOf } from "./bodies";
import { Finish, type Look } from "./finish";
import { FrameClock } from "./frames";
import type { Label } from "./labels";
import { Mark } from "./mark";
import { Sharpness } from "./sharpness";
import { isSoftware } from "./software";
import { type Pose, pose } from "./pose";
import { type Preset, fit, lookFrom, orbit } from "./camera";

interface Drawn extends Body {
  node: Node;
}

ColorManagement.enabled = false;

/** After so long without a change a still picture is drawn finely [ms]. */
const STILL = 140;

/** Angles of a revolution at which the engine is to fit into the picture. */
const POSES = 6;

export class Stage {
  /** Times of the frames of the last second. */
  readonly clock = new FrameClock();
  /** Called after each frame with the camera's turn, for the axes in the corner. */
  onframe: (camera: PerspectiveCamera) => void = () => {};
  readonly software: boolean;

  readonly #renderer: WebGLRenderer;
  readonly #world = new World();
  /** The engine; mirrored for one that turns the other way. */
  readonly #root = new Node();
  readonly #camera = new PerspectiveCamera(22, 1, 0.01, 100);
  readonly #controls: OrbitControls;
  readonly #raycaster = new Raycaster();
  readonly #box = new Box3();
  readonly #arrows = new Arrows();
  readonly #sharpness = new Sharpness();
  #scene: Scene | undefined;
  #drawn: Drawn[] = [];
  #hidden = new Set<string>();
  #finish: Finish | undefined;
  #look: Look | undefined;
  #theta = 0;
  #mark: Mark | undefined;
  #frame = 0;
  #still: ReturnType<typeof setTimeout> | undefined;
  #moving = false;
  /** Of the canvas [px]. */
  #size: [number, number] = [1, 1];
  #ratio = 1;
  /** The side that is looked from until the camera is moved by hand: it fits a picture of another size too. */
  #preset: Preset | undefined;
  readonly #at: Pose = { x: 0, y: 0, z: 0, angle: 0 };

  constructor(canvas: HTMLCanvasElement) {
    this.software = isSoftware();
    this.#renderer = new WebGLRenderer({
      canvas,
      antialias: !this.software,
      powerPreference: "high-performance",
    });
    // Colours are those of the screen throughout: a conversion for each pixel is dear where a processor draws.
    this.#renderer.outputColorSpace = LinearSRGBColorSpace;
    this.#world.add(this.#root);
    this.#root.add(this.#arrows);
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
      // Asked for only when the crank has turned, in the next frame, every other frame would pass without a picture.
      if (this.#moving) this.#changed();
      this.#draw(this.software ? this.#sharpness.ratio : Math.min(devicePixelRatio, 2));
      clearTimeout(this.#still);
      if (this.software && !this.#moving) this.#still = setTimeout(() => this.#draw(2), STILL);
    });
  }

  #draw(ratio: number) {
    if (ratio !== this.#ratio) {
      this.#ratio = ratio;
      this.#renderer.setPixelRatio(ratio);
    }
    const now = performance.now();
    const between = now - this.clock.last;
    // Moved by hand, frames come as the hand moves; after a pause none was slow.
    if (this.#moving && between < STILL) this.#sharpness.frame(between);
    this.clock.begin(now);
    this.#renderer.render(this.#world, this.#camera);
    this.clock.end(performance.now());
    this.onframe(this.#camera);
  }

  /** Pixels of the last picture for each one of the screen, along each side. */
  get ratio(): number {
    return this.#ratio;
  }

  resize(width: number, height: number) {
    if (width < 1 || height < 1) return;
    this.#size = [width, height];
    this.#camera.aspect = width / height;
    this.#camera.updateProjectionMatrix();
    this.#renderer.setPixelRatio(this.#ratio);
    this.#renderer.setSize(width, height, false);
    if (this.#preset) this.look(this.#preset);
    this.#changed();
  }

  /** A new engine: the camera stays if it looks at the same one, changed. */
  show(scene: Scene, theta: number) {
    const isFirst = this.#scene === undefined;
    const before = this.#box.getSize(new Vector3()).length();
    this.#scene = scene;
    this.#theta = theta;
    this.#root.scale.y = scene.mirrored ? -1 : 1;
    this.select(null);
    this.#clear();
    this.#drawn = bodies(scene).map((body) => ({ ...body, node: new Node() }));
    for (const body of this.#drawn) {
      body.node.matrixAutoUpdate = false;
      this.#root.add(body.node);
    }
    this.#dress();
    this.#pose();
    this.#box.makeEmpty();
    for (const { node, geometry } of this.#drawn) {
      geometry.computeBoundingBox();
      if (geometry.boundingBox) this.#box.union(geometry.boundingBox.clone().applyMatrix4(node.matrixWorld));
    }
    const size = this.#box.getSize(new Vector3()).length();
    if (isFirst || Math.abs(size - before) > 0.15 * before) this.look("iso");
    this.#changed();
  }

  #clear() {
    for (const { node, geometry, edges } of this.#drawn) {
      this.#root.remove(node);
      geometry.dispose();
      edges.dispose();
    }
    this.#drawn = [];
  }

  theme(look: Look) {
    this.#look = look;
    this.#world.background = new Color(look.ground);
    this.#dress();
    const part = this.#mark?.part ?? null;
    this.select(part);
    this.#changed();
  }

  /** Materials for the theme. */
  #dress() {
    const look = this.#look;
    if (!look) return;
    this.#finish?.free();
    this.#finish = new Finish(look);
    for (const body of this.#drawn) {
      body.node.clear();
      body.node.add(...this.#finish.dressed(body));
    }
    this.visible(this.#hidden);
  }

  /** Whether it moves by itself: still pictures are not worth their time then. */
  moving(moving: boolean) {
    this.#moving = moving;
    clearTimeout(this.#still);
    this.#changed();
  }

  /** Moves the whole engine, in its own frame; `null` puts it back. */
  move(pose: BlockPose | null) {
    const mirror = this.#root.scale.y;
    const [x, y, z] = pose?.place ?? [0, 0, 0];
    const [a, b, c, w] = pose?.turn ?? [0, 0, 0, 1];
    this.#root.position.set(x, mirror * y, z);
    // A turn about an axis in the mirror's plane is seen the other way round.
    this.#root.quaternion.set(mirror * a, b, mirror * c, w);
    this.#root.updateMatrixWorld(true);
    this.#changed();
  }

  turn(theta: number) {
    if (theta === this.#theta) return;
    this.#theta = theta;
    this.#pose();
    this.#changed();
  }

  #pose() {
    for (const body of this.#drawn) {
      matrixOf(pose(body.motion, this.#theta, this.#at), body.node.matrix);
      body.node.matrixWorldNeedsUpdate = true;
    }
    this.#mark?.pose(this.#theta);
    this.#root.updateMatrixWorld(true);
  }

  /** Shows all groups but the hidden ones. */
  visible(hidden: Set<string>) {
    this.#hidden = hidden;
    for (const { node, group } of this.#drawn) node.visible = !hidden.has(group.id);
    this.#changed();
  }

  /** Arrows at a point of the engine [m]. */
  arrows(shown: Shown[], at: [number, number, number]) {
    this.#arrows.position.set(...at);
    this.#arrows.show(shown, 0.27 * this.#box.getSize(new Vector3()).length());
    this.#changed();
  }

  /** What stands at the tips of arrows, and where on the canvas [px]. */
  labels(): Label[] {
    const foot = this.#onCanvas(this.#arrows.getWorldPosition(new Vector3()));
    return this.#arrows.labels().map(({ at, ...one }) => {
      const tip = this.#onCanvas(at);
      return { ...one, ...tip, right: tip.x - foot.x, down: tip.y - foot.y };
    });
  }

  #onCanvas(at: Vector3): { x: number; y: number } {
    const { x, y } = at.project(this.#camera);
    return { x: ((1 + x) / 2) * this.#size[0], y: ((1 - y) / 2) * this.#size[1] };
  }

  /** The part under a point of the page, as its index. */
  pick(x: number, y: number): number | null {
    const frame = this.#renderer.domElement.getBoundingClientRect();
    const at = new Vector2(
      ((x - frame.left) / frame.width) * 2 - 1,
      1 - ((y - frame.top) / frame.height) * 2,
    );
    this.#raycaster.setFromCamera(at, this.#camera);
    const solid = this.#drawn.filter(({ group, node }) => node.visible && group.id !== "bore");
    const glassy = this.#drawn.filter(({ group, node }) => node.visible && group.id === "bore");
    return this.#hit(solid) ?? this.#hit(glassy);
  }

  #hit(drawn: Drawn[]): number | null {
    const meshes = drawn.map(({ node }) => node.children[0] as Mesh);
    const hit = this.#raycaster.intersectObjects(meshes, false)[0];
    if (!hit || hit.faceIndex === undefined || hit.faceIndex === null) return null;
    const body = hit.object.userData.body as Drawn;
    let at = body.first.length - 1;
    while (at > 0 && (body.first[at] as number) > hit.faceIndex) at -= 1;
    return body.parts[at] ?? null;
  }

  /** Marks one part. */
  select(part: number | null) {
    if (this.#mark) {
      this.#root.remove(this.#mark);
      this.#mark.free();
      this.#mark = undefined;
    }
    if (part !== null && this.#scene && this.#look) {
      this.#mark = new Mark(this.#scene, part, this.#look.mark);
      this.#mark.pose(this.#theta);
      this.#root.add(this.#mark);
    }
    this.#changed();
  }

  /** All points at some angles of a revolution: what turns stays in sight. */
  #points(): Float32Array {
    const point = new Vector3();
    const all: number[] = [];
    const now = this.#theta;
    for (let step = 0; step < POSES; step++) {
      this.#theta = now + (2 * Math.PI * step) / POSES;
      this.#pose();
      for (const { node, geometry, motion } of this.#drawn) {
        if (step > 0 && motion.kind === "fixed") continue;
        const positions = geometry.getAttribute("position");
        // Every third will do: shapes have many points close by.
        for (let k = 0; k < positions.count; k += 3) {
          point.fromBufferAttribute(positions, k).applyMatrix4(node.matrixWorld);
          all.push(point.x, point.y, point.z);
        }
      }
    }
    this.#theta = now;
    this.#pose();
    return new Float32Array(all);
  }

  /** Looks from one of the usual sides at the whole engine. */
  look(preset: Preset) {
    this.#preset = preset;
    const direction = new Vector3(...lookFrom(preset));
    const { target, far } = fit(this.#points(), direction, this.#camera);
    if (!(far > 0)) return;
    this.#controls.target.copy(target);
    this.#camera.position.copy(target).addScaledVector(direction, far);
    this.#camera.near = far / 60;
    this.#camera.far = far * 8;
    this.#camera.updateProjectionMatrix();
    this.#controls.update();
    this.#changed();
  }

  /** Goes round the engine [rad], to the right and up. */
  orbit(right: number, up: number) {
    this.#preset = undefined;
    orbit(this.#camera, this.#controls.target, right, up);
    this.#controls.update();
    this.#changed();
  }

  /** Comes nearer by a factor. */
  zoom(factor: number) {
    this.#preset = undefined;
    this.#camera.position.lerp(this.#controls.target, 1 - 1 / factor);
    this.#controls.update();
    this.#changed();
  }

  dispose() {
    cancelAnimationFrame(this.#frame);
    clearTimeout(this.#still);
    this.select(null);
    cancelAnimationFrame(this.#frame);
    this.#arrows.show([], 1);
    this.#clear();
    this.#finish?.free();
    this.#controls.dispose();
    this.#renderer.dispose();
  }
}
