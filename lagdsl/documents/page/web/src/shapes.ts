// One maker for each kind of shape: an object of three.js, and how it follows the numbers of the scene.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  type ColorRepresentation,
  DoubleSide,
  Group,
  Line,
  LineBasicMaterial,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
  Sprite,
  SpriteMaterial,
  Vector3,
} from "three";
import { barAlong, between, coil, principal, stretchCoil, unitBall, unitCylinder, unitQuarters, unitRing } from "./geometry.ts";
import type { Shape } from "./head.ts";
import type { Motion } from "./motion.ts";

/** Numbers of the scene at one moment, and the sizes that were chosen for this machine. */
export interface Frame {
  numbers: Float64Array;
  first: number; // of the scene in a row
}
export interface Sizes {
  length: number; // of the machine [m]
  mass: number; // the largest [kg]
  force: number; // arrows: metres for a newton, for a newton metre
  torque: number;
  planar: boolean;
  first: number;
  center: Vector3; // of the machine
  meshes: readonly BufferGeometry[];
  detail: number; // of round shapes: the part of their faces that is drawn
}
export interface Drawn {
  object: Object3D;
  shape: Shape;
  update(frame: Frame): void;
  follow?(motion: Motion, row: number): void; // before update
}
/** Faces around a round shape, of which `many` are wanted. */
function around(sizes: Sizes, many: number): number {
  return Math.max(6, Math.round(many * sizes.detail));
}

type Maker = (shape: Shape, sizes: Sizes) => Drawn;

const CLEAR = 0.55; // opacity of ellipsoids of inertia
const COLORS: Record<string, ColorRepresentation> = {
  rod: 0x64748b, rope: 0x64748b, spring: 0x0d9488, damper: 0x7c3aed, mass: 0x2563eb, body: 0x3b82f6, box: 0x3b82f6,
  cylinder: 0x60a5fa, cone: 0x3b82f6, disc: 0x3b82f6, sphere: 0x2563eb, circle: 0x475569, mesh: 0x94a3b8, arrow: 0xd97706,
  force: 0xdc2626, torque: 0xea580c, trace: 0xd97706, slider: 0x2563eb, dial: 0x2563eb,
  ground: 0x94a3b8, velocity: 0x16a34a, acceleration: 0x9333ea, admissible: 0xdb2777, reaction: 0x0284c7,
  "reaction torque": 0x0e7490, constraint: 0xb45309, friction: 0xc026d3,
};

function colour(shape: Shape): ColorRepresentation {
  const named = shape.texts.color;
  return named !== undefined && CSS.supports("color", named) ? named : (COLORS[shape.kind] ?? 0x64748b);
}

function solid(shape: Shape, geometry: BufferGeometry): Mesh {
  const material = new MeshLambertMaterial({ color: colour(shape) });
  const mesh = new Mesh(geometry, material);
  mesh.matrixAutoUpdate = false;
  return mesh;
}

export function vector(shape: Shape, role: string, frame: Frame): Vector3 {
  const at = frame.first + shape.numbers[role];
  return new Vector3(frame.numbers[at], frame.numbers[at + 1], frame.numbers[at + 2]);
}

function scalar(shape: Shape, role: string, frame: Frame, otherwise: number): number {
  const at = shape.numbers[role];
  return at === undefined ? otherwise : frame.numbers[frame.first + at];
}

