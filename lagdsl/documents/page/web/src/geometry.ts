// Where parts stand, and tubes along lines.
import { BufferGeometry, Float32BufferAttribute, Vector3 } from "three";

const ROUND = 6; // corners of a tube

/** Unit axes: z along a way, x as near as may be to a direction, else across the vertical z (y where z is that). */
export function axesAlong(way: Vector3, about: Vector3 | null): [Vector3, Vector3, Vector3] {
  const z = way.lengthSq() > 0 ? way.clone().normalize() : new Vector3(0, 0, 1);
  const x = about === null ? new Vector3() : about.clone().addScaledVector(z, -about.dot(z));
  if (x.length() < 1e-6) x.set(0, Number(Math.abs(z.z) > 0.9), Number(Math.abs(z.z) <= 0.9)).cross(z);
  x.normalize();
  return [x, new Vector3().crossVectors(z, x), z];
}

/** A tube along points; its cross section does not twist. */
export function tube(points: readonly Vector3[], radius: number): BufferGeometry {
  const [places, faces]: number[][] = [[], []];
  const [way, out, side] = [new Vector3(), new Vector3(), new Vector3()];
  points.forEach((point, i) => {
    way.subVectors(points[Math.min(i + 1, points.length - 1)], points[Math.max(i - 1, 0)]).normalize();
    out.addScaledVector(way, -out.dot(way));
    if (out.length() < 1e-3) out.copy(axesAlong(way, null)[0]);
    side.crossVectors(way, out.normalize());
    for (let k = 0; k < ROUND; ++k) {
      const angle = (2 * Math.PI * k) / ROUND;
      places.push(...point.clone().addScaledVector(out, radius * Math.cos(angle)).addScaledVector(side, radius * Math.sin(angle)));
      const [a, b] = [(i - 1) * ROUND + k, (i - 1) * ROUND + ((k + 1) % ROUND)];
      if (i > 0) faces.push(a, b, a + ROUND, b, b + ROUND, a + ROUND);
    }
  });
  const made = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(places, 3)).setIndex(faces);
  made.computeVertexNormals();
  return made;
}
