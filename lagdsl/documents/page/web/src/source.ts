// The text of the model; what a shape comes from is marked in it.
import type { Head, Span } from "./head.ts";

/** `pointed` is told the line under the pointer, as a span, and `chosen` one that was clicked. */
export class Source {
  private readonly lines: HTMLElement[];
  private pinned: Span[] = [];

  constructor(head: Head, place: HTMLElement, pointed: (line: Span | null) => void, chosen: (line: Span) => void) {
    this.lines = head.source.split("\n").map((text, i) => {
      const line = document.createElement("div");
      line.className = "line";
      line.dataset.number = `${i + 1}`;
      line.textContent = text === "" ? "\u200b" : text;
      const span: Span = { first: [i + 1, 1], last: [i + 2, 1] };
      line.onpointerenter = () => pointed(span);
      line.onpointerleave = () => pointed(null);
      line.onclick = () => chosen(span);
      return line;
    });
    place.append(...this.lines);
  }

  /** Marks that stay until others take their place. */
  pin(spans: Span[]): void {
    this.pinned = spans;
    this.mark(spans);
  }

  mark(spans: Span[]): void {
    this.lines.forEach((line, i) => {
      line.classList.toggle(
        "marked",
        [...spans, ...this.pinned].some((span) => i + 1 >= span.first[0] && i + 1 <= span.last[0]),
      );
    });
    if (spans.length > 0) this.lines[spans[0].first[0] - 1]?.scrollIntoView({ block: "nearest" });
  }
}
