// The living page: reads what it was told, shows it, and integrates anew when a slider moves.
import { Curves } from "./curves.ts";
import { button, choice, make, menu, place } from "./dom.ts";
import { framed, recorder, save, table } from "./files.ts";
import { grab } from "./grab.ts";
import { inflated, loadFont, readHead, why, type Occurrence, type Head, type Shape, type Span } from "./head.ts";
import { Influence } from "./influence.ts";
import { keys } from "./keys.ts";
import { Live, type Outcome } from "./live.ts";
import { lines, Marks, overlap, terms, type Item } from "./marks.ts";
import { geometryOf } from "./meshes.ts";
import { recorded, together, type Motion } from "./motion.ts";
import { SWITCHES } from "./overlay.ts";
import { Player } from "./player.ts";
import { runs } from "./runs.ts";
import { shown, Sliders } from "./sliders.ts";
import { Stage } from "./stage.ts";
import { INTERRUPTED, type Pull } from "./orders.ts";

const ROWS = 601;
const GHOSTS = 5;
const LONGEST_WAIT = 500; // [ms] for the first picture
const KEYS =
  "Keys: space play and pause, arrows step, Home and End, + and - speed, g ghosts, v velocities, f the whole machine, k keep this motion, p present";
const COMPARED = ["one motion", "kept one behind", "kept one beside"];

class Page {
  private motion: Motion;
  private numbers: Float64Array = new Float64Array(0); // of the present moment
  private readonly player: Player;
  private readonly sliders: Sliders;
  private readonly influence: Influence;
  private readonly curves: Curves;
  private readonly marks: Marks;
  private readonly cells: HTMLElement[]; // of a table for those who cannot see the picture, at the present moment
  private live: Live | null = null;
  private kept: Motion | null = null; // to compare with
  private arrows: Promise<Live | null> | null = null; // the motion behind arrows, once one asked for it
  private readonly comparing = choice("Keep this motion (key k), and see it with the next ones", COMPARED, 0, (way) => this.compare(way));

  constructor(
    private readonly head: Head,
    private readonly motions: Motion[],
    private readonly stage: Stage,
  ) {
    const [motion] = motions;
    this.motion = motion;
    this.player = new Player(head, place("player"), (time) => this.pose(time));
    this.sliders = new Sliders(head, together(motions), place("sliders"), () => this.again());
    this.influence = new Influence(head, place("sliders"));
    this.curves = new Curves(head, motion, place("curves"), (time) => this.player.go(time));
    const items = [...lines(head, place("source")), ...terms(head, place("derivation"))];
    this.marks = new Marks(items, (item) => this.mark(item?.spans ?? [], { item }), (item) => this.cross(item));
    this.cells = head.columns.slice(0, head.scene.first).map(() => make("td"));
    place("values").append(...this.cells.map((cell, i) => {
      const { name, display: { unit } } = head.columns[i];
      return make("tr", {}, make("th", { scope: "row", textContent: name }), cell, make("td", { textContent: unit }));
    }));
    for (const tab of document.getElementsByName("panel")) {
      tab.onchange = () => {
        this.tell();
        this.marks.pin([]);
      };
    }
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
    runs(head, place("sliders"), (run) => this.choose(run));
    if (motions.length > 1 && head.modes === undefined) this.curves.behind(motions);
  }

  async begin(): Promise<void> {
    this.live = await Live.begin(this.head, ROWS, (outcome) => this.arrived(outcome));
    for (const part of place("sliders").querySelectorAll<HTMLElement>(":scope > :not(#runs)")) {
      part.toggleAttribute("inert", this.live === null);
      part.hidden = this.head.live === false;
    }
    if (this.live !== null) this.influence.rest(this.sliders.given);
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
    if (parameters !== null) this.sliders.take((_, i) => parameters[i]);
    this.stage.follow(motion);
    this.accompany();
  }

