// Lines of the model and terms of the equations, with the statements that they come from: each marks the others.
import { make } from "./dom.ts";
import type { Head, Span } from "./head.ts";

export type Item = { element: HTMLElement; spans: Span[]; term: boolean };

/** Pieces of one kind, with its letter as their class. */
function painted(text: string, inks: string): (HTMLElement | string)[] {
  if (text === "") return ["\u200b"];
  return [...inks.slice(0, text.length).matchAll(/(.)\1*/gs)].map(({ index, 0: run, 1: ink }) =>
    make("span", { className: `ink-${ink}`, textContent: text.slice(index, index + run.length) }));
}

/** The text of the model, line by line. */
export function lines(head: Head, place: HTMLElement): Item[] {
  let at = 0;
  const found = head.source.split("\n").map((text, i): Item => {
    const element = make("div", { className: "line" }, ...painted(text, head.inks.slice(at, (at += text.length + 1))));
    element.dataset.number = `${i + 1}`;
    return { element, spans: [{ first: [i + 1, 1], last: [i + 2, 1] }], term: false };
  });
  place.append(...found.map(({ element }) => element));
  return found;
}

/** Terms of the equations. */
export function terms(head: Head, place: HTMLElement): Item[] {
  return [...place.querySelectorAll<HTMLElement>("[data-from]")].map((element) => {
    const indices = element.dataset.from?.match(/\d+/g) ?? [];
    return { element, spans: indices.map((index) => head.sources[Number(index)]).filter((span) => span !== null), term: true };
  });
}

export class Marks {
  private pinned: Span[] = [];

  /** `pointed` is told what the pointer is on, or null, and `chosen` what was clicked. */
  constructor(private readonly items: Item[], pointed: (item: Item | null) => void, chosen: (item: Item) => void) {
    for (const item of items) {
      item.element.addEventListener("pointerenter", () => pointed(item));
      item.element.addEventListener("pointerleave", () => pointed(null));
      item.element.addEventListener("click", () => chosen(item));
    }
  }

  /** The first term or line that comes from statements. */
  first(spans: Span[], term: boolean): HTMLElement | null {
    return this.items.find((item) => item.term === term && overlap(item.spans, spans))?.element ?? null;
  }

  /** Marks that stay until others take their place. */
  pin(spans: Span[]): void {
    this.pinned = spans;
    this.mark(spans);
  }

  /** Marks what comes from statements; of terms only `alone`, if there is one. */
  mark(spans: Span[], alone?: Element): void {
    for (const { element, spans: own, term } of this.items) {
      const wanted = term && alone !== undefined ? [] : spans;
      element.classList.toggle("marked", element === alone || overlap(own, [...wanted, ...this.pinned]));
    }
  }
}

/** Have two of them a place in common? */
export function overlap(some: Span[], others: Span[]): boolean {
  const before = (x: Span["first"], y: Span["first"]): boolean => x[0] < y[0] || (x[0] === y[0] && x[1] < y[1]);
  return some.some((a) => others.some((b) => before(a.first, b.last) && before(b.first, a.last)));
}
