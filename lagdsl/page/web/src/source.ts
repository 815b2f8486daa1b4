// The text of the model; what a shape comes from is marked in it.
import type { Head, Span } from "./head.ts";

export class Source {
  private readonly lines: HTMLElement[];

  constructor(head: Head, place: HTMLElement) {
    this.lines = head.source.split("\n").map((text, i) => {
      const line = document.createElement("div");
      line.className = "line";
      line.dataset.number = `${i + 1}`;
      line.textContent = text === "" ? "\u200b" : text;
      return line;
    });
    place.append(...this.lines);
  }

  mark(spans: Span[]): void {
    this.lines.forEach((line, i) => {
      line.classList.toggle(
        "marked",
        spans.some((span) => i + 1 >= span.first[0] && i + 1 <= span.last[0]),
      );
    });
    if (spans.length > 0) this.lines[spans[0].first[0] - 1]?.scrollIntoView({ block: "nearest" });
  }
}
