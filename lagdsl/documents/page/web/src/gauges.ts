// Coordinates that move nothing in the picture: a dial for an angle, a slide for any other.
import { type Box3, BoxGeometry, type BufferGeometry, Group, type Matrix4, Mesh, MeshLambertMaterial, TorusGeometry, Vector3 } from "three";
import type { Shape } from "./head.ts";
import type { Motion } from "./motion.ts";
import { label, type Drawn, type Frame, type Sizes } from "./shapes.ts";

const [INK, HAND, FRAME] = ["#64748b", "#2563eb", "#94a3b8"];

export function isGauge(shape: Shape): boolean {
  return shape.kind === "slider" || shape.kind === "dial";
}

/** In a row below the machine, upright and turned towards the viewer: `facing` has the directions right, up and back. */
export function gauge(shape: Shape, sizes: Sizes, box: Box3, facing: Matrix4, index: number, count: number): Drawn {
  const size = 0.16 * sizes.length;
  const [right, up] = [0, 1].map((k) => new Vector3().setFromMatrixColumn(facing, k));
  const object = new Group();
  const part = (color: string, geometry: BufferGeometry): Mesh => {
    const made = new Mesh(geometry.scale(size, size, size), new MeshLambertMaterial({ color }));
    object.add(made);
    return made;
  };
  object.quaternion.setFromRotationMatrix(facing);
  const center = box.getCenter(new Vector3());
  const low = Math.min(up.dot(box.min), up.dot(box.max)) - up.dot(center);
  object.position.copy(center).addScaledVector(up, low - 1.7 * size).addScaledVector(right, (index - (count - 1) / 2) * 2.6 * size);
  const name = label(shape.name, 0.4 * size, INK);
  name.position.set(0, -1.3 * size, 0);
  object.add(name);
  const value = (frame: Frame): number => frame.numbers[frame.first + shape.numbers.value];
  if (shape.kind === "dial") {
    part(FRAME, new TorusGeometry(1, 0.05, 12, 64));
    const hand = part(HAND, new BoxGeometry(0.12, 1, 0.12).translate(0, 0.5, 0));
    return { object, shape, update: (frame) => void hand.rotation.set(0, 0, value(frame)) };
  }
  part(FRAME, new BoxGeometry(2.2, 0.06, 0.06));
  const carriage = part(HAND, new BoxGeometry(0.5, 0.5, 0.5));
  let known: Motion | null = null;
  let largest = 1; // of the motion: so long is the slide
  return {
    object,
    shape,
    update: (frame) => void (carriage.position.x = (0.85 * size * value(frame)) / largest),
    follow(motion) {
      if (motion !== known) largest = Math.max(motion.largest(sizes.first + shape.numbers.value), 1e-12);
      known = motion;
    },
  };
}
