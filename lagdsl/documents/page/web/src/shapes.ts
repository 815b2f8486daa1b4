// The primitives of pictures, as lagdsl/derivation/scene tells them: objects of three.js that follow numbers of the scene.
import {
  BufferAttribute, BufferGeometry, CanvasTexture, Color, DoubleSide, Group, Line, LineBasicMaterial, Mesh, MeshLambertMaterial, type Object3D, Sprite,
  SpriteMaterial, type Matrix4, Vector3, Vector4,
} from "three";
import { axesAlong, lay, tube } from "./geometry.ts";
import type { Part, Shape } from "./head.ts";
import type { Motion } from "./motion.ts";

/** Numbers of the scene at one moment, and the sizes that were chosen for this machine. */
export interface Frame {
  numbers: ArrayLike<number>;
  first: number; // of the scene in a row
}
export interface Sizes {
  length: number; // of the machine [m]
  scales: Record<string, number>; // of arrows: metres for a newton, for a newton metre
  boards: Matrix4[]; // of gauges
  first: number;
  center: Vector3; // of the machine
  forms: ReadonlyMap<string, BufferGeometry>;
  coil: readonly number[][];
  meshes: readonly BufferGeometry[];
}
export interface Drawn {
  object: Object3D;
  shape: Shape;
  update(frame: Frame): void;
  follow?(motion: Motion, row: number): void; // before update
}
type Pieces = Pick<Drawn, "object" | "update" | "follow">;

const SHORTEST = 1e-6; // of the machine: nothing is seen of a shorter arrow
const OTHER = "#64748b";

export function colour(part: Part): Color {
  return new Color(CSS.supports("color", part.color) ? part.color : OTHER).multiplyScalar(part.shade ?? 1);
}

function solid(part: Part, geometry: BufferGeometry): Mesh {
  const material = new MeshLambertMaterial({ color: colour(part) });
  if (part.opacity !== undefined) Object.assign(material, { transparent: true, opacity: part.opacity, depthWrite: false });
  const mesh = new Mesh(geometry, material);
  mesh.matrixAutoUpdate = false;
  return mesh;
}

export function vector(numbers: Record<string, number>, role: string, frame: Frame): Vector3 {
  const at = frame.first + numbers[role];
  return new Vector3(frame.numbers[at], frame.numbers[at + 1], frame.numbers[at + 2]);
}

/** A vector of a part; those of one on a board are in the axes and the unit of that. */
function vectorOf({ numbers, board }: Part, role: string, sizes: Sizes, frame: Frame): Vector3 {
  const own = vector(numbers, role, frame);
  if (board === undefined) return own;
  const { x, y, z } = new Vector4(...own, Number(role === "at" || role === "to")).applyMatrix4(sizes.boards[board]);
  return new Vector3(x, y, z);
}

function sizeOf(part: Part, axis: number, sizes: Sizes, frame: Frame): number {
  const [factor, column, relative] = part.sizes?.[axis] ?? [1, -1, true];
  return factor * (column < 0 ? 1 : frame.numbers[frame.first + column]) * (relative ? sizes.length : 1);
}

interface Place {
  axes: [Vector3, Vector3, Vector3]; // of length 1
  sizes: [number, number, number];
  at: Vector3;
  seen: boolean; // its axis has a length
}

/** Where a part stands, and how it is stretched. */
function place(part: Part, sizes: Sizes, frame: Frame): Place {
  const { numbers, scale } = part;
  const at = vectorOf(part, "at", sizes, frame);
  const to = "to" in numbers ? vectorOf(part, "to", sizes, frame).sub(at) : null;
  const way = to ?? ("z" in numbers ? vectorOf(part, "z", sizes, frame) : new Vector3(0, 0, 1));
  const shown = way.length() * (scale ? sizes.scales[scale] : 1);
  const own = [0, 1, 2].map((axis) => sizeOf(part, axis, sizes, frame) * (scale && !part.sizes?.[axis][2] ? shown : 1)) as Place["sizes"];
  if (!scale && to !== null) own[2] = shown;
  const axes = axesAlong(way, "x" in numbers ? vectorOf(part, "x", sizes, frame) : null);
  if (part.still) {
    const away = sizes.center.clone().sub(at);
    const [x, , z] = axes;
    at.add("x" in numbers ? x.clone().multiplyScalar(away.dot(x)) : away.addScaledVector(z, -away.dot(z)));
  }
  at.addScaledVector(axes[2], (part.offset ?? 0) * sizes.length);
  return { axes, sizes: own, at, seen: shown > (scale ? SHORTEST * sizes.length : 0) };
}

