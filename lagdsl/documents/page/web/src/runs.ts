// Several motions: a slider over the runs of a sweep; modes by frequency, with amplitudes; eigenvalues over a parameter.
import { make } from "./dom.ts";
import type { Head, Mode } from "./head.ts";
import { locus } from "./locus.ts";

export class Runs {
  private level = 0;
  private mode = 0;
  private readonly buttons: HTMLButtonElement[] = [];

  constructor(
    private readonly head: Head,
    place: HTMLElement,
    private readonly chosen: (run: number) => void,
  ) {
    const board = make("section", { id: "runs" });
    if (head.modes !== undefined) this.modes(board, head.modes);
    else if (head.runs !== undefined && head.runs.length > 1) this.sweep(board, head.runs.map((run) => run.label));
    place.prepend(board);
  }

  private sweep(board: HTMLElement, labels: string[]): void {
    const bar = make("input", { type: "range", min: "0", max: `${labels.length - 1}`, step: "1", value: "0", ariaLabel: "Run" });
    const words = make("output");
    const tell = (): void => {
      const run = Number(bar.value);
      words.textContent = `Run ${run + 1} of ${labels.length}: ${labels[run]}`;
      bar.ariaValueText = words.textContent;
    };
    bar.oninput = () => {
      tell();
      this.chosen(Number(bar.value));
    };
    tell();
    board.append(make("label", {}, words, bar));
  }

  private modes(board: HTMLElement, modes: Mode[]): void {
    const levels = this.head.levels ?? [""];
    this.level = Math.min(1, levels.length - 1);
    const words = make("p", { textContent: this.head.stability ?? "" });
    const list = make("div", { className: "modes" });
    modes.forEach((mode, i) => {
      const button = make("button", { textContent: `${i + 1}: ${title(mode)}` });
      button.onclick = () => {
        this.mode = i;
        this.show(modes, shape);
      };
      this.buttons.push(button);
      list.append(button);
    });
    const size = make("select", { ariaLabel: "Amplitude" });
    levels.forEach((name, i) => size.append(new Option(`amplitude: ${name}`, `${i}`, i === this.level, i === this.level)));
    size.onchange = () => {
      this.level = Number(size.value);
      this.show(modes, shape);
    };
    const shape = make("table", { className: "shape" });
    board.append(words, list, size, shape);
    if (this.head.locus != null) board.append(locus(this.head.locus));
    this.show(modes, shape);
  }

  /** The number of the run that is shown. */
  get run(): number {
    return this.mode * (this.head.levels?.length ?? 1) + this.level;
  }

  private show(modes: Mode[], shape: HTMLTableElement): void {
    this.buttons.forEach((button, i) => (button.ariaPressed = `${i === this.mode}`));
    const head = make("tr", {}, ...["shape", "size", "phase"].map((textContent) => make("th", { scope: "col", textContent })));
    const rows = modes[this.mode].shape.map(({ name, size, phase }) => {
      const texts = [name, size.toPrecision(3), size > 1e-9 ? `${phase.toFixed(0)}°` : ""];
      return make("tr", {}, ...texts.map((textContent) => make("td", { textContent })));
    });
    shape.replaceChildren(head, ...rows);
    this.chosen(this.run);
  }
}

function title(mode: Mode): string {
  const [real] = mode.eigenvalue;
  const parts = mode.frequency > 0 ? [`${mode.frequency.toPrecision(4)} Hz`] : [`${real.toPrecision(4)} 1/s`];
  if (mode.frequency > 0 && mode.damping !== null && Math.abs(mode.damping) > 1e-7) {
    parts.push(`damping ${mode.damping.toPrecision(3)}`);
  }
  if (mode.constant !== null) parts.push(`${mode.constant > 0 ? "falls" : "grows"} in ${Math.abs(mode.constant).toPrecision(3)} s`);
  return parts.join(", ");
}
