// Terms of the equations and the statements that they come from: each marks the other.
import type { Head, Span } from "./head.ts";

export class Terms {
  private readonly terms: { element: Element; spans: Span[] }[];
  private pinned: Span | null = null;

  constructor(head: Head, place: HTMLElement, pointed: (spans: Span[]) => void, chosen: (spans: Span[]) => void) {
    this.terms = [...place.querySelectorAll("[data-from]")].map((element) => {
      const indices = (element.getAttribute("data-from") ?? "").split(" ").filter((index) => index !== "");
      const spans = indices.map((index) => head.sources[Number(index)]).filter((span) => span !== null);
      return { element, spans };
    });
    for (const { element, spans } of this.terms) {
      element.addEventListener("pointerenter", () => {
        this.mark(null);
        element.classList.add("marked");
        pointed(spans);
      });
      element.addEventListener("pointerleave", () => {
        this.mark(null);
        pointed([]);
      });
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
  return before(a.first, b.last) && before(b.first, a.last);
}

function before(a: [number, number], b: [number, number]): boolean {
  return a[0] < b[0] || (a[0] === b[0] && a[1] < b[1]);
}
