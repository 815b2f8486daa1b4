// The clock of the page: play, pause, scrub, speed; the ticks of events.
import { button, choice, make } from "./dom.ts";
import type { Occurrence, Head } from "./head.ts";
import { above } from "./numbers.ts";
import { ticks } from "./ticks.ts";

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
  private readonly speeds: number[];
  private pace = 1; // seconds of the motion in a second at speed 1
  private span: [number, number];
  private readonly again: boolean; // modes begin anew where they end
  private running = false;
  private before = 0;
  private readonly bar = make("input", { type: "range", step: "any", ariaLabel: "Time", oninput: () => this.go(Number(this.bar.value)) });
  private readonly button = button("", "", () => (this.running ? this.pause() : this.play()), "Space");
  private readonly clock = make("output", { className: "clock" });
  private readonly ticks = make("div", { className: "ticks", ariaHidden: "true" });
  private readonly chooser: HTMLSelectElement;

  constructor(head: Head, place: HTMLElement, private readonly moved: (time: number) => void) {
    const { start, stop } = head;
    this.time = start;
    this.span = [start, stop];
    this.again = head.modes !== undefined;
    const own = this.again ? 1 : usual(stop - start);
    const parts = own === 1 ? SPEEDS : [...[0.1, 0.2, 0.5, 1, 2, 5].map((part) => part * own), 1];
    this.speeds = [...new Set(parts.map((speed) => Number(speed.toPrecision(3))))].sort((a, b) => a - b);
    this.chooser = choice("Speed", this.speeds.map((speed) => `${speed}×`), this.speeds.indexOf(own));
    this.button.className = "play";
    place.append(this.button, make("div", { className: "track" }, this.ticks, this.bar), this.clock, this.chooser);
    this.over(start, stop, 1);
    this.mark(head.events);
  }

  /** Another motion, over times of its own; the clock goes to the same part of it. */
  over(start: number, stop: number, pace: number): void {
    const [before, after] = this.span;
    if (before !== start || after !== stop) this.time = start + ((this.time - before) / (after - before || 1)) * (stop - start);
    this.span = [start, stop];
    this.pace = pace;
    Object.assign(this.bar, { min: `${start}`, max: `${stop}` });
    this.show();
  }

  faster(steps: number): void {
    this.chooser.selectedIndex = Math.min(Math.max(this.chooser.selectedIndex + steps, 0), this.speeds.length - 1);
  }

  mark(events: Occurrence[]): void {
    this.ticks.replaceChildren(...ticks(events, ...this.span));
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

  private tick(now: number): void {
    if (!this.running) return;
    const [start, stop] = this.span;
    const next = this.time + ((now - this.before) / 1000) * this.speeds[this.chooser.selectedIndex] * this.pace;
    this.before = now;
    this.go(next >= stop && this.again ? start : next);
    if (next >= stop && !this.again) this.pause();
    else requestAnimationFrame((later) => this.tick(later));
  }

  private show(): void {
    const [start, stop] = this.span;
    const digits = Math.min(Math.max(2 - Math.floor(Math.log10((stop - start) / 2)), 2), 9); // so many that two moments differ
    this.button.textContent = this.running ? "❚❚" : "▶";
    this.button.ariaLabel = this.running ? "Pause" : "Play";
    this.bar.value = `${this.time}`;
    this.clock.value = `${this.time.toFixed(digits)} s`;
  }
}
