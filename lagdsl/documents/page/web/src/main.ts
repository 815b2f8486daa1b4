// The living page: reads what it was told, shows it, and integrates anew when a slider moves.
import { Curves } from "./curves.ts";
import { buttons, choice, make, menu, place } from "./dom.ts";
import { film, framed, save, table } from "./files.ts";
import { grab } from "./grab.ts";
import { inflated, loadFont, readHead, why, type Occurrence, type Head, type Shape, type Span } from "./head.ts";
import { Influence } from "./influence.ts";
import { keys } from "./keys.ts";
import { Live, type Outcome } from "./live.ts";
import { lines, Marks, overlap, terms } from "./marks.ts";
import { geometryOf } from "./meshes.ts";
import { recorded, together, type Motion } from "./motion.ts";
import { SWITCHES } from "./overlay.ts";
import { Player } from "./player.ts";
import { runs } from "./runs.ts";
import { shown, Sliders } from "./sliders.ts";
import { Stage } from "./stage.ts";
import { tabs } from "./tabs.ts";
import { INTERRUPTED, type Pull } from "./orders.ts";

const ROWS = 601;
const GHOSTS = 5;
const LONGEST_WAIT = 500; // [ms] for the first picture
const KEYS =
  "Keys: space play and pause, arrows step, Home and End, + and - speed, g ghosts, v velocities, f the whole machine, k keep this motion, p present";
const COMPARED = ["one motion", "kept one behind", "kept one beside"];

class Page {
  private motion: Motion;
  private readonly numbers: Float64Array;
  private readonly player: Player;
  private readonly sliders: Sliders;
  private readonly influence: Influence;
  private readonly curves: Curves;
  private readonly source: Marks; // lines of the model
  private readonly terms: Marks; // of the equations
  private readonly cells: HTMLElement[];
  private live: Live | null = null;
  private ghosts = false;
  private kept: Motion | null = null; // to compare with
  private arrows: Promise<Live | null> | null = null; // the motion behind arrows, once one asked for it
  private endFilm: (() => void) | null = null;
  private readonly comparing = choice("Keep this motion (key k), and see it with the next ones", COMPARED, 0, (way) => this.compare(way));
  private readonly switched = new Map<string, HTMLButtonElement>(); // by the words of buttons

