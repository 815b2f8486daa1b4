// The clock of the page: play, pause, scrub, speed; the ticks of events.
import type { Head } from "./head.ts";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];

export class Player {
  time: number;
  private speed = 1;
  private running = false;
  private before = 0;
  private readonly bar: HTMLInputElement;
  private readonly button: HTMLButtonElement;
  private readonly clock: HTMLOutputElement;
  private readonly ticks: HTMLElement;

  constructor(
    private readonly head: Head,
    place: HTMLElement,
    private readonly moved: (time: number) => void,
  ) {
    this.time = head.start;
    this.button = document.createElement("button");
    this.button.className = "play";
    this.button.onclick = () => this.toggle();
    this.bar = document.createElement("input");
    Object.assign(this.bar, { type: "range", min: `${head.start}`, max: `${head.stop}`, step: "any", value: `${head.start}` });
    this.bar.setAttribute("aria-label", "Time");
    this.bar.oninput = () => this.go(Number(this.bar.value));
    this.clock = document.createElement("output");
    this.clock.className = "clock";
    this.ticks = document.createElement("div");
    this.ticks.className = "ticks";
    this.ticks.setAttribute("aria-hidden", "true");
    const track = document.createElement("div");
    track.className = "track";
    track.append(this.ticks, this.bar);
    place.append(this.button, track, this.clock, this.chooser());
    this.mark(head.events.map((event) => ({ time: event.time, title: `${event.name} ${event.kind}` })));
    this.show();
  }

  private chooser(): HTMLSelectElement {
    const select = document.createElement("select");
    select.setAttribute("aria-label", "Speed");
    for (const speed of SPEEDS) select.append(new Option(`${speed}×`, `${speed}`, speed === 1, speed === 1));
    select.onchange = () => (this.speed = Number(select.value));
    return select;
  }

  mark(events: { time: number; title: string }[]): void {
    const { start, stop } = this.head;
    this.ticks.replaceChildren(
      ...events.slice(0, 400).map(({ time, title }) => {
        const tick = document.createElement("i");
        tick.style.left = `${(100 * (time - start)) / (stop - start)}%`;
        tick.title = title;
        return tick;
      }),
    );
  }

  toggle(): void {
    if (this.running) this.pause();
    else this.play();
  }

  play(): void {
    if (this.time >= this.head.stop) this.time = this.head.start;
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
    this.time = Math.min(Math.max(time, this.head.start), this.head.stop);
    this.show();
    this.moved(this.time);
  }

  step(part: number): void {
    this.pause();
    this.go(this.time + part * (this.head.stop - this.head.start));
  }

  private tick(now: number): void {
    if (!this.running) return;
    const next = this.time + ((now - this.before) / 1000) * this.speed;
    this.before = now;
    if (next >= this.head.stop) {
      this.go(this.head.stop);
      this.pause();
      return;
    }
    this.go(next);
    requestAnimationFrame((later) => this.tick(later));
  }

  private show(): void {
    this.button.textContent = this.running ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", this.running ? "Pause" : "Play");
    this.bar.value = `${this.time}`;
    this.clock.value = `${this.time.toFixed(2)} s`;
  }
}
