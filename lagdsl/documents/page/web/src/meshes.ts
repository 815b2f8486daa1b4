// Triangles of meshes, as lagdsl/documents/page/packed.py packs them.
import { BufferAttribute, BufferGeometry } from "three";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { PackedMesh } from "./head.ts";
import { inflate } from "./packed.ts";

const SMOOTH = Math.PI / 6; // edges that turn less look round

export async function geometryOf(mesh: PackedMesh): Promise<BufferGeometry> {
  const data = new DataView((await inflate(mesh.data)).buffer);
  const places = new Float32Array(3 * mesh.points);
  for (let i = 0; i < places.length; ++i) places[i] = mesh.low[i % 3] + mesh.step[i % 3] * data.getUint16(2 * i, true);
  const corners = new Uint16Array(3 * mesh.triangles);
  for (let i = 0; i < corners.length; ++i) corners[i] = data.getUint16(2 * (places.length + i), true);
  const made = new BufferGeometry();
  made.setAttribute("position", new BufferAttribute(places, 3));
  made.setIndex(new BufferAttribute(corners, 1));
  return toCreasedNormals(made, SMOOTH);
}
