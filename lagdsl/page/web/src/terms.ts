// Terms of the equations and the statements that they come from: each marks the other.
import type { Head, Span } from "./head.ts";

export class Terms {
  private readonly terms: { element: Element; spans: Span[] }[];

  constructor(head: Head, place: HTMLElement, pointed: (spans: Span[]) => void) {
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
        element.classList.remove("marked");
        pointed([]);
      });
    }
  }

  /** Marks what comes from a statement. */
  mark(span: Span | null): void {
    for (const { element, spans } of this.terms) {
      element.classList.toggle("marked", span !== null && spans.some((each) => overlap(each, span)));
    }
  }
}

export function overlap(a: Span, b: Span): boolean {
  return before(a.first, b.last) && before(b.first, a.last);
}

function before(a: [number, number], b: [number, number]): boolean {
  return a[0] < b[0] || (a[0] === b[0] && a[1] < b[1]);
}
