// Changes of the end of a curve with each slider, the strongest first: derivatives of the motion, once it rests.
import { why, type Column, type Head, type Quantity } from "./head.ts";
import { Live, type Outcome } from "./live.ts";
import { written } from "./numbers.ts";
import { INTERRUPTED, STOPPED } from "./orders.ts";

const REST = 300; // [ms] without a move of a slider
const MOST = 12; // rows
const NOTHING = 1e-9; // of the largest change: round-off
const KINDS: Column["kind"][] = ["coordinate", "rate", "state", "output"];
const LATE = "The motion takes long: nothing is told of its end.";
const EARLY = "The motion ends before its time: its end moves, too.";

interface Change {
  name: string;
  words: string; // of the slider
  ranked: boolean; // false: nobody knows which change of it is a small one
  change: number; // of the end, in the unit that is shown
}

/** A change of a slider, in SI units, and in words: a hundredth of its value; a unit of a start angle, and of what is zero. */
export function amount(quantity: Quantity, value: number): { si: number; words: string; ranked: boolean } {
  const { angle, group, display } = quantity;
  const turned = angle && group === "start";
  if (value !== 0 && !turned) return { si: 0.01 * Math.abs(value), words: "1 %", ranked: true };
  return { si: 1 / display.scale, words: `1 ${display.unit}`.trim(), ranked: turned };
}

export class Influence {
  private readonly by: number[] = []; // places among parameters and, behind them, inputs
  private readonly quantities: Quantity[];
  private readonly board = document.createElement("details");
  private readonly chooser = document.createElement("select");
  private readonly told = document.createElement("p");
  private readonly rows = document.createElement("tbody");
  private live: Promise<Live | null> | null = null;
  private values: number[] = [];
  private wish: { parameters: Float64Array; inputs: Float64Array } | null = null;
  private timer = 0;
  private outcome: Outcome | null = null;

  constructor(
    private readonly head: Head,
    place: HTMLElement,
  ) {
    this.quantities = [...head.parameters, ...head.inputs].filter((quantity, i) => {
      const counts = quantity.kind === "Real";
      if (counts) this.by.push(i);
      return counts;
    });
    if (this.by.length === 0 || head.live === false || head.modes !== undefined) return;
    const summary = document.createElement("summary");
    summary.textContent = "What moves the end most";
    this.chooser.ariaLabel = "The curve whose end moves";
    head.columns.slice(0, head.scene.first).forEach((column, i) => {
      if (KINDS.includes(column.kind)) this.chooser.append(new Option(column.name, `${i}`));
    });
    this.chooser.onchange = () => this.show();
    const table = document.createElement("table");
    table.className = "influence";
    table.append(this.rows);
    this.board.className = "influences";
    this.board.open = true;
    this.board.ontoggle = () => this.ask();
    const line = document.createElement("div");
    line.append(this.chooser, this.told);
    this.board.append(summary, line, table);
    place.append(this.board);
    if (!head.differentiable) this.say("Delayed values have no derivatives yet.", true);
  }

  /** The sliders stand here; what was told before is of another motion. */
  rest(parameters: Float64Array, inputs: Float64Array): void {
    if (!this.board.isConnected || !this.head.differentiable) return;
    this.wish = { parameters, inputs };
    this.board.ariaBusy = "true";
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.ask(), REST);
  }

  private ask(): void {
    if (this.wish === null || !this.board.open) return;
    const { parameters, inputs } = this.wish;
    this.wish = null;
    const all = [...parameters, ...inputs];
    this.values = this.by.map((i) => all[i]);
    this.live ??= Live.begin(this.head, 2, (outcome) => this.arrived(outcome), { by: this.by });
    void this.live.then((live) => live?.run(parameters, inputs));
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
      this.say(`${status === INTERRUPTED ? LATE : early} (t = ${time.toPrecision(5)} s)`, true);
      return;
    }
    const index = Number(this.chooser.value);
    const column = this.head.columns[index];
    const { scale, shift, unit } = column.display;
    const end = written(motion.at(motion.count - 1, index) * scale + shift, 4);
    const value = `is ${`${end} ${unit}`.trim()} at ${written(time, 4)} s`;
    this.say(`${value} and changes with`);
    const changes = this.quantities.map((quantity, k): Change => {
      const { si, words, ranked } = amount(quantity, this.values[k]);
      return { name: quantity.name, words, ranked, change: derivatives[k * motion.width + index] * si * scale };
    });
    const size = ({ change }: Change): number => Math.abs(change);
    const least = NOTHING * Math.max(...changes.map(size));
    const moving = changes.filter((each) => size(each) > least).sort((a, b) => size(b) - size(a));
    const ranked = moving.filter((each) => each.ranked);
    if (moving.length === 0) this.say(`${value}; no slider moves it.`);
    for (const each of [...ranked, ...moving.filter((other) => !other.ranked)].slice(0, MOST)) {
      this.row(each, each.ranked ? size(each) / size(ranked[0]) : 0, unit);
    }
  }

  /** `part`: the length of the bar, of the longest one; 0: none. */
  private row({ name, words, change }: Change, part: number, unit: string): void {
    const row = document.createElement("tr");
    const head = document.createElement("th");
    head.scope = "row";
    head.textContent = name.replace(/\.start$/, " at the start");
    const by = document.createElement("td");
    by.textContent = words;
    const bar = document.createElement("td");
    bar.className = "bar";
    const length = document.createElement("i");
    length.style.width = `${100 * part}%`;
    length.className = change < 0 ? "less" : "more";
    if (part > 0) bar.append(length);
    const value = document.createElement("td");
    value.textContent = `${change > 0 ? "+" : "−"}${written(Math.abs(change), 3)} ${unit}`.trim();
    row.append(head, by, bar, value);
    this.rows.append(row);
  }
}
