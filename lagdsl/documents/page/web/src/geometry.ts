// Unit geometries along z, and small linear algebra on rows of numbers.
import {
  Float32BufferAttribute,
  BufferGeometry,
  CylinderGeometry,
  Matrix4,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from "three";

const made = new Map<string, BufferGeometry>();

/** One geometry for all shapes that look alike. */
function once(name: string, make: () => BufferGeometry): BufferGeometry {
  const found = made.get(name) ?? make();
  made.set(name, found);
  return found;
}

/** A cylinder of radius 1 from z = 0 to z = 1. */
export function unitCylinder(segments: number, top = 1): BufferGeometry {
  return once(`cylinder ${top} ${segments}`, () =>
    new CylinderGeometry(top, 1, 1, segments).rotateX(Math.PI / 2).translate(0, 0, 0.5));
}

export function unitBall(segments: number): BufferGeometry {
  return once(`ball ${segments}`, () => new SphereGeometry(1, segments, Math.round(0.625 * segments)));
}

/** A ball whose octants are light and dark in turn, as one marks a mass center: one sees it turn. */
export function unitQuarters(segments: number): BufferGeometry {
  return once(`quarters ${segments}`, () => {
    const ball = unitBall(segments).toNonIndexed();
    const places = ball.getAttribute("position");
    const shades: number[] = [];
    for (let face = 0; face < places.count; face += 3) {
      let sign = 1;
      for (const k of [0, 1, 2]) sign *= Math.sign([0, 1, 2].reduce((sum, i) => sum + places.getComponent(face + i, k), 0));
      for (let k = 0; k < 9; ++k) shades.push(sign < 0 ? 1 : 0.72);
    }
    ball.setAttribute("color", new Float32BufferAttribute(shades, 3));
    return ball;
  });
}

/** A ring of radius 1 about z. */
export function unitRing(wire: number, across: number, segments: number): BufferGeometry {
  return once(`ring ${wire} ${across} ${segments}`, () => new TorusGeometry(1, wire, across, segments));
}

const TURNS = 9;
const STEPS = 16; // of a turn
const ROUND = 6; // corners of the wire
const STRAIGHT = 0.08; // of the length, at each end

/** A coil that `stretchCoil` lays: the faces of its wire, and places for their corners. */
export function coil(): BufferGeometry {
  const rings = TURNS * STEPS + 5; // two of each straight end, which is a piece of its own
  const faces: number[] = [];
  for (let i = 0; i + 1 < rings; ++i) {
    if (i === 1 || i === rings - 3) continue;
    for (let k = 0; k < ROUND; ++k) {
      const [a, b] = [i * ROUND + k, i * ROUND + ((k + 1) % ROUND)];
      faces.push(a, a + ROUND, b, b, a + ROUND, b + ROUND);
    }
  }
  const made = new BufferGeometry();
  made.setIndex(faces);
  for (const name of ["position", "normal"]) made.setAttribute(name, new Float32BufferAttribute(new Float32Array(3 * rings * ROUND), 3));
  return made;
}

/** The coil from z = 0 to z = length, with straight ends; `wire` is the radius of its wire. It is bent anew for each
 * length: a coil that is scaled has a wire as thick along its axis as the length is scaled. */
export function stretchCoil(geometry: BufferGeometry, length: number, radius: number, wire: number): void {
  const count = TURNS * STEPS;
  const places = geometry.getAttribute("position");
  const normals = geometry.getAttribute("normal");
  const rise = (1 - 2 * STRAIGHT) * length;
  const slope = rise / (2 * Math.PI * TURNS * radius); // of the wire, against the circle
  const slant = Math.hypot(1, slope);
  const ring = (i: number, center: Vector3, out: Vector3, up: Vector3): void => {
    for (let k = 0; k < ROUND; ++k) {
      const [c, s] = [Math.cos((2 * Math.PI * k) / ROUND), Math.sin((2 * Math.PI * k) / ROUND)];
      const [x, y, z] = [c * out.x + s * up.x, c * out.y + s * up.y, c * out.z + s * up.z];
      normals.setXYZ(i * ROUND + k, x, y, z);
      places.setXYZ(i * ROUND + k, center.x + wire * x, center.y + wire * y, center.z + wire * z);
    }
  };
  const [center, out, up] = [new Vector3(), new Vector3(), new Vector3()];
  for (let i = 0; i <= count; ++i) {
    const angle = (2 * Math.PI * i) / STEPS;
    out.set(Math.sin(angle), -Math.cos(angle), 0);
    up.set((-slope * Math.cos(angle)) / slant, (-slope * Math.sin(angle)) / slant, 1 / slant); // across out and the wire
    center.copy(out).multiplyScalar(radius).setZ(STRAIGHT * length + (rise * i) / count);
    ring(i + 2, center, out, up);
  }
  // From both ends a straight piece leads to the coil, which begins and ends at x = 0, y = -radius.
  up.set(-1, 0, 0);
  for (const [first, side] of [[0, -1], [count + 3, 1]]) {
    const [low, high] = side < 0 ? [0, STRAIGHT * length] : [(1 - STRAIGHT) * length, length];
    out.set(0, -STRAIGHT * length, side * radius).normalize();
    ring(first, center.set(0, side < 0 ? 0 : -radius, low), out, up);
    ring(first + 1, center.set(0, side < 0 ? -radius : 0, high), out, up);
  }
  places.needsUpdate = normals.needsUpdate = true;
  geometry.computeBoundingBox();
  geometry.computeBoundingSphere();
}

const X = new Vector3();
const Y = new Vector3();

/** The transformation that lays the unit length along z from a to b, with cross sections of the given size. */
export function between(a: Vector3, b: Vector3, width: number, height = width): Matrix4 {
  const z = new Vector3().subVectors(b, a);
  const length = z.length();
  const unit = length > 0 ? z.clone().divideScalar(length) : new Vector3(0, 0, 1);
  Y.set(0, 1, 0);
  if (Math.abs(unit.y) > 0.9) Y.set(1, 0, 0);
  X.crossVectors(Y, unit).normalize();
  Y.crossVectors(unit, X);
  const made = new Matrix4().makeBasis(
    X.clone().multiplyScalar(width),
    Y.clone().multiplyScalar(height),
    unit.multiplyScalar(Math.max(length, 1e-12)),
  );
  return made.setPosition(a);
}

/** Eigenvalues and unit eigenvectors of a symmetric matrix xx, yy, zz, xy, xz, yz, by Jacobi's rotations. */
export function principal(m: number[]): { values: number[]; axes: number[][] } {
  const a = [
    [m[0], m[3], m[4]],
    [m[3], m[1], m[5]],
    [m[4], m[5], m[2]],
  ];
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let sweep = 0; sweep < 20; ++sweep) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (Math.abs(a[p][q]) < 1e-300) continue;
      const theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
      const t = Math.sign(theta || 1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
      const c = 1 / Math.sqrt(t * t + 1);
      const s = t * c;
      for (let k = 0; k < 3; ++k) {
        [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
      }
      for (let k = 0; k < 3; ++k) {
        [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
        [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
      }
    }
  }
  return { values: [a[0][0], a[1][1], a[2][2]], axes: [0, 1, 2].map((i) => [v[0][i], v[1][i], v[2][i]]) };
}

/** Axes of a slender bar, I = m l^2/12, for a body with the moment about the normal of a plane alone: no ellipsoid has
 * it. Null for all others. */
export function barAlong([xx, yy, zz, xy, xz, yz]: number[], com: Vector3): number[][] | null {
  const others = Math.max(...[xx, yy, xy, xz, yz].map(Math.abs));
  const length = Math.hypot(com.x, com.y);
  if (!(others <= 1e-9 * zz && zz > 0 && length > 0 && Math.abs(com.z) <= 1e-9 * length)) return null;
  const [c, s] = [com.x / length, com.y / length];
  return [[c, s, 0], [-s, c, 0], [0, 0, 1]];
}