/** Axes of the frame that the shape stands on, else of the world. */
function axes(shape: Shape, frame: Frame): [Vector3, Vector3, Vector3] {
  if (!("x" in shape.numbers)) return [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
  return [vector(shape, "x", frame), vector(shape, "y", frame), vector(shape, "z", frame)];
}

function posed(shape: Shape, frame: Frame, a: number, b: number, c: number): Matrix4 {
  const [x, y, z] = axes(shape, frame);
  const made = new Matrix4().makeBasis(x.multiplyScalar(a), y.multiplyScalar(b), z.multiplyScalar(c));
  return made.setPosition(vector(shape, "at", frame));
}

/** The direction of a shape with an axis: that of `axis` in the frame's own axes, else z. */
function along(shape: Shape, frame: Frame): Vector3 {
  const [x, y, z] = axes(shape, frame);
  if (!shape.vectors.includes("axis")) return z;
  const own = vector(shape, "axis", frame);
  const made = x.multiplyScalar(own.x).addScaledVector(y, own.y).addScaledVector(z, own.z);
  return made.lengthSq() > 0 ? made.normalize() : new Vector3(0, 0, 1);
}

function bar(shape: Shape, sizes: Sizes, geometry: BufferGeometry, part: number): Drawn {
  const object = solid(shape, geometry);
  return {
    object,
    shape,
    update(frame) {
      const radius = scalar(shape, "radius", frame, part * sizes.length);
      object.matrix.copy(between(vector(shape, "at", frame), vector(shape, "to", frame), radius));
    },
  };
}

/** A coil between two points. */
function spring(shape: Shape, sizes: Sizes): Drawn {
  const geometry = coil();
  const object = solid(shape, geometry);
  object.userData.bent = true;
  let [known, wide] = [0, 0];
  return {
    object,
    shape,
    update(frame) {
      const [a, b] = [vector(shape, "at", frame), vector(shape, "to", frame)];
      const radius = scalar(shape, "radius", frame, 0.03 * sizes.length);
      const length = a.distanceTo(b);
      if (length !== known || radius !== wide) stretchCoil(geometry, length, radius, 0.16 * radius);
      [known, wide] = [length, radius];
      object.matrix.copy(between(a, b, 1)).scale(new Vector3(1, 1, 1 / Math.max(length, 1e-12)));
    },
  };
}

/** Thick in the middle. */
function damper(shape: Shape, sizes: Sizes): Drawn {
  const object = new Group();
  const thin = solid(shape, unitCylinder(around(sizes, 24)));
  const thick = solid(shape, unitCylinder(around(sizes, 24)));
  object.add(thin, thick);
  return {
    object,
    shape,
    update(frame) {
      const [a, b] = [vector(shape, "at", frame), vector(shape, "to", frame)];
      thin.matrix.copy(between(a, b, 0.005 * sizes.length));
      thick.matrix.copy(between(a.clone().lerp(b, 0.2), a.clone().lerp(b, 0.6), 0.016 * sizes.length));
    },
  };
}

function ball(shape: Shape, sizes: Sizes): Drawn {
  const object = solid(shape, unitBall(around(sizes, 32)));
  return {
    object,
    shape,
    update(frame) {
      const mass = scalar(shape, "mass", frame, sizes.mass);
      const share = sizes.mass > 0 ? Math.cbrt(Math.max(mass, 0) / sizes.mass) : 1;
      const radius = scalar(shape, "radius", frame, 0.04 * sizes.length * Math.max(share, 0.25));
      object.matrix.copy(posed(shape, frame, radius, radius, radius));
    },
  };
}

/** The homogeneous ellipsoid of the mass and inertia: a^2 = 5 (I_yy + I_zz - I_xx) / (2 m), or a bar. */
function ellipsoid(shape: Shape, sizes: Sizes): Drawn {
  const object = solid(shape, unitQuarters(around(sizes, 32)));
  // Bodies may stand in each other: gimbals and their rotor.
  Object.assign(object.material, { transparent: true, opacity: CLEAR, depthWrite: false, vertexColors: true });
  return {
    object,
    shape,
    update(frame) {
      const mass = scalar(shape, "mass", frame, 1);
      const first = frame.first + shape.numbers.inertia;
      const { values, axes: own } = principal(Array.from(frame.numbers.subarray(first, first + 6)));
      const total = values[0] + values[1] + values[2];
      const least = 0.012 * sizes.length;
      const semi = values.map((value) => {
        const square = (2.5 * (total - 2 * value)) / mass;
        return mass > 0 && square > 0 ? Math.min(Math.max(Math.sqrt(square), least), sizes.length) : least;
      });
      const [x, y, z] = axes(shape, frame);
      const turned = (v: number[]) =>
        new Vector3().addScaledVector(x, v[0]).addScaledVector(y, v[1]).addScaledVector(z, v[2]);
      const com = vector(shape, "com", frame);
      const bar = barAlong(Array.from(frame.numbers.subarray(first, first + 6)), com);
      const half = Math.min(Math.sqrt((3 * total) / mass), sizes.length);
      const basis = bar
        ? bar.map((axis, i) => turned(axis).multiplyScalar(i === 0 ? half : least))
        : own.map((axis, i) => turned(axis).multiplyScalar(semi[i]));
      const at = vector(shape, "at", frame).add(turned([com.x, com.y, com.z]));
      object.matrix.makeBasis(basis[0], basis[1], basis[2]).setPosition(at);
    },
  };
}

/** Length along x (or from A to B), width and height across; in planar pictures the height is upright. */
function box(shape: Shape, sizes: Sizes): Drawn {
  const object = solid(shape, new BoxGeometry(1, 1, 1));
  const size = 0.09 * sizes.length;
  return {
    object,
    shape,
    update(frame) {
      const width = scalar(shape, "width", frame, size);
      const height = scalar(shape, "height", frame, size);
      const [across, up] = sizes.planar ? [height, width] : [width, height];
      if ("to" in shape.numbers) {
        const [a, b] = [vector(shape, "at", frame), vector(shape, "to", frame)];
        object.matrix.copy(between(a, b, across, up)).multiply(new Matrix4().makeTranslation(0, 0, 0.5));
      } else if (shape.vectors.includes("size")) {
        const own = vector(shape, "size", frame);
        object.matrix.copy(posed(shape, frame, own.x, own.y, own.z));
      } else {
        const length = scalar(shape, "length", frame, size);
        object.matrix.copy(posed(shape, frame, length, across, up));
      }
    },
  };
}

/** Cylinders, discs and cones on a frame stand about their axis, their middle at its origin. */
function turned(part: number, slim: number, top: number): Maker {
  return (shape, sizes) => {
    const object = solid(shape, unitCylinder(around(sizes, 40), top));
    return {
      object,
      shape,
      update(frame) {
        const radius = scalar(shape, "radius", frame, part * sizes.length);
        const a = vector(shape, "at", frame);
        if ("to" in shape.numbers) {
          object.matrix.copy(between(a, vector(shape, "to", frame), radius));
          return;
        }
        const axis = along(shape, frame);
        const length = scalar(shape, "length", frame, scalar(shape, "height", frame, slim * radius));
        const middle = top === 1;
        const from = middle ? a.clone().addScaledVector(axis, -length / 2) : a.clone().addScaledVector(axis, length);
        const to = middle ? a.clone().addScaledVector(axis, length / 2) : a;
        object.matrix.copy(between(from, to, radius));
        if ("x" in shape.numbers) spin(object.matrix, vector(shape, "x", frame), radius);
      },
    };
  };
}

/** Turns the cross section with the frame, so that one sees it roll. */
function spin(matrix: Matrix4, x: Vector3, radius: number): void {
  const z = new Vector3().setFromMatrixColumn(matrix, 2);
  const position = new Vector3().setFromMatrixPosition(matrix);
  const unit = z.clone().normalize();
  const own = x.clone().addScaledVector(unit, -x.dot(unit));
  if (own.lengthSq() < 1e-12) return;
  own.normalize();
  const y = new Vector3().crossVectors(unit, own);
  matrix.makeBasis(own.multiplyScalar(radius), y.multiplyScalar(radius), z).setPosition(position);
}

/** A disc shows that it turns: a spoke on both faces. */
function disc(shape: Shape, sizes: Sizes): Drawn {
  const drawn = turned(0.1, 0.12, 1)(shape, sizes);
  const spoke = new Mesh(new BoxGeometry(0.9, 0.08, 1.04).translate(0.45, 0, 0.5), new MeshLambertMaterial({ color: 0xf8fafc }));
  drawn.object.add(spoke);
  return drawn;
}

function circle(shape: Shape, sizes: Sizes): Drawn {
  const large = "radius" in shape.numbers;
  const object = solid(shape, large ? unitRing(0.02, around(sizes, 12), 64) : unitRing(0.28, around(sizes, 8), around(sizes, 24)));
  return {
    object,
    shape,
    update(frame) {
      const radius = scalar(shape, "radius", frame, 0.014 * sizes.length);
      object.matrix.copy(posed(shape, frame, radius, radius, radius));
    },
  };
}

/** Triangles of a file; none where the file has none. */
function surface(shape: Shape, sizes: Sizes): Drawn {
  const object = solid(shape, sizes.meshes[shape.mesh ?? -1] ?? new BufferGeometry());
  (object.material as MeshLambertMaterial).side = DoubleSide;
  return {
    object,
    shape,
    update(frame) {
      const one = scalar(shape, "scale", frame, 1);
      const { x, y, z } = shape.vectors.includes("scale") ? vector(shape, "scale", frame) : new Vector3(one, one, one);
      object.matrix.copy(posed(shape, frame, x, y, z));
    },
  };
}

/** From tail to tip. Loads are as long as they are large; a direction of the user has one length, two points theirs. */
type Way = (shape: Shape, frame: Frame, sizes: Sizes) => Vector3;

const load =
  (kind: "force" | "torque"): Way =>
  (shape, frame, sizes) => vector(shape, "vector", frame).multiplyScalar(sizes[kind]);

const direction: Way = (shape, frame, sizes) =>
  "vector" in shape.numbers
    ? vector(shape, "vector", frame).normalize().multiplyScalar(0.2 * sizes.length)
    : vector(shape, "to", frame).sub(vector(shape, "at", frame));

function arrow(wayOf: Way): Maker {
  return (shape, sizes) => {
    const object = new Group();
    const shaft = solid(shape, unitCylinder(around(sizes, 24)));
    const tip = solid(shape, unitCylinder(around(sizes, 24), 0.001));
    object.add(shaft, tip);
    return {
      object,
      shape,
      update(frame) {
        const at = vector(shape, "at", frame);
        const way = wayOf(shape, frame, sizes);
        const length = way.length();
        object.visible = length > 1e-6 * sizes.length;
        if (!object.visible) return;
        const head = Math.min(0.05 * sizes.length, 0.6 * length);
        const neck = at.clone().addScaledVector(way, 1 - head / length);
        shaft.matrix.copy(between(at, neck, 0.006 * sizes.length));
        tip.matrix.copy(between(neck, at.clone().add(way), 0.018 * sizes.length));
      },
    };
  };
}

/** The way of a point so far, and faintly all of it. */
function trace(shape: Shape, sizes: Sizes): Drawn {
  const object = new Group();
  const past = new Line(new BufferGeometry(), new LineBasicMaterial({ color: colour(shape) }));
  const all = new Line(past.geometry.clone(), new LineBasicMaterial({ color: colour(shape), transparent: true, opacity: 0.25 }));
  past.frustumCulled = all.frustumCulled = false;
  object.add(past, all);
  let known: Motion | null = null;
  return {
    object,
    shape,
    update() {},
    follow(motion, row) {
      if (motion !== known) {
        known = motion;
        const places = new Float32Array(3 * motion.count);
        const at = sizes.first + shape.numbers.at;
        for (let i = 0; i < motion.count; ++i) {
          for (let k = 0; k < 3; ++k) places[3 * i + k] = motion.at(i, at + k);
        }
        for (const line of [past, all]) {
          line.geometry.dispose();
          line.geometry = new BufferGeometry();
          line.geometry.setAttribute("position", new BufferAttribute(places, 3));
        }
      }
      past.geometry.setDrawRange(0, row + 1);
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

function written(shape: Shape, sizes: Sizes): Drawn {
  const object = label(shape.texts.text ?? shape.name, 0.06 * sizes.length, "#64748b");
  return { object, shape, update: (frame) => void object.position.copy(vector(shape, "at", frame)) };
}

function tripod(shape: Shape, sizes: Sizes): Drawn {
  const object = new Group();
  const size = (shape.name === "world" ? 0.12 : 0.07) * sizes.length;
  const colours = [0xdc2626, 0x16a34a, 0x2563eb];
  const bars = colours.map((color) => {
    const mesh = new Mesh(unitCylinder(8), new MeshLambertMaterial({ color }));
    mesh.matrixAutoUpdate = false;
    object.add(mesh);
    return mesh;
  });
  return {
    object,
    shape,
    update(frame) {
      const at = vector(shape, "at", frame);
      ["x", "y", "z"].forEach((role, i) => {
        const end = at.clone().addScaledVector(vector(shape, role, frame), size);
        bars[i].matrix.copy(between(at, end, 0.03 * size));
      });
    },
  };
}

/** A plane that a contact keeps something from: it lies still, under the machine. */
function ground(shape: Shape, sizes: Sizes): Drawn {
  const object = solid(shape, new BoxGeometry(1, 1, 1).translate(0, 0, -0.5));
  let known: Motion | null = null;
  return {
    object,
    shape,
    update() {},
    follow(motion) {
      if (motion === known) return;
      known = motion;
      const frame = { numbers: Float64Array.from({ length: motion.width }, (_, i) => motion.at(0, i)), first: sizes.first };
      const normal = vector(shape, "normal", frame);
      const foot = vector(shape, "at", frame);
      const middle = sizes.center.clone().addScaledVector(normal, normal.dot(foot.sub(sizes.center)));
      const top = middle.clone().addScaledVector(normal, -1);
      const size = 1.3 * sizes.length;
      object.matrix.copy(between(top, middle, size, size)).multiply(new Matrix4().makeTranslation(0, 0, 1));
      object.matrix.multiply(new Matrix4().makeScale(1, 1, 0.02 * sizes.length));
    },
  };
}

export const MAKERS: Record<string, Maker> = {
  rod: (shape, sizes) => bar(shape, sizes, unitCylinder(around(sizes, 24)), 0.007),
  rope: (shape, sizes) => bar(shape, sizes, unitCylinder(around(sizes, 24)), 0.004),
  spring,
  damper,
  box,
  cylinder: turned(0.03, 2.4, 1),
  cone: turned(0.06, 2, 0.001),
  disc,
  sphere: ball,
  mass: ball,
  body: ellipsoid,
  circle,
  mesh: surface,
  arrow: arrow(direction),
  force: arrow(load("force")),
  torque: arrow(load("torque")),
  trace,
  text: written,
  frame: tripod,
  ground,
};
