// Changes of the end of a curve with each slider, the strongest first: derivatives of the motion, once it rests.
import { choice, make } from "./dom.ts";
import { why, type Column, type Head, type Quantity } from "./head.ts";
import { Live, type Outcome } from "./live.ts";
import { written } from "./numbers.ts";
import { INTERRUPTED, STOPPED } from "./orders.ts";
import type { Sliders } from "./sliders.ts";

const REST = 300; // [ms] without a move of a slider
const LONGEST = 60_000; // [ms] of work beside the page, which a move of a slider ends
const MOST = 12; // rows
const NOTHING = 1e-9; // of the largest change: round-off
const KINDS: Column["kind"][] = ["coordinate", "rate", "state", "output"];
const LATE = "These derivatives take longer than a minute: the motion is too long for them.";
const EARLY = "The motion ends before its time: its end moves, too.";

/** A change of a slider, in SI units, and in words: a hundredth of its value; a unit of a start angle, and of what is zero.
 * It is not `ranked` where nobody knows which change of it is a small one. */
export function amount(quantity: Quantity, value: number): { si: number; words: string; ranked: boolean } {
  const { angle, group, display } = quantity;
  const turned = angle && group === "start";
  if (value !== 0 && !turned) return { si: 0.01 * Math.abs(value), words: "1 %", ranked: true };
  return { si: 1 / display.scale, words: `1 ${display.unit}`.trim(), ranked: turned };
}

export class Influence {
  private readonly by: number[] = []; // places among parameters and, behind them, inputs
  private readonly quantities: Quantity[];
  private readonly columns: number[]; // whose ends one may choose
  private readonly chooser: HTMLSelectElement;
  private readonly told = make("p");
  private readonly rows = make("tbody");
  private readonly board: HTMLDetailsElement;
  private live: Promise<Live | null> | null = null;
  private values: number[] = [];
  private wish: Sliders["given"] | null = null;
  private timer = 0;
  private outcome: Outcome | null = null;

  constructor(private readonly head: Head, place: HTMLElement) {
    this.quantities = [...head.parameters, ...head.inputs].filter(({ kind }, i) => kind === "Real" && this.by.push(i));
    this.columns = [...head.columns.keys()].slice(0, head.scene.first).filter((i) => KINDS.includes(head.columns[i].kind));
    this.chooser = choice("The curve whose end moves", this.columns.map((i) => head.columns[i].name), 0, () => this.show());
    this.board = make("details", { className: "influences", open: true, ontoggle: () => this.ask() },
      make("summary", { textContent: "What moves the end most" }), make("div", {}, this.chooser, this.told),
      make("table", { className: "influence" }, this.rows));
    if (this.by.length === 0 || head.live === false || head.modes !== undefined) return;
    place.append(this.board);
    if (!head.differentiable) this.say("Delayed values have no derivatives yet.", true);
  }

  /** The sliders stand here; what was told before is of another motion, and nobody waits for what is under way. */
  rest(given: Sliders["given"]): void {
    if (!this.board.isConnected || !this.head.differentiable) return;
    this.wish = given;
    this.board.ariaBusy = "true";
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.ask(), REST);
  }

  private ask(): void {
    if (this.wish === null || !this.board.open) return;
    const given = this.wish;
    this.wish = null;
    const all = given.flatMap((values) => [...values]);
    this.values = this.by.map((i) => all[i]);
    if (this.outcome === null) this.say("Derivatives are under way.", true);
    const begin = (): Promise<Live | null> => Live.begin(this.head, 2, (outcome) => this.arrived(outcome), { by: this.by, longest: LONGEST });
    this.live = (this.live ?? begin()).then((live) => (live?.busy ? (live.end(), begin()) : live));
    void this.live.then((live) => live?.run(given));
  }

  private arrived(outcome: Outcome): void {
    if (this.wish !== null) return; // of a motion that nobody sees any more
    this.board.ariaBusy = "false";
    this.outcome = outcome;
    this.show();
    document.documentElement.dataset.influence = outcome.took.toFixed(2);
  }

  /** Of the curve that is chosen, or, where there is nothing else, `alone`. */
  private say(words: string, alone = false): void {
    this.told.textContent = words;
    this.chooser.hidden = alone;
  }

  private show(): void {
    if (this.outcome === null) return;
    const { status, derivatives, motion, time, blamed } = this.outcome;
    this.rows.replaceChildren();
    if (derivatives.length === 0) {
      const early = status === 0 || status === STOPPED ? EARLY : why(this.head, status, blamed);
      this.say(status === INTERRUPTED ? LATE : `${early} (t = ${time.toPrecision(5)} s)`, true);
      return;
    }
    const index = this.columns[this.chooser.selectedIndex];
    const { scale, shift, unit } = this.head.columns[index].display;
    const end = written(motion.at(motion.count - 1, index) * scale + shift, 4);
    const value = `is ${`${end} ${unit}`.trim()} at ${written(time, 4)} s`;
    const changes = this.quantities.map((quantity, k) => {
      const { si, ...told } = amount(quantity, this.values[k]);
      const change = derivatives[k * motion.width + index] * si * scale;
      return { ...told, name: quantity.name, change, size: Math.abs(change) };
    });
    const least = NOTHING * Math.max(...changes.map(({ size }) => size));
    const moving = changes.filter(({ size }) => size > least).sort((a, b) => Number(b.ranked) - Number(a.ranked) || b.size - a.size);
    this.say(moving.length > 0 ? `${value} and changes with` : `${value}; no slider moves it.`);
    this.rows.append(...moving.slice(0, MOST).map(({ name, words, change, size, ranked }) => {
      const style = `width: ${(100 * size) / moving[0].size}%`; // of the longest one
      return make("tr", {},
        make("th", { scope: "row", textContent: name.replace(/\.start$/, " at the start") }),
        make("td", { textContent: words }),
        make("td", { className: "bar" }, ...(ranked ? [make("i", { className: change < 0 ? "less" : "more", style } as object)] : [])),
        make("td", { textContent: `${change > 0 ? "+" : "−"}${written(size, 3)} ${unit}`.trim() }));
    }));
  }
}