  /** Draws the kept motion and postures at several times with the present one, where somebody wants them. */
  private accompany(): void {
    const { last } = this.motion;
    const first = this.motion.count > 0 ? this.motion.at(0, 0) : 0;
    const times = this.stage.on.has("ghosts") ? Array.from({ length: GHOSTS }, (_, k) => first + ((last - first) * k) / (GHOSTS - 1)) : [];
    const kept = this.kept === null ? [] : [{ motion: this.kept }];
    const beside = this.comparing.selectedIndex === 2;
    this.stage.accompany(beside ? kept : [], [...(beside ? [] : kept), ...times.map((t) => ({ motion: this.motion, t }))]);
    this.pose(this.player.time);
  }

  private pose(time: number): void {
    const until = Math.min(time, this.motion.last);
    this.numbers = this.stage.pose(this.motion, until);
    const legend = place("legend");
    const words = (this.stage.overlay?.legend() ?? []).join("\n");
    if (legend.textContent !== words) legend.textContent = words; // at each picture of a motion
    this.curves.point(until);
    if ((place("table-tab") as HTMLInputElement).checked) this.tell();
  }

  /** The present values, where somebody can read them. */
  private tell(): void {
    this.cells.forEach((cell, i) => (cell.textContent = shown(this.head.columns[i], this.numbers[i])));
  }

  private again(pull: Pull | null = null): void {
    const { given } = this.sliders;
    this.influence.rest(given);
    this.live?.run(given, pull);
    void this.arrows?.then((live) => live?.run(given));
  }

  /** The start of the motion gets the present posture. */
  private startHere(): void {
    this.player.pause();
    const places = new Map(this.head.columns.map(({ name, kind }, i) => [kind === "coordinate" ? `${name}.start` : "", i]));
    this.sliders.take(({ name }) => this.numbers[places.get(name) ?? NaN]);
    this.player.go(-Infinity);
  }

  /** Keeps the present motion and shows another one with it. */
  private compare(way: number): void {
    this.kept = way === 0 ? null : (this.kept ?? this.motion);
    this.curves.behind(this.kept === null ? (this.head.modes === undefined ? this.motions.slice(1) : []) : [this.kept]);
    this.accompany();
  }

  /** The picture alone, in large type. */
  private present(on: boolean): void {
    document.documentElement.toggleAttribute("data-present", on);
    if (on && location.hash !== "#present") void document.documentElement.requestFullscreen?.().catch(() => undefined);
    else if (document.fullscreenElement !== null) void document.exitFullscreen();
  }

  /** The first time that arrows are wanted the motion is integrated anew, that of the machine with it. */
  private async point(): Promise<void> {
    if (this.arrows !== null) return;
    const told = ({ motion }: Outcome): void => {
      this.stage.overlay?.take(motion);
      document.documentElement.dataset.arrows = `${motion.count}`;
      this.pose(this.player.time);
    };
    this.arrows = Live.begin(this.head, ROWS, told, { tape: "vectors" });
    if ((await this.arrows) === null) this.say("Arrows need WebAssembly.");
    this.again();
  }

  /** Marks things, lines and terms that statements stand behind, or the thing or the term alone that is pointed at. */
  private mark(spans: Span[], { shape, item = null, value = "" }: { shape?: Shape; item?: Item | null; value?: string } = {}): void {
    const all = this.head.scene.shapes.filter(({ span }) => span !== null && overlap([span], spans));
    const shapes = shape === undefined ? all : [shape];
    this.stage.highlight(shapes);
    this.marks.mark(spans, item?.term ? item.element : undefined);
    this.marks.first(spans, false)?.scrollIntoView({ block: "nearest" });
    place("pointed").textContent = `${shapes.map(({ name }) => name).join(", ")}${value && `: ${value}`}`;
  }

