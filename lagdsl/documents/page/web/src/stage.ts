// The picture: camera, light, ground, and all shapes of the scene.
import {
  AmbientLight, Box3, type BufferGeometry, Color, DirectionalLight, GridHelper, Group, HemisphereLight, type Intersection, Matrix4, type Mesh,
  type MeshLambertMaterial, OrthographicCamera, PerspectiveCamera, Plane, Raycaster, Scene, Vector2, Vector3,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Head, Part, Shape } from "./head.ts";
import type { Motion } from "./motion.ts";
import { above } from "./numbers.ts";
import { placeIn, type Pull } from "./orders.ts";
import { lengthOf, Overlay, seen } from "./overlay.ts";
import { drawing } from "./sketch.ts";
import { type Panel, Screen } from "./screen.ts";
import { drawn as made, vector, type Drawn, type Numbers, type Sizes } from "./shapes.ts";

const ROWS_LOOKED_AT = 200;
/** Shapes that do not move, or are no part of the machine. */
const STILL = new Set(["trace", "ground", "rail", "track", "frame", "slider", "dial", "text"]);
const SOLID = new Set(["box", "cylinder", "cone", "disc", "gear", "sphere", "mass", "body", "circle", "mesh"]);
const LINKS = new Set(["rod", "spring", "damper", "rope"]);
const LEAST_LETTERS = 19; // [pixels] with the room above and below
const POSTURES = 13;
const MARGIN = 0.05; // of the machine: so far a motion may leave the box
const FARTHEST = 20;
const AWAY = 4; // of its own size: a machine that goes so far drives away

interface Moment {
  motion: Motion;
  numbers: Float64Array;
  t: number;
}

/** A motion that is drawn together with the present one: at a time of its own, or always at the present one. */
export interface Companion {
  motion: Motion;
  t?: number;
}

/** A place of a thing, as a sum of vectors of a row, in the axes of a gauge or in the world, and where it is now. */
export interface Held {
  parts: Pull["parts"];
  point: Vector3;
  axes: Matrix4;
}

export class Stage {
  readonly canvas: HTMLCanvasElement;
  readonly screen = new Screen();
  private readonly scene = new Scene();
  private readonly camera: OrthographicCamera | PerspectiveCamera;
  private readonly controls: OrbitControls;
  private readonly drawn: Drawn[];
  private readonly box = new Box3();
  private readonly sizes: Sizes;
  private readonly grid: GridHelper;
  private readonly arrows = new Group();
  readonly on = new Set(["forces"]); // switches
  readonly overlay: Overlay | null;
  private moved = false; // somebody chose a view
  private now: Moment | null = null; // that is drawn
  private beside: Companion[] = []; // one at most, left of the present motion
  private behind: Companion[] = []; // pale
  private readonly onlyGauges: boolean;
  private motion: Motion; // that the picture shows
  private readonly places: readonly number[]; // columns at which places begin in a row
  private followed: Vector3 | null = null; // middle of a machine that the view goes with

