// The living page: reads what it was told, shows it, and integrates anew when a slider moves.
import { Curves } from "./curves.ts";
import { film, picture, table } from "./files.ts";
import { inflated, readHead, type Head, type Shape } from "./head.ts";
import { Live, type Outcome } from "./live.ts";
import { recorded, type Motion } from "./motion.ts";
import { Player } from "./player.ts";
import { shown, Sliders } from "./sliders.ts";
import { Source } from "./source.ts";
import { Stage } from "./stage.ts";
import { INTERRUPTED } from "./orders.ts";

const ROWS = 601;

function place(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no #${id}`);
  return found;
}

class Page {
  private motion: Motion;
  private readonly numbers: Float64Array;
  private readonly stage: Stage;
  private readonly player: Player;
  private readonly sliders: Sliders;
  private readonly curves: Curves;
  private readonly source: Source;
  private readonly cells: HTMLElement[];
  private live: Live | null = null;
  private endFilm: (() => void) | null = null;

  constructor(
    private readonly head: Head,
    motion: Motion,
  ) {
    this.motion = motion;
    this.numbers = new Float64Array(motion.width);
    this.stage = new Stage(head, motion, place("stage"));
    this.player = new Player(head, place("player"), (time) => this.pose(time));
    this.sliders = new Sliders(head, place("sliders"), () => this.again());
    this.curves = new Curves(head, motion, place("curves"), (time) => this.player.go(time));
    this.source = new Source(head, place("source"));
    this.cells = this.values();
    this.tabs();
    this.tools();
    this.keys();
    this.pointer();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.stage.theme());
    this.say(head.said);
    this.pose(head.start);
  }

  async begin(): Promise<void> {
    this.live = await Live.begin(this.head, ROWS, (outcome) => this.arrived(outcome));
    place("sliders").toggleAttribute("inert", this.live === null);
    if (this.live === null) this.say("This browser shows the recorded motion only: sliders need WebAssembly.");
    document.documentElement.dataset.ready = this.live === null ? "recorded" : "live";
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.player.play();
  }

  private pose(time: number): void {
    const until = Math.min(time, this.motion.last);
    this.motion.state(until, this.numbers);
    this.stage.pose(this.motion, this.numbers, until);
    this.curves.point(until);
    if (!place("table-panel").hidden) this.tell();
  }

  /** The present values, where somebody can read them. */
  private tell(): void {
    this.cells.forEach((cell, i) => (cell.textContent = shown(this.head.columns[i], this.numbers[i])));
  }

  private again(): void {
    this.live?.run(this.sliders.parameters, this.sliders.inputs);
  }

  private arrived({ motion, status, time, took }: Outcome): void {
    if (motion.count > 0) {
      this.motion = motion;
      this.curves.show(motion);
      this.player.mark([]);
      this.pose(this.player.time);
    }
    document.documentElement.dataset.took = took.toFixed(2);
    if (status === 0) this.say(`Integrated anew in ${took.toFixed(1)} ms.`);
    else if (status === INTERRUPTED) this.say(`This motion takes long; it is shown up to ${time.toPrecision(4)} s.`);
    else this.say(`${this.head.words[status] ?? `The run ended with status ${status}.`} (t = ${time.toPrecision(5)} s)`);
  }

  private say(words: string): void {
    place("said").textContent = words;
  }

  /** A table of values for those who cannot see the picture; it tells the present moment. */
  private values(): HTMLElement[] {
    const body = place("values");
    return this.head.columns.slice(0, this.head.scene.first).map((column) => {
      const row = document.createElement("tr");
      const name = document.createElement("th");
      name.scope = "row";
      name.textContent = column.name;
      const value = document.createElement("td");
      const unit = document.createElement("td");
      unit.textContent = column.display.unit;
      row.append(name, value, unit);
      body.append(row);
      return value;
    });
  }

  private tabs(): void {
    const tabs = [...document.querySelectorAll<HTMLButtonElement>("[role=tab]")];
    const choose = (chosen: HTMLButtonElement): void => {
      for (const tab of tabs) {
        tab.ariaSelected = `${tab === chosen}`;
        tab.tabIndex = tab === chosen ? 0 : -1;
        place(tab.getAttribute("aria-controls") ?? "").hidden = tab !== chosen;
      }
    };
    tabs.forEach((tab, i) => {
      tab.onclick = () => {
        choose(tab);
        this.tell();
      };
      tab.onkeydown = (event) => {
        const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (step === 0) return;
        event.stopPropagation();
        const next = tabs[(i + step + tabs.length) % tabs.length];
        choose(next);
        this.tell();
        next.focus();
      };
    });
    choose(tabs[0]);
  }

  private tools(): void {
    const button = (words: string, title: string, act: (self: HTMLButtonElement) => void): void => {
      const made = document.createElement("button");
      made.textContent = words;
      made.title = title;
      made.onclick = () => act(made);
      place("tools").append(made);
    };
    const layer = (name: "forces" | "frames", title: string): void =>
      button(name, title, (self) => {
        this.stage.shown[name] = !this.stage.shown[name];
        self.ariaPressed = `${this.stage.shown[name]}`;
        this.stage.show();
        this.pose(this.player.time);
      });
    layer("forces", "Arrows of loads");
    layer("frames", "Axes of frames");
    button("view", "The whole machine", () => this.stage.lookAt());
    button("PNG", "Save the picture", () => picture(this.stage.canvas, this.head));
    button("CSV", "Save the values", () => table(this.motion, this.head));
    if (typeof MediaRecorder !== "undefined") {
      button("film", "Record what plays", (self) => {
        if (this.endFilm === null) {
          this.endFilm = film(this.stage.canvas, this.head);
          this.player.play();
        } else {
          this.endFilm();
          this.endFilm = null;
        }
        self.ariaPressed = `${this.endFilm !== null}`;
      });
    }
  }

  private keys(): void {
    document.addEventListener("keydown", (event) => {
      if (event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement) return;
      const acts: Record<string, () => void> = {
        " ": () => this.player.toggle(),
        ArrowRight: () => this.player.step(0.01),
        ArrowLeft: () => this.player.step(-0.01),
        Home: () => this.player.go(this.head.start),
        End: () => this.player.go(this.head.stop),
      };
      const act = acts[event.key];
      if (act === undefined || (event.key === " " && event.target instanceof HTMLButtonElement)) return;
      event.preventDefault();
      act();
    });
  }

  private pointer(): void {
    let over: Shape | null = null;
    this.stage.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0) return;
      const found = this.stage.shapeAt(event.clientX, event.clientY);
      if (found === over) return;
      over = found;
      this.stage.highlight(found);
      this.source.mark(found?.span ?? null);
      place("pointed").textContent = found?.name ?? "";
    });
  }
}

async function main(): Promise<void> {
  const head = readHead();
  const page = new Page(head, recorded(head, await inflated("motion")));
  await page.begin();
}

main().catch((error: unknown) => {
  place("said").textContent = `The page cannot be shown: ${String(error)}`;
});