  /** From a term to its line, from a line to its first term. */
  private cross({ spans, term }: Item): void {
    const found = this.marks.first(spans, !term);
    if (found === null) return this.say(`No ${term ? "line of the text stands behind this term" : "term of the equations comes from this line"}.`);
    place(term ? "source-tab" : "derivation-tab").click();
    this.marks.pin(spans);
    found.scrollIntoView({ block: term ? "nearest" : "center" });
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

  private tools(): void {
    const { head: { name, scene }, stage } = this;
    const { overlay, on } = stage;
    const one = ["", ...(overlay?.coordinates ?? [])];
    const chooser = choice("The coordinate that moves", ["all coordinates", ...one.slice(1)], 0, (number) => {
      if (overlay !== null) overlay.coordinate = one[number];
      this.pose(this.player.time);
    });
    chooser.hidden = true;
    for (const { words, title, kinds, key } of SWITCHES) {
      const among = (shapes: Shape[] = []): boolean => shapes.some(({ kind }) => kinds.includes(kind));
      const arrows = among(overlay?.vectors.shapes);
      if (!arrows && !among(scene.shapes) && kinds.length > 0) continue;
      const made = button(words, title, () => {
        if (!on.delete(words)) on.add(words);
        made.ariaPressed = `${on.has(words)}`;
        if (kinds.includes("admissible")) chooser.hidden = !on.has(words);
        if (arrows) void this.point();
        stage.show();
        this.accompany();
      }, key);
      made.ariaPressed = `${on.has(words)}`;
      place("tools").append(made);
    }
    this.comparing.title = this.comparing.ariaLabel ?? "";
    const record = recorder(stage.canvas, (film) => save(film, `${name}.webm`));
    const recording = button("film", "Record what plays", () => {
      recording.ariaPressed = `${record()}`;
      if (recording.ariaPressed === "true") this.player.play();
    });
    recording.hidden = typeof MediaRecorder === "undefined";
    place("tools").append(
      chooser,
      button("fit", "The whole machine (key f)", () => {
        stage.lookAt();
        this.pose(this.player.time);
      }, "f"),
      button("present", "The picture alone, in large type (key p)", () => this.present(!document.documentElement.hasAttribute("data-present")), "p"),
      button("keys", KEYS, () => this.say(KEYS)),
      this.comparing,
      ...menu("save",
        button("PNG", "The picture", () => stage.canvas.toBlob((blob) => blob !== null && save(blob, `${name}.png`), "image/png")),
        button("SVG", "The picture as lines and faces", () => save(new Blob([stage.sketch()], { type: "image/svg+xml" }), `${name}.svg`)),
        button("GIF", "The motion as a film that plays everywhere", () => void this.filmed()),
        button("CSV", "The values", () => save(table(this.motion, this.head), `${name}.csv`)),
        recording));
  }

  /** The whole motion, frame by frame. */
  private async filmed(): Promise<void> {
    this.player.pause();
    this.stage.screen.film = true;
    const first = this.motion.at(0, 0);
    const length = this.motion.last - first;
    const made = await framed(this.stage.canvas, Math.min(Math.max(length, 3), 10), (part) => {
      this.pose(first + length * part);
      this.say(`Film: ${Math.round(100 * part)} %`);
    });
    save(made, `${this.head.name}.gif`);
    this.say("The film is saved.");
    this.stage.screen.film = false;
    this.pose(this.player.time);
  }

  private keys(): void {
    keys({
      ArrowRight: () => this.player.step(0.01),
      ArrowLeft: () => this.player.step(-0.01),
      "+": () => this.player.faster(1),
      "-": () => this.player.faster(-1),
      k: () => {
        this.kept = this.motion;
        this.comparing.selectedIndex = Math.max(this.comparing.selectedIndex, 1);
        this.compare(this.comparing.selectedIndex);
      },
      Escape: () => this.present(false),
      Home: () => this.player.go(-Infinity),
      End: () => this.player.go(Infinity),
    });
    document.addEventListener("fullscreenchange", () => {
      if (document.fullscreenElement === null && location.hash !== "#present") this.present(false);
    });
  }

  private pointer(): void {
    let over: Shape | null = null;
    this.stage.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0) return;
      const found = this.stage.shapeAt(event.clientX, event.clientY);
      if (found === over) return;
      over = found;
      this.mark(found?.span ? [found.span] : [], found === null ? {} : { shape: found, value: this.stage.value(found) });
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
  stage.pose(first, head.start);
  await shownOnce();
  void loadFont();
  await new Page(head, motions, stage).begin();
}

main().catch((error: unknown) => {
  place("said").textContent = `The page cannot be shown: ${String(error)}`;
});