  constructor(
    private readonly head: Head,
    whole: Motion,
    meshes: readonly BufferGeometry[],
    forms: ReadonlyMap<string, BufferGeometry>,
    private readonly place: HTMLElement,
  ) {
    this.motion = whole;
    this.canvas = Object.assign(this.screen.renderer.domElement, { role: "img", ariaLabel: `The machine ${head.name}, moving` });
    place.append(this.canvas);
    this.places = placesOf(head);
    const { shapes, first } = head.scene;
    const { length, scales, coil } = head.stage;
    const boards = head.stage.boards.map((board) => new Matrix4().fromArray(board));
    this.sizes = { length, scales, coil, boards, center: new Vector3(...head.stage.center), first, forms, meshes };
    this.camera = head.planar ? new OrthographicCamera() : new PerspectiveCamera(35, 1, length / 100, length * 100);
    this.camera.up.set(...head.stage.axes[1]);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableRotate = !head.planar;
    this.controls.addEventListener("change", () => this.render());
    this.controls.addEventListener("start", () => {
      this.moved = true;
      this.followed = null;
    });
    this.scene.add(new AmbientLight(0xffffff, 0.7), new HemisphereLight(0xffffff, 0x94a3b8, 1.2));
    const sun = new DirectionalLight(0xffffff, 2);
    sun.position.set(0.6, 1, 1.2);
    this.camera.add(sun);
    this.scene.add(this.camera);
    this.drawn = shapes.map((shape) => made(shape, this.sizes));
    this.scene.add(...this.drawn.map(({ object }) => object));
    this.onlyGauges = shapes.some(isGauge) && shapes.every(({ kind }) => STILL.has(kind));
    this.show();
    this.hold(this.motion);
    this.grid = this.ground(length);
    this.scene.add(this.grid, this.arrows);
    if (head.planar) this.arrows.position.z = 2 * length; // in front of everything, planes of contacts too
    this.overlay = head.vectors ? new Overlay(head.vectors, this.sizes, this.on, this.arrows) : null;
    this.theme();
    this.aim();
    new ResizeObserver(() => {
      if (place.clientWidth !== this.canvas.clientWidth || place.clientHeight !== this.canvas.clientHeight) this.resize();
    }).observe(place);
  }

  /** The box of all places along a motion. */
  private along(motion: Motion): Box3 {
    const box = new Box3();
    const stride = Math.max(1, Math.floor(motion.count / ROWS_LOOKED_AT));
    for (let row = 0; row < motion.count; row += stride) this.grow(box, motion.row(row));
    if (box.isEmpty()) box.set(new Vector3(), new Vector3());
    return diagonal(box) === 0 ? box.expandByScalar(0.5) : box;
  }

  /** A box with all places of one row in it. */
  private grow(box: Box3, numbers: ArrayLike<number>): Box3 {
    for (const column of this.places) {
      const point = new Vector3(numbers[column], numbers[column + 1], numbers[column + 2]);
      if (Number.isFinite(point.x + point.y + point.z)) box.expandByPoint(point);
    }
    return box;
  }

  /** A box with all things of a size of their own in it, as they stand. */
  private enclose(box: Box3): Box3 {
    for (const { shape, object } of this.drawn) if (SOLID.has(shape.kind) && object.visible) box.expandByObject(object);
    return box;
  }

  /** The picture holds all places along the motion, all things at some of its moments, and the gauges, which are alone
   * where nothing else moves. The caller poses the machine. */
  private hold(motion: Motion): void {
    this.box.union(this.along(motion));
    for (let k = 0; k < POSTURES && motion.count > 0; ++k) {
      this.set(momentOf(motion, motion.at(Math.round(((motion.count - 1) * k) / (POSTURES - 1)), 0)));
      this.enclose(this.box);
    }
    if (this.onlyGauges) this.box.makeEmpty();
    for (const { object, shape } of this.drawn) if (isGauge(shape)) this.box.expandByObject(object);
  }

  /** Another motion. Where it leaves the picture the picture grows, unless somebody chose a view; a machine that flies
   * away stays as large as it is. The caller poses the machine anew. */
  follow(motion: Motion): void {
    this.motion = motion;
    if (this.moved || this.onlyGauges || this.followed !== null) return;
    const room = this.box.clone().expandByScalar(MARGIN * this.sizes.length);
    const found = this.along(motion);
    if (room.containsBox(found) || diagonal(found.union(this.box)) > FARTHEST * this.sizes.length) return;
    this.hold(motion);
    this.aim();
  }

  /** What switches show. */
  show(): void {
    for (const { object, shape } of this.drawn) object.visible = seen(shape.kind, this.on);
  }

