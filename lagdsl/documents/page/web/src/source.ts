// The text of the model; what a shape comes from is marked in it.
import { make } from "./dom.ts";
import type { Head, Span } from "./head.ts";

/** Pieces of one kind, with its letter as their class. */
function painted(text: string, inks: string): (HTMLElement | string)[] {
  if (text === "") return ["\u200b"];
  return [...inks.slice(0, text.length).matchAll(/(.)\1*/gs)].map(({ index, 0: run, 1: ink }) =>
    make("span", { className: `ink-${ink}`, textContent: text.slice(index, index + run.length) }));
}

/** `pointed` is told the line under the pointer, as a span, and `chosen` one that was clicked. */
export class Source {
  private readonly lines: HTMLElement[];
  private pinned: Span[] = [];

  constructor(head: Head, place: HTMLElement, pointed: (line: Span | null) => void, chosen: (line: Span) => void) {
    let at = 0;
    this.lines = head.source.split("\n").map((text, i) => {
      const line = make("div", { className: "line" }, ...painted(text, head.inks.slice(at, (at += text.length + 1))));
      line.dataset.number = `${i + 1}`;
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
    const marked = [...spans, ...this.pinned];
    this.lines.forEach((line, i) => line.classList.toggle("marked", marked.some(({ first, last }) => i + 1 >= first[0] && i + 1 <= last[0])));
    if (spans.length > 0) this.lines[spans[0].first[0] - 1]?.scrollIntoView({ block: "nearest" });
  }
}
