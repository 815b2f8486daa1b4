// Coordinates that move nothing in the picture: a dial for an angle, a slide for any other.
import { BoxGeometry, type Box3, Group, type Matrix4, Mesh, MeshLambertMaterial, TorusGeometry, Vector3 } from "three";
import type { Shape } from "./head.ts";
import type { Motion } from "./motion.ts";
import { label, type Drawn, type Frame, type Sizes } from "./shapes.ts";

function part(color: number, geometry: BoxGeometry | TorusGeometry): Mesh {
  return new Mesh(geometry, new MeshLambertMaterial({ color }));
}

/** In a row below the machine, upright and turned towards the viewer: `facing` has the directions right, up and back. */
export function gauge(shape: Shape, sizes: Sizes, box: Box3, facing: Matrix4, index: number, count: number): Drawn {
  const size = 0.16 * sizes.length;
  const right = new Vector3().setFromMatrixColumn(facing, 0);
  const up = new Vector3().setFromMatrixColumn(facing, 1);
  const object = new Group();
  object.quaternion.setFromRotationMatrix(facing);
  const center = box.getCenter(new Vector3());
  const low = Math.min(up.dot(box.min), up.dot(box.max)) - up.dot(center);
  object.position.copy(center).addScaledVector(up, low - 1.7 * size);
  object.position.addScaledVector(right, (index - (count - 1) / 2) * 2.6 * size);
  const name = label(shape.name, 0.4 * size, "#64748b");
  name.position.set(0, -1.3 * size, 0);
  object.add(name);
  const value = (frame: Frame): number => frame.numbers[frame.first + shape.numbers.value];
  if (shape.kind === "dial") {
    const hand = part(0x2563eb, new BoxGeometry(0.12 * size, size, 0.12 * size));
    hand.geometry.translate(0, 0.5 * size, 0);
    object.add(part(0x94a3b8, new TorusGeometry(size, 0.05 * size, 12, 64)), hand);
    return { object, shape, update: (frame) => void hand.rotation.set(0, 0, value(frame)) };
  }
  const carriage = part(0x2563eb, new BoxGeometry(0.5 * size, 0.5 * size, 0.5 * size));
  object.add(part(0x94a3b8, new BoxGeometry(2.2 * size, 0.06 * size, 0.06 * size)), carriage);
  let known: Motion | null = null;
  let largest = 1; // of the motion: so long is the slide
  return {
    object,
    shape,
    update: (frame) => void (carriage.position.x = (0.85 * size * value(frame)) / largest),
    follow(motion) {
      if (motion === known) return;
      known = motion;
      largest = Math.max(motion.largest(sizes.first + shape.numbers.value), 1e-12);
    },
  };
}