  constructor(
    private readonly head: Head,
    private readonly motions: Motion[],
    private readonly stage: Stage,
  ) {
    const [motion] = motions;
    this.motion = motion;
    this.numbers = new Float64Array(motion.width);
    this.player = new Player(head, place("player"), (time) => this.pose(time));
    this.sliders = new Sliders(head, together(motions), place("sliders"), () => this.again());
    this.influence = new Influence(head, place("sliders"));
    this.curves = new Curves(head, motion, place("curves"), (time) => this.player.go(time));
    this.source = new Marks(lines(head, place("source")), (line) => this.mark(line?.spans ?? []), (line) => this.toTerms(line));
    this.terms = new Marks(terms(head, place("derivation")), (term) => this.mark(term?.spans ?? [], { term: term?.element }), (spans) => this.toSource(spans));
    this.cells = this.values();
    const units = place("units") as HTMLInputElement;
    units.onchange = () => place("derivation").classList.toggle("units", units.checked);
    tabs(() => {
      this.tell();
      this.source.pin([]);
      this.terms.pin([]);
    });
    this.tools();
    this.keys();
    this.pointer();
    grab(head, stage, place("stage"), {
      ready: () => this.live !== null,
      begin: () => this.startHere(),
      pull: (pull) => this.again(pull),
    });
    if (location.hash === "#present") this.present(true);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.stage.theme());
    this.say(head.said);
    this.pose(head.start);
    this.tell();
    window.addEventListener("beforeprint", () => this.tell());
    if (head.modes !== undefined) place("sliders-tab").textContent = "Modes";
    runs(head, place("sliders"), (run) => this.choose(run));
    if (motions.length > 1 && head.modes === undefined) this.curves.behind(motions);
  }

  async begin(): Promise<void> {
    this.live = await Live.begin(this.head, ROWS, (outcome) => this.arrived(outcome));
    for (const part of place("sliders").querySelectorAll<HTMLElement>(":scope > :not(#runs)")) {
      part.toggleAttribute("inert", this.live === null);
      part.hidden = this.head.live === false;
    }
    if (this.live !== null) this.influence.rest(this.sliders.parameters, this.sliders.inputs);
    else if (this.head.live !== false) this.say("This browser shows the recorded motion only: sliders need WebAssembly.");
    document.documentElement.dataset.ready = this.live === null ? "recorded" : "live";
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.player.play();
  }

  /** Another of the recorded motions; with its parameters the sliders go on from there. */
  private choose(number: number): void {
    const run = this.head.runs?.[number];
    if (run === undefined) return;
    this.player.over(run.start, run.stop, run.pace);
    this.show(this.motions[number], run.events, run.parameters);
    this.say(run.said === "" ? run.label : `${run.label}: ${run.said}`);
    if (run.parameters !== null && run.said === "") this.again();
  }

  private show(motion: Motion, events: Occurrence[], parameters: ArrayLike<number> | null): void {
    this.motion = motion;
    this.player.mark(events);
    this.curves.show(motion, events);
    if (parameters !== null) this.sliders.take(parameters);
    this.stage.follow(motion);
    this.haunt();
  }

  /** Pale postures, where somebody wants them. */
  private haunt(): void {
    const { last } = this.motion;
    const first = this.motion.count > 0 ? this.motion.at(0, 0) : 0;
    const times = Array.from({ length: GHOSTS }, (_, k) => first + ((last - first) * k) / (GHOSTS - 1));
    this.stage.postures(this.motion, this.ghosts ? times : []);
    this.pose(this.player.time);
  }

  private pose(time: number): void {
    const until = Math.min(time, this.motion.last);
    this.motion.state(until, this.numbers);
    this.stage.pose(this.motion, this.numbers, until);
    this.legend();
    this.curves.point(until);
    if (!place("table-panel").hidden) this.tell();
  }

  /** The present values, where somebody can read them. */
  private tell(): void {
    this.cells.forEach((cell, i) => (cell.textContent = shown(this.head.columns[i], this.numbers[i])));
  }

  private again(pull: Pull | null = null): void {
    this.influence.rest(this.sliders.parameters, this.sliders.inputs);
    this.live?.run(this.sliders.parameters, this.sliders.inputs, pull);
    void this.arrows?.then((live) => live?.run(this.sliders.parameters, this.sliders.inputs));
  }

  /** The start of the motion gets the present posture. */
  private startHere(): void {
    this.player.pause();
    this.head.columns.forEach(({ name, kind }, i) => {
      if (kind === "coordinate") this.sliders.put(`${name}.start`, this.numbers[i]);
    });
    this.player.go(-Infinity);
  }

  /** Keeps the present motion and shows another one with it. */
  private compare(way: number): void {
    this.kept = way === 0 ? null : (this.kept ?? this.motion);
    this.stage.compare(this.kept, way === 2);
    this.curves.behind(this.kept === null ? (this.head.modes === undefined ? this.motions.slice(1) : []) : [this.kept]);
    this.pose(this.player.time);
  }

  /** The picture alone, in large type. */
  private present(on: boolean): void {
    document.documentElement.toggleAttribute("data-present", on);
    if (on && location.hash !== "#present") void document.documentElement.requestFullscreen?.().catch(() => undefined);
    else if (document.fullscreenElement !== null) void document.exitFullscreen();
  }

  /** Switches a kind of arrows; the first time, the motion is integrated anew, that of the machine with it. */
  private async point(kind: string, on: boolean): Promise<void> {
    const overlay = this.stage.overlay;
    if (overlay === null) return;
    if (on) overlay.shown.add(kind);
    else overlay.shown.delete(kind);
    if (on && this.arrows === null) {
      const told = ({ motion }: Outcome): void => {
        overlay.take(motion);
        document.documentElement.dataset.arrows = `${motion.count}`;
        this.pose(this.player.time);
      };
      this.arrows = Live.begin(this.head, ROWS, told, { tape: "vectors" });
      if ((await this.arrows) === null) this.say("Arrows need WebAssembly.");
      this.again();
    }
    this.pose(this.player.time);
  }

  /** Marks things, lines and terms that statements stand behind, or the thing or the term alone that is pointed at. */
  private mark(spans: Span[], { shape, term, value = "" }: { shape?: Shape | undefined; term?: Element | undefined; value?: string } = {}): void {
    const all = this.head.scene.shapes.filter(({ span }) => span !== null && overlap([span], spans));
    const shapes = shape === undefined ? all : [shape];
    this.stage.highlight(shapes);
    this.source.mark(spans);
    this.source.first(spans)?.scrollIntoView({ block: "nearest" });
    this.terms.mark(term === undefined ? spans : []);
    term?.classList.add("marked");
    place("pointed").textContent = `${shapes.map(({ name }) => name).join(", ")}${value && `: ${value}`}`;
  }

  private toSource(spans: Span[]): void {
    place("source-tab").click();
    this.source.pin(spans);
    this.source.first(spans)?.scrollIntoView({ block: "nearest" });
  }

  private toTerms(line: Span[]): void {
    const term = this.terms.first(line);
    if (term === null) {
      this.say("No term of the equations comes from this line.");
      return;
    }
    place("derivation-tab").click();
    this.terms.pin(line);
    term.scrollIntoView({ block: "center" });
  }

  private fit(): void {
    this.stage.lookAt();
    this.pose(this.player.time);
  }

  private legend(): void {
    const words = (this.stage.overlay?.legend() ?? []).join("\n");
    const legend = place("legend");
    if (legend.textContent !== words) legend.textContent = words; // at each picture of a motion
  }

  private arrived({ motion, status, time, took, parameters, events, blamed }: Outcome): void {
    const failed = motion.count === 0;
    document.documentElement.toggleAttribute("data-failed", failed);
    const named = events.map(([at, what, which]) => {
      const { kind, names } = this.head.event_names[what];
      return { time: at, kind, name: names[which] ?? "" };
    });
    if (failed) this.player.pause();
    else this.show(motion, named, parameters);
    document.documentElement.dataset.took = took.toFixed(2);
    if (status === 0) this.say(`Integrated anew in ${took.toFixed(1)} ms.`);
    else if (status === INTERRUPTED) this.say(`This motion takes long; it is shown up to ${time.toPrecision(4)} s.`);
    else this.say(`${failed ? "This start cannot be. " : ""}${why(this.head, status, blamed)} (t = ${time.toPrecision(5)} s)`);
  }

  private say(words: string): void {
    place("said").textContent = words;
  }

  /** A table of values for those who cannot see the picture; it tells the present moment. */
  private values(): HTMLElement[] {
    const body = place("values");
    return this.head.columns.slice(0, this.head.scene.first).map((column) => {
      const value = make("td");
      const name = make("th", { scope: "row", textContent: column.name });
      body.append(make("tr", {}, name, value, make("td", { textContent: column.display.unit })));
      return value;
    });
  }

  private tools(): void {
    const { scene: { shapes } } = this.head;
    const { shown } = this.stage;
    const drawn = (...kinds: string[]): boolean => shapes.some(({ kind }) => kinds.includes(kind));
    const button = buttons(place("tools"));
    /** A button that is pressed as long as what it switches is on. */
    const toggle = (words: string, title: string, on: boolean, act: (on: boolean) => void): void => {
      const made = button(words, title, () => {
        made.ariaPressed = `${made.ariaPressed !== "true"}`;
        act(made.ariaPressed === "true");
        this.pose(this.player.time);
      });
      made.ariaPressed = `${on}`;
      this.switched.set(words, made);
    };
    const layer = (name: "forces" | "frames", title: string): void =>
      toggle(name, title, shown[name], (on) => {
        shown[name] = on;
        this.stage.show();
      });
    if (drawn("force", "torque")) layer("forces", "Arrows of loads");
    const { overlay } = this.stage;
    if (overlay !== null) {
      const one = ["", ...overlay.coordinates];
      const chooser = choice("The coordinate that moves", ["all coordinates", ...overlay.coordinates], 0, (number) => {
        overlay.coordinate = one[number];
        this.pose(this.player.time);
      });
      chooser.hidden = true;
      for (const [kind, words, title] of SWITCHES.filter(([kind]) => overlay.has(kind))) {
        toggle(words, title, false, (on) => {
          void this.point(kind, on);
          if (kind === "admissible") chooser.hidden = !on;
        });
      }
      place("tools").append(chooser);
    }
    if (drawn("frame")) layer("frames", "Axes of frames");
    toggle("ghosts", "Pale postures of several instants (key g)", false, (on) => {
      this.ghosts = on;
      this.haunt();
    });
    button("fit", "The whole machine (key f)", () => this.fit());
    button("present", "The picture alone, in large type (key p)", () => this.present(true));
    button("keys", KEYS, () => this.say(KEYS));
    this.comparing.title = this.comparing.ariaLabel ?? "";
    place("tools").append(this.comparing);
    this.saving();
  }

  private saving(): void {
    const { stage, head: { name } } = this;
    const button = buttons(menu(place("tools"), "save"));
    button("PNG", "The picture", () => stage.canvas.toBlob((blob) => blob !== null && save(blob, `${name}.png`), "image/png"));
    button("SVG", "The picture as lines and faces", () => save(new Blob([stage.sketch()], { type: "image/svg+xml" }), `${name}.svg`));
    button("GIF", "The motion as a film that plays everywhere", () => void this.filmed());
    button("CSV", "The values", () => save(table(this.motion, this.head), `${name}.csv`));
    if (typeof MediaRecorder === "undefined") return;
    const recording = button("film", "Record what plays", () => {
      if (this.endFilm !== null) this.endFilm();
      else this.player.play();
      this.endFilm = this.endFilm === null ? film(stage.canvas, (blob) => save(blob, `${name}.webm`)) : null;
      recording.ariaPressed = `${this.endFilm !== null}`;
    });
  }

  /** The whole motion, frame by frame. */
  private async filmed(): Promise<void> {
    this.player.pause();
    this.stage.screen.filming(true);
    const first = this.motion.at(0, 0);
    const length = this.motion.last - first;
    const made = await framed(this.stage.canvas, Math.min(Math.max(length, 3), 10), (part) => {
      this.pose(first + length * part);
      this.say(`Film: ${Math.round(100 * part)} %`);
    });
    save(made, `${this.head.name}.gif`);
    this.say("The film is saved.");
    this.stage.screen.filming(false);
    this.pose(this.player.time);
  }

  private keys(): void {
    keys({
      " ": () => this.player.toggle(),
      ArrowRight: () => this.player.step(0.01),
      ArrowLeft: () => this.player.step(-0.01),
      "+": () => this.player.faster(1),
      "-": () => this.player.faster(-1),
      g: () => this.switched.get("ghosts")?.click(),
      v: () => this.switched.get("v")?.click(),
      f: () => this.fit(),
      k: () => this.keep(),
      p: () => this.present(!document.documentElement.hasAttribute("data-present")),
      Escape: () => this.present(false),
      Home: () => this.player.go(-Infinity),
      End: () => this.player.go(Infinity),
    });
    document.addEventListener("fullscreenchange", () => {
      if (document.fullscreenElement === null && location.hash !== "#present") this.present(false);
    });
  }

  private keep(): void {
    this.kept = this.motion;
    this.comparing.selectedIndex = Math.max(this.comparing.selectedIndex, 1);
    this.compare(this.comparing.selectedIndex);
  }

  private pointer(): void {
    let over: Shape | null = null;
    this.stage.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0) return;
      const found = this.stage.shapeAt(event.clientX, event.clientY);
      if (found === over) return;
      over = found;
      this.mark(found?.span ? [found.span] : [], found === null ? {} : { shape: found, value: this.stage.value(found, this.numbers) });
    });
  }
}

/** The first picture comes before curves and sliders; where nobody looks at the page no picture comes. */
function shownOnce(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => setTimeout(resolve));
    setTimeout(resolve, LONGEST_WAIT);
  });
}

async function main(): Promise<void> {
  const head = readHead();
  const meshes = await Promise.all(head.meshes.map(geometryOf));
  const motions = recorded(head, await inflated("motion"));
  const forms = Object.entries(head.stage.forms).map(async ([name, mesh]) => [name, await geometryOf(mesh)] as const);
  const stage = new Stage(head, together(motions), meshes, new Map(await Promise.all(forms)), place("stage"));
  const [first] = motions;
  stage.pose(first, first.state(head.start, new Float64Array(first.width)), head.start);
  await shownOnce();
  void loadFont();
  await new Page(head, motions, stage).begin();
}

main().catch((error: unknown) => {
  place("said").textContent = `The page cannot be shown: ${String(error)}`;
});
