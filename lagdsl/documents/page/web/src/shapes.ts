// The primitives of pictures, as lagdsl/derivation/scene tells them: objects of three.js that follow numbers of the scene.
import {
  BufferAttribute, BufferGeometry, CanvasTexture, Color, DoubleSide, Group, Line, LineBasicMaterial, Mesh, MeshLambertMaterial, type Object3D, Sprite,
  SpriteMaterial, Matrix4, Vector3, Vector4,
} from "three";
import { axesAlong, tube } from "./geometry.ts";
import type { Part, Shape } from "./head.ts";
import type { Motion } from "./motion.ts";

/** Numbers of the scene at one moment. */
export type Numbers = ArrayLike<number>;

/** Sizes that were chosen for this machine. */
export interface Sizes {
  length: number; // of the machine [m]
  scales: Record<string, number>; // of arrows: metres for a newton, for a newton metre
  boards: Matrix4[]; // of gauges
  first: number; // of the scene in a row
  center: Vector3; // of the machine
  forms: ReadonlyMap<string, BufferGeometry>;
  coil: readonly number[][];
  meshes: readonly BufferGeometry[];
}
export interface Drawn {
  object: Object3D;
  shape: Shape;
  /** Of arrows there is no motion: they leave no trace. */
  update(row: Numbers, motion?: Motion, number?: number): void;
}
type Pieces = Pick<Drawn, "object" | "update">;

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

export function vector(numbers: Record<string, number>, role: string, row: Numbers): Vector3 {
  const at = numbers[role];
  return new Vector3(row[at], row[at + 1], row[at + 2]);
}

/** A vector of a part; those of one on a board are in the axes and the unit of that. */
function vectorOf({ numbers, board }: Part, role: string, sizes: Sizes, row: Numbers): Vector3 {
  const own = vector(numbers, role, row);
  if (board === undefined) return own;
  const { x, y, z } = new Vector4(...own, Number(role === "at" || role === "to")).applyMatrix4(sizes.boards[board]);
  return new Vector3(x, y, z);
}

function sizeOf(part: Part, axis: number, sizes: Sizes, row: Numbers): number {
  const [factor, column, relative] = part.sizes?.[axis] ?? [1, -1, true];
  return factor * (column < 0 ? 1 : row[column]) * (relative ? sizes.length : 1);
}

interface Place {
  matrix: Matrix4; // without its sizes
  sizes: [number, number, number];
  seen: boolean; // its axis has a length
}

/** Where a part stands, and how it is stretched. */
function place(part: Part, sizes: Sizes, row: Numbers): Place {
  const { numbers, scale } = part;
  const at = vectorOf(part, "at", sizes, row);
  const to = "to" in numbers ? vectorOf(part, "to", sizes, row).sub(at) : null;
  const way = to ?? ("z" in numbers ? vectorOf(part, "z", sizes, row) : new Vector3(0, 0, 1));
  const shown = way.length() * (scale ? sizes.scales[scale] : 1);
  const own = [0, 1, 2].map((axis) => sizeOf(part, axis, sizes, row) * (scale && !part.sizes?.[axis][2] ? shown : 1)) as Place["sizes"];
  if (!scale && to !== null) own[2] = shown;
  const [x, y, z] = axesAlong(way, "x" in numbers ? vectorOf(part, "x", sizes, row) : null);
  if (part.still) {
    const away = sizes.center.clone().sub(at);
    at.add("x" in numbers ? x.clone().multiplyScalar(away.dot(x)) : away.addScaledVector(z, -away.dot(z)));
  }
  at.addScaledVector(z, (part.offset ?? 0) * sizes.length);
  return { matrix: new Matrix4().makeBasis(x, y, z).setPosition(at), sizes: own, seen: shown > (scale ? SHORTEST * sizes.length : 0) };
}

/** Triangles of a unit body, or of a file; nothing where the file has none. */
function surface(part: Part, shape: Shape, sizes: Sizes): Pieces {
  const file = part.form === "file";
  const geometry = file ? sizes.meshes[shape.mesh ?? -1] : sizes.forms.get(part.form ?? "");
  const object = solid(part, geometry ?? new BufferGeometry());
  if (file) (object.material as MeshLambertMaterial).side = DoubleSide;
  return {
    object,
    update(row) {
      const { matrix, sizes: own, seen } = place(part, sizes, row);
      object.visible = seen;
      object.matrix.copy(matrix.scale(new Vector3(...own)));
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
    update(row) {
      const radius = sizeOf(part, 2, sizes, row);
      let points: Vector3[];
      if (part.form === "coil") {
        const { matrix, sizes: own } = place(part, sizes, row);
        object.matrix.copy(matrix);
        if (known === `${own}`) return;
        known = `${own}`;
        points = sizes.coil.map(([x, y, z]) => new Vector3(x * own[0], y * own[1], z * own[2]));
      } else {
        const first = part.numbers.points;
        points = Array.from({ length: part.count ?? 0 }, (_, k) => vector({ at: first + 3 * k }, "at", row));
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
  let known: Motion | undefined;
  return {
    object,
    update(_, motion, number = 0) {
      if (motion !== undefined && motion !== known) {
        known = motion;
        const at = sizes.first + part.numbers.at;
        const places = Float32Array.from({ length: 3 * motion.count }, (_, i) => motion.at(Math.floor(i / 3), at + (i % 3)));
        for (const each of lines) {
          each.geometry.dispose();
          each.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(places, 3));
        }
      }
      lines[0].geometry.setDrawRange(0, number + 1);
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
  return { object, update: (row) => void object.position.copy(vectorOf(part, "at", sizes, row)) };
}

const MAKERS: Record<Part["primitive"], (part: Part, shape: Shape, sizes: Sizes) => Pieces> = {
  surface, line, trace, label: written,
};

/** A shape with all its parts; those that lie still stand where the motion begins. */
export function drawn(shape: Shape, sizes: Sizes): Drawn {
  const object = new Group();
  const pieces = shape.parts.map((part) => {
    const made = MAKERS[part.primitive](part, shape, sizes);
    made.object.traverse((each) => Object.assign(each.userData, { part, shape }));
    object.add(made.object);
    return { ...made, still: part.still ?? false };
  });
  let known: Motion | undefined;
  let most = 0; // value of a slider along the motion
  return {
    object,
    shape,
    update(row, motion, number) {
      const first = motion !== known ? motion : undefined;
      known = motion;
      if (shape.kind === "slider" && first !== undefined) {
        const next = Math.max(first.largest(sizes.first + shape.numbers.value), 1e-12);
        sizes.boards[shape.parts[0].board ?? 0].scale(new Vector3((most || next) / next, 1, 1));
        most = next;
      }
      for (const each of pieces) if (!each.still) each.update(row, motion, number);
      else if (first !== undefined) each.update(first.row(0).subarray(sizes.first));
    },
  };
}