/** Triangles of a unit body, or of a file; nothing where the file has none. */
function surface(part: Part, shape: Shape, sizes: Sizes): Pieces {
  const file = part.form === "file";
  const geometry = file ? sizes.meshes[shape.mesh ?? -1] : sizes.forms.get(part.form ?? "");
  const object = solid(part, geometry ?? new BufferGeometry());
  if (file) (object.material as MeshLambertMaterial).side = DoubleSide;
  return {
    object,
    update(frame) {
      const { axes, sizes: own, at, seen } = place(part, sizes, frame);
      object.visible = seen;
      object.matrix.copy(lay(axes, own, at));
    },
  };
}

/** A tube along points, or along the coil of a spring, which is bent anew for each length: one that is scaled has a wire
 * as thick along its axis as the length is scaled. */
function line(part: Part, _: Shape, sizes: Sizes): Pieces {
  const object = solid(part, new BufferGeometry());
  let known = "";
  return {
    object,
    update(frame) {
      const radius = sizeOf(part, 2, sizes, frame);
      let points: Vector3[];
      if (part.form === "coil") {
        const { axes, sizes: own, at } = place(part, sizes, frame);
        object.matrix.copy(lay(axes, [1, 1, 1], at));
        if (known === `${own}`) return;
        known = `${own}`;
        points = sizes.coil.map(([x, y, z]) => new Vector3(x * own[0], y * own[1], z * own[2]));
      } else {
        const first = part.numbers.points;
        points = Array.from({ length: part.count ?? 0 }, (_, k) => vector({ at: first + 3 * k }, "at", frame));
      }
      object.geometry.dispose();
      object.geometry = tube(points, radius);
    },
  };
}

/** The way of a point so far, and faintly all of it. */
function trace(part: Part, _: Shape, sizes: Sizes): Pieces {
  const object = new Group();
  const lines = [1, 0.25].map((opacity) => {
    const material = new LineBasicMaterial({ color: colour(part), transparent: opacity < 1, opacity });
    return Object.assign(new Line(new BufferGeometry(), material), { frustumCulled: false });
  });
  object.add(...lines);
  let known: Motion | null = null;
  return {
    object,
    update() {},
    follow(motion, row) {
      if (motion !== known) {
        known = motion;
        const at = sizes.first + part.numbers.at;
        const places = Float32Array.from({ length: 3 * motion.count }, (_, i) => motion.at(Math.floor(i / 3), at + (i % 3)));
        for (const each of lines) {
          each.geometry.dispose();
          each.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(places, 3));
        }
      }
      lines[0].geometry.setDrawRange(0, row + 1);
    },
  };
}

export function label(words: string, size: number, ink: string): Sprite {
  const canvas = document.createElement("canvas");
  const pen = canvas.getContext("2d");
  const font = "48px system-ui, sans-serif";
  if (pen === null) return new Sprite();
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(words).width) + 16;
  canvas.height = 64;
  pen.font = font;
  pen.fillStyle = ink;
  pen.textBaseline = "middle";
  pen.fillText(words, 8, 34);
  const sprite = new Sprite(new SpriteMaterial({ map: new CanvasTexture(canvas), depthTest: false }));
  sprite.userData.words = words;
  sprite.scale.set((size * canvas.width) / 64, size, 1);
  return sprite;
}

function written(part: Part, shape: Shape, sizes: Sizes): Pieces {
  const object = label(shape.texts.text ?? shape.name, 0.06 * sizes.length, OTHER);
  return { object, update: (frame) => void object.position.copy(vectorOf(part, "at", sizes, frame)) };
}

const MAKERS: Record<Part["primitive"], (part: Part, shape: Shape, sizes: Sizes) => Pieces> = {
  surface, line, trace, label: written,
};

/** A shape with all its parts; those that lie still stand where the motion begins. */
export function drawn(shape: Shape, sizes: Sizes): Drawn {
  const object = new Group();
  const [still, moving] = [true, false].map((lies) =>
    shape.parts.filter((part) => (part.still ?? false) === lies).map((part) => {
      const made = MAKERS[part.primitive](part, shape, sizes);
      made.object.traverse((each) => (each.userData.part = part));
      return made;
    }));
  for (const { object: each } of [...still, ...moving]) object.add(each);
  let known: Motion | null = null;
  let most = 0; // value of a slider along the motion
  return {
    object,
    shape,
    update: (frame) => moving.forEach((each) => each.update(frame)),
    follow(motion, row) {
      for (const each of moving) each.follow?.(motion, row);
      if (motion === known) return;
      known = motion;
      if (shape.kind === "slider") {
        const next = Math.max(motion.largest(sizes.first + shape.numbers.value), 1e-12);
        sizes.boards[shape.parts[0].board ?? 0].scale(new Vector3((most || next) / next, 1, 1));
        most = next;
      }
      for (const each of still) each.update({ numbers: motion.row(0), first: sizes.first });
    },
  };
}
