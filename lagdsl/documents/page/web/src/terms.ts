// Terms of the equations and the statements that they come from: each marks the other.
import type { Head, Span } from "./head.ts";

export class Terms {
  private readonly terms: { element: Element; spans: Span[] }[];
  private pinned: Span | null = null;

  constructor(head: Head, place: HTMLElement, pointed: (spans: Span[]) => void, chosen: (spans: Span[]) => void) {
    this.terms = [...place.querySelectorAll<HTMLElement>("[data-from]")].map((element) => {
      const indices = element.dataset.from?.match(/\d+/g) ?? [];
      return { element, spans: indices.map((index) => head.sources[Number(index)]).filter((span) => span !== null) };
    });
    for (const { element, spans } of this.terms) {
      const over = (on: boolean): void => {
        this.mark(null);
        if (on) element.classList.add("marked");
        pointed(on ? spans : []);
      };
      element.addEventListener("pointerenter", () => over(true));
      element.addEventListener("pointerleave", () => over(false));
      element.addEventListener("click", () => chosen(spans));
    }
  }

  /** The first term that comes from a statement. */
  first(span: Span): Element | null {
    return this.terms.find(({ spans }) => spans.some((each) => overlap(each, span)))?.element ?? null;
  }

  /** Marks that stay until others take their place. */
  pin(span: Span | null): void {
    this.pinned = span;
    this.mark(null);
  }

  /** Marks what comes from a statement. */
  mark(span: Span | null): void {
    const from = [span, this.pinned].filter((each) => each !== null);
    for (const { element, spans } of this.terms) {
      element.classList.toggle("marked", spans.some((each) => from.some((other) => overlap(each, other))));
    }
  }
}

export function overlap(a: Span, b: Span): boolean {
  const before = (x: Span["first"], y: Span["first"]): boolean => x[0] < y[0] || (x[0] === y[0] && x[1] < y[1]);
  return before(a.first, b.last) && before(b.first, a.last);
}