  private ground(length: number): GridHelper {
    const step = 10 ** Math.floor(Math.log10(length / 2));
    const count = 2 * Math.ceil((1.5 * length) / step);
    const grid = new GridHelper(count * step, count);
    grid.material.vertexColors = false;
    const center = middle(this.box);
    if (this.head.planar) {
      grid.rotation.x = Math.PI / 2;
      grid.position.copy(center.divideScalar(step).round().multiplyScalar(step)).setZ(-0.2 * length);
      return grid;
    }
    const up = new Vector3(...this.head.stage.axes[1]);
    const low = Math.min(up.dot(this.box.min), up.dot(this.box.max));
    grid.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), up);
    grid.position.copy(center).addScaledVector(up, low - up.dot(center) - 0.02 * length);
    return grid;
  }

  /** The whole machine along its motion, as one first sees it. The view goes with one that drives away; the next time it
   * shows the whole way. The caller poses the machine anew. */
  lookAt(): void {
    this.moved = false;
    const own = this.machine();
    const away = this.followed === null && diagonal(own) > 0 && diagonal(this.along(this.motion)) > AWAY * diagonal(own);
    this.followed = away ? middle(own) : null;
    this.box.makeEmpty();
    if (away) this.box.copy(own.expandByScalar(0.2 * diagonal(own)));
    else this.hold(this.motion);
    this.aim();
  }

  /** The machine as it stands. */
  private machine(): Box3 {
    return this.enclose(this.grow(new Box3(), this.now?.numbers ?? []));
  }

  /** The view goes with the machine. */
  private go(now: Moment): void {
    if (this.followed === null) return;
    this.set(now);
    const center = middle(this.machine());
    const step = center.clone().sub(this.followed);
    this.followed = center;
    this.box.translate(step);
    this.camera.position.add(step);
    this.controls.target.add(step);
    this.controls.update();
  }

  private aim(): void {
    this.grid.scale.setScalar(Math.max(above((0.8 * diagonal(this.box)) / Math.SQRT2 / this.sizes.length), 1));
    this.controls.target.copy(middle(this.box));
    this.resize();
    this.controls.update();
  }

  /** The box fills the picture, with a margin. */
  private fit(aspect: number): void {
    const [center, size] = [middle(this.box), this.box.getSize(new Vector3())];
    const { length } = this.sizes;
    if (this.camera instanceof OrthographicCamera) {
      const margin = 0.12 * Math.max(size.x, size.y, 0.2 * length);
      const half = Math.max(size.y / 2 + margin, (size.x / 2 + margin) / aspect);
      Object.assign(this.camera, { top: half, bottom: -half, right: half * aspect, left: -half * aspect });
      if (this.moved) return;
      Object.assign(this.camera, { near: 0.1 * length, far: 30 * length, zoom: 1 });
      this.camera.position.copy(center).add(new Vector3(0, 0, 10 * length));
      return;
    }
    this.camera.aspect = aspect;
    if (this.moved) return;
    const [right, up, back] = this.head.stage.axes.map((axis) => new Vector3(...axis)); // as one first sees the machine
    const away = back.multiplyScalar(0.92).addScaledVector(up, 0.38).normalize();
    const upward = away.clone().cross(right);
    const slope = Math.tan((this.camera.fov * Math.PI) / 360) / 1.12;
    let far = 0;
    for (let k = 0; k < 8; ++k) {
      const corner = new Vector3(k & 1, (k >> 1) & 1, k >> 2).addScalar(-0.5).multiply(size);
      const across = Math.max(Math.abs(corner.dot(right)) / aspect, Math.abs(corner.dot(upward)));
      far = Math.max(far, corner.dot(away) + across / slope);
    }
    this.camera.position.copy(center).addScaledVector(away, Math.max(far, 0.5 * length));
  }

  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (width === 0 || height === 0) return;
    this.screen.renderer.setSize(width, height);
    this.fit(width / height / (1 + this.beside.length));
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.legible(height);
    this.render();
  }

  /** Names keep a least height on a small screen. */
  private legible(height: number): void {
    const { camera } = this;
    const distance = camera.position.distanceTo(middle(this.box));
    const seen = camera instanceof OrthographicCamera ? camera.top - camera.bottom : 2 * distance * Math.tan((camera.fov * Math.PI) / 360);
    const least = (LEAST_LETTERS * seen) / height;
    for (const { userData, scale } of this.scene.getObjectsByProperty("isSprite", true)) {
      userData.height ??= scale.y;
      scale.multiplyScalar(Math.max(userData.height as number, least) / scale.y);
    }
  }

  /** Colours of the page behind the machine. */
  theme(): void {
    const style = getComputedStyle(document.documentElement);
    this.scene.background = new Color(style.getPropertyValue("--stage"));
    this.grid.material.color.set(style.getPropertyValue("--grid"));
    this.render();
  }

  /** Draws a moment of a motion, whose numbers it returns. */
  pose(motion: Motion, t: number): Float64Array {
    this.now = momentOf(motion, t);
    this.go(this.now);
    this.overlay?.pose(t);
    this.render();
    return this.now.numbers;
  }

  private set({ motion, numbers, t }: Moment): void {
    const row = motion.rowAt(t);
    for (const drawn of this.drawn) {
      drawn.update(this.rowOf(numbers), motion, row);
      drawn.object.updateMatrixWorld(true);
    }
  }

  /** The numbers of the scene. */
  private rowOf(numbers: Float64Array): Numbers {
    return numbers.subarray(this.head.scene.first);
  }

  /** Motions left of the present one and pale behind it. The caller poses the machine anew. */
  accompany(beside: Companion[], behind: Companion[]): void {
    const before = this.beside.length;
    this.beside = beside;
    this.behind = behind;
    if (beside.length !== before) this.resize();
  }

  /** The picture in lines and faces. */
  sketch(): string {
    return drawing(this.scene, this.camera, this.place.clientWidth, this.place.clientHeight);
  }

  render(): void {
    const { now } = this;
    if (now === null) return;
    const posed = (moment: Moment) => (): void => {
      this.arrows.visible = moment === now;
      this.set(moment);
    };
    const along = ({ motion, t = Math.min(now.t, motion.last) }: Companion): Panel[number] => posed(momentOf(motion, t));
    this.screen.draw(this.scene, this.camera, [...this.beside.map((each) => [along(each)]), [...this.behind.map(along), posed(now)]]);
  }

  /** The ray through a place of the window. */
  private ray(x: number, y: number): Raycaster {
    const bounds = this.canvas.getBoundingClientRect();
    const across = (x - bounds.left) / bounds.width;
    const at = new Vector2((((1 + this.beside.length) * across) % 1) * 2 - 1, 1 - ((y - bounds.top) / bounds.height) * 2);
    const caster = new Raycaster();
    caster.setFromCamera(at, this.camera);
    return caster;
  }

  /** What somebody may take hold of, and the place of it that was taken: as a sum of vectors of a row, and where it is. */
  held(x: number, y: number): Held | null {
    const hit = this.hitAt(x, y);
    const shape = hit?.object.userData.shape as Shape | undefined;
    if (hit === undefined || shape === undefined || this.now === null) return null;
    const { numbers } = this.now;
    const { first } = this.head.scene;
    if (shape.kind === "dial") {
      const hand = shape.parts[shape.parts.length - 1];
      const [axes, parts] = [this.sizes.boards[hand.board ?? 0], [[first + hand.numbers.to, 1]] as Pull["parts"]];
      return { parts, axes, point: new Vector3(...placeIn(numbers, parts)).applyMatrix4(axes) };
    }
    const part = hit.object.userData.part as Part | undefined;
    if (part === undefined || part.still || !("at" in part.numbers) || !(SOLID.has(shape.kind) || LINKS.has(shape.kind))) return null;
    const parts = within(Object.fromEntries(Object.entries(part.numbers).map(([role, column]) => [role, first + column])), hit.point, numbers);
    return { parts, axes: new Matrix4(), point: new Vector3(...placeIn(numbers, parts)) };
  }

  /** The place under the pointer in the plane through a point that faces the viewer, and the directions right and up in it. */
  facingPlace(x: number, y: number, point: Vector3): { place: Vector3; across: Vector3[] } {
    const [right, up, back] = [0, 1, 2].map((k) => new Vector3().setFromMatrixColumn(this.camera.matrixWorld, k));
    const plane = new Plane().setFromNormalAndCoplanarPoint(back, point);
    return { place: this.ray(x, y).ray.intersectPlane(plane, new Vector3()) ?? point, across: [right, up] };
  }

  /** The machine and its arrows. */
  private get all(): Drawn[] {
    return [...this.drawn, ...(this.overlay?.drawn ?? [])];
  }

  private hitAt(x: number, y: number): Intersection | undefined {
    const objects = this.all.map(({ object }) => object).filter(({ visible }) => visible);
    return this.ray(x, y).intersectObjects(objects).find((hit) => hit.object.visible);
  }

  /** The shape under a pointer. */
  shapeAt(x: number, y: number): Shape | null {
    return (this.hitAt(x, y)?.object.userData.shape as Shape | undefined) ?? null;
  }

  /** The value behind an arrow, as it is now. */
  value(shape: Shape): string {
    if (this.overlay?.drawn.some((drawn) => drawn.shape === shape)) return this.overlay.value(shape);
    return this.now !== null && (shape.kind === "force" || shape.kind === "torque") ? lengthOf(shape, this.rowOf(this.now.numbers)) : "";
  }

  highlight(shapes: readonly Shape[]): void {
    for (const drawn of this.all) {
      const ink = shapes.includes(drawn.shape) ? 0x7a5200 : 0;
      const meshes = drawn.object.getObjectsByProperty("isMesh", true) as Mesh<BufferGeometry, MeshLambertMaterial>[];
      for (const { material } of meshes) material.emissive.setHex(ink);
    }
    this.render();
  }
}

