// Several motions: a slider over the runs of a sweep; modes by frequency, with amplitudes; eigenvalues over a parameter.
import { choice, make } from "./dom.ts";
import type { Head, Mode } from "./head.ts";
import { locus } from "./locus.ts";

/** The controls of the page's runs, if it has several; `chosen` is told the number of the one to show. */
export function runs(head: Head, place: HTMLElement, chosen: (run: number) => void): void {
  const board = make("section", { id: "runs" });
  place.prepend(board);
  if (head.modes !== undefined) modes(head, board, head.modes, chosen);
  else if (head.runs !== undefined && head.runs.length > 1) sweep(board, head.runs.map((run) => run.label), chosen);
}

function sweep(board: HTMLElement, labels: string[], chosen: (run: number) => void): void {
  const bar = make("input", { type: "range", min: "0", max: `${labels.length - 1}`, step: "1", value: "0", ariaLabel: "Run" });
  const words = make("output");
  const tell = (): void => {
    const run = Number(bar.value);
    words.textContent = bar.ariaValueText = `Run ${run + 1} of ${labels.length}: ${labels[run]}`;
  };
  bar.oninput = () => {
    tell();
    chosen(Number(bar.value));
  };
  tell();
  board.append(make("label", {}, words, bar));
}

function modes(head: Head, board: HTMLElement, all: Mode[], chosen: (run: number) => void): void {
  const levels = head.levels ?? [""];
  const shown = { mode: 0, level: Math.min(1, levels.length - 1) };
  const shape = make("table", { className: "shape" });
  const title = make("tr", {}, ...["shape", "size", "phase"].map((textContent) => make("th", { scope: "col", textContent })));
  const show = (change: Partial<typeof shown>): void => {
    const { mode, level } = Object.assign(shown, change);
    buttons.forEach((button, i) => (button.ariaPressed = `${i === mode}`));
    const rows = all[mode].shape.map(({ name, size, phase }) => {
      const texts = [name, size.toPrecision(3), size > 1e-9 ? `${phase.toFixed(0)}°` : ""];
      return make("tr", {}, ...texts.map((textContent) => make("td", { textContent })));
    });
    shape.replaceChildren(title, ...rows);
    chosen(mode * levels.length + level);
  };
  const buttons = all.map((each, i) => make("button", { textContent: `${i + 1}: ${told(each)}`, onclick: () => show({ mode: i }) }));
  const size = choice("Amplitude", levels.map((name) => `amplitude: ${name}`), shown.level, (number) => show({ level: number }));
  board.append(make("p", { textContent: head.stability ?? "" }), make("div", { className: "modes" }, ...buttons), size, shape);
  if (head.locus != null) board.append(locus(head.locus));
  show({});
}

function told(mode: Mode): string {
  const { eigenvalue: [real], frequency, damping, constant } = mode;
  const parts = [frequency > 0 ? `${frequency.toPrecision(4)} Hz` : `${real.toPrecision(4)} 1/s`];
  if (frequency > 0 && damping !== null && Math.abs(damping) > 1e-7) parts.push(`damping ${damping.toPrecision(3)}`);
  if (constant !== null) parts.push(`${constant > 0 ? "falls" : "grows"} in ${Math.abs(constant).toPrecision(3)} s`);
  return parts.join(", ");
}
