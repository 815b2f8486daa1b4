// The clock of the page: play, pause, scrub, speed; the ticks of events.
import { make } from "./dom.ts";
import type { Occurrence, Head } from "./head.ts";
import { above, apart, density } from "./numbers.ts";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];
const SECONDS = [1, 60]; // motions of these lengths begin in real time, all others take a few seconds to watch
const WATCHED = 5; // [s]

/** 1 is real time. */
function usual(length: number): number {
  const [least, most] = SECONDS;
  return length >= least && length <= most ? 1 : Number(above(length / WATCHED).toPrecision(1));
}

export class Player {
  time: number;
  private speed: number;
  private readonly choices: number[];
  private pace = 1; // seconds of the motion in a second at speed 1
  private span: [number, number];
  private readonly again: boolean; // modes begin anew where they end
  private running = false;
  private before = 0;
  private readonly bar: HTMLInputElement;
  private readonly button: HTMLButtonElement;
  private readonly clock: HTMLOutputElement;
  private readonly ticks: HTMLElement;
  private readonly chooser: HTMLSelectElement;

  constructor(
    head: Head,
    place: HTMLElement,
    private readonly moved: (time: number) => void,
  ) {
    this.time = head.start;
    this.span = [head.start, head.stop];
    this.again = head.modes !== undefined;
    this.speed = this.again ? 1 : usual(head.stop - head.start);
    const parts = this.speed === 1 ? SPEEDS : [...[0.1, 0.2, 0.5, 1, 2, 5].map((part) => part * this.speed), 1];
    this.choices = [...new Set(parts.map((speed) => Number(speed.toPrecision(3))))].sort((a, b) => a - b);
    this.button = make("button", { className: "play", onclick: () => this.toggle() });
    const { start: min, stop: max } = head;
    this.bar = make("input", { type: "range", min: `${min}`, max: `${max}`, step: "any", value: `${min}`, ariaLabel: "Time" });
    this.bar.oninput = () => this.go(Number(this.bar.value));
    this.clock = make("output", { className: "clock" });
    this.ticks = make("div", { className: "ticks", ariaHidden: "true" });
    const track = make("div", { className: "track" }, this.ticks, this.bar);
    this.chooser = this.speeds();
    place.append(this.button, track, this.clock, this.chooser);
    this.mark(head.events);
    this.show();
  }

  /** Another motion, over times of its own; the clock goes to the same part of it. */
  over(start: number, stop: number, pace: number): void {
    const [before, after] = this.span;
    const part = (this.time - before) / (after - before || 1);
    const same = before === start && after === stop;
    this.span = [start, stop];
    this.pace = pace;
    Object.assign(this.bar, { min: `${start}`, max: `${stop}` });
    if (!same) this.time = start + part * (stop - start);
    this.show();
  }

  faster(steps: number): void {
    const place = Math.min(Math.max(this.choices.indexOf(this.speed) + steps, 0), this.choices.length - 1);
    this.speed = this.choices[place];
    this.chooser.value = `${this.speed}`;
  }

  private speeds(): HTMLSelectElement {
    const select = make("select", { ariaLabel: "Speed" });
    for (const speed of this.choices) select.append(new Option(`${speed}×`, `${speed}`, speed === this.speed, speed === this.speed));
    select.onchange = () => (this.speed = Number(select.value));
    return select;
  }

  mark(events: Occurrence[]): void {
    const [start, stop] = this.span;
    const ticks = apart(events, start, stop).map(({ time, name, kind }) => {
      const tick = make("i", { title: `${name} ${kind}`, className: kind });
      tick.style.left = `${(100 * (time - start)) / (stop - start)}%`;
      return tick;
    });
    const often = density(events, start, stop).map((part) => make("b", { style: `opacity: ${0.5 * part}` } as object));
    this.ticks.replaceChildren(...often, ...ticks);
  }

  toggle(): void {
    if (this.running) this.pause();
    else this.play();
  }

  play(): void {
    if (this.time >= this.span[1]) [this.time] = this.span;
    this.running = true;
    this.before = performance.now();
    requestAnimationFrame((now) => this.tick(now));
    this.show();
  }

  pause(): void {
    this.running = false;
    this.show();
  }

  go(time: number): void {
    this.time = Math.min(Math.max(time, this.span[0]), this.span[1]);
    this.show();
    this.moved(this.time);
  }

  step(part: number): void {
    this.pause();
    this.go(this.time + part * (this.span[1] - this.span[0]));
  }

  /** So many that two moments of the motion differ. */
  private get digits(): number {
    return Math.min(Math.max(2 - Math.floor(Math.log10((this.span[1] - this.span[0]) / 2)), 2), 9);
  }

  private tick(now: number): void {
    if (!this.running) return;
    const next = this.time + ((now - this.before) / 1000) * this.speed * this.pace;
    this.before = now;
    if (next >= this.span[1] && !this.again) {
      this.go(this.span[1]);
      this.pause();
      return;
    }
    this.go(next >= this.span[1] ? this.span[0] : next);
    requestAnimationFrame((later) => this.tick(later));
  }

  private show(): void {
    this.button.textContent = this.running ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", this.running ? "Pause" : "Play");
    this.bar.value = `${this.time}`;
    this.clock.value = `${this.time.toFixed(this.digits)} s`;
  }
}
