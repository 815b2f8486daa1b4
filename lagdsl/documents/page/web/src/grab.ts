// The machine is taken by hand: a place of it or the hand of a dial goes where it is pulled. The starts follow.
import type { Vector3 } from "three";
import type { Head } from "./head.ts";
import type { Pull } from "./orders.ts";
import type { Held, Stage } from "./stage.ts";

const FIRST = 3; // [pixels] that a click may move

/** Coordinates with a start value of their own. */
export function startsOf(head: Head, length: number): Pull["starts"] {
  return head.columns.flatMap(({ name, kind, unit }, column) => {
    const parameter = head.parameters.findIndex((quantity) => kind === "coordinate" && quantity.name === `${name}.start`);
    return parameter < 0 ? [] : [{ parameter, column, size: unit === "m" ? length : 1 }];
  });
}

/** `begin`: the page goes to its start with the present posture. */
export function grab(head: Head, stage: Stage, place: HTMLElement, hands: { ready(): boolean; begin(): void; pull(pull: Pull): void }): void {
  let held: Held | null = null;
  let [x, y] = [0, 0];
  let off: Vector3 | null = null; // from the place that is held to the pointer; null: nothing has moved yet
  const starts = startsOf(head, head.stage.length);
  // Before the camera sees it.
  place.addEventListener("pointerdown", (event) => {
    held = hands.ready() && event.button === 0 && starts.length > 0 && event.target === stage.canvas ? stage.held(event.clientX, event.clientY) : null;
    if (held === null) return;
    event.stopPropagation();
    [x, y, off] = [event.clientX, event.clientY, null];
    stage.canvas.setPointerCapture(event.pointerId);
  }, { capture: true });
  place.addEventListener("pointermove", (event) => {
    if (held === null) return;
    if (off === null) {
      if (Math.hypot(event.clientX - x, event.clientY - y) < FIRST) return;
      hands.begin();
      off = stage.facingPlace(x, y, held.point).place.sub(held.point);
    }
    const { place: there, across } = stage.facingPlace(event.clientX, event.clientY, held.point);
    const into = held.axes.clone().invert();
    const goal = there.sub(off).applyMatrix4(into).toArray();
    hands.pull({ parts: held.parts, goal, across: across.map((each) => each.transformDirection(into).toArray()), starts });
  });
  for (const end of ["pointerup", "pointercancel"] as const) place.addEventListener(end, () => (held = null));
}