/** A place of a part, at the distance that it has now along the way of the part or along its axes. */
function within(columns: Record<string, number>, point: Vector3, row: Numbers): Pull["parts"] {
  const { at, to, x, z } = columns;
  const off = point.clone().sub(vector(columns, "at", row));
  const share = (axis: Vector3): number => off.dot(axis) / Math.max(axis.lengthSq(), 1e-300);
  if ("to" in columns) {
    const part = share(vector(columns, "to", row).sub(vector(columns, "at", row)));
    return [[at, 1 - part], [to, part]];
  }
  const parts: Pull["parts"] = [[at, 1]];
  for (const axis of ["x", "z"]) if (axis in columns) parts.push([columns[axis], share(vector(columns, axis, row))]);
  if ("x" in columns && "z" in columns) parts.push([z, share(vector(columns, "z", row).cross(vector(columns, "x", row))), x]);
  return parts;
}

const momentOf = (motion: Motion, t: number): Moment => ({ motion, numbers: motion.state(t), t });
const middle = (box: Box3): Vector3 => box.getCenter(new Vector3());
const diagonal = (box: Box3): number => box.getSize(new Vector3()).length();
const isGauge = ({ kind }: Shape): boolean => kind === "slider" || kind === "dial";

/** Columns at which places begin in a row: of all that moves and has an end. */
function placesOf({ scene }: Head): number[] {
  const parts = scene.shapes.filter(({ kind }) => kind !== "frame").flatMap((shape) => shape.parts).filter(({ still, board }) => !still && board === undefined);
  const columns = parts.flatMap(({ numbers }) => ["at", "to"].flatMap((role) => numbers[role] ?? []));
  return [...new Set(columns)].map((column) => scene.first + column);
}
