// The worker that integrates: at most one motion under way, and only the newest wish waits.
import { inflated, type Head } from "./head.ts";
import { Motion } from "./motion.ts";
import type { Answer, Order, Setup } from "./orders.ts";
import type { Sliders } from "./sliders.ts";

export type Outcome = Omit<Answer, "rows"> & { motion: Motion };

const LONGEST = 3000; // [ms] of integration that somebody waits for

export class Live {
  busy = false;
  private waiting: Order | null = null;

  private constructor(
    private readonly worker: Worker,
    private readonly width: number,
    private readonly told: (outcome: Outcome) => void,
  ) {
    worker.onmessage = (event: MessageEvent<Answer>) => this.arrived(event.data);
  }

  /** Null where the browser cannot: the recorded motion stays. `tape`: of what, `by`: quantities that its end is
   * differentiated by, `longest`: how long it may take [ms]. */
  static async begin(
    head: Head,
    rows: number,
    told: (outcome: Outcome) => void,
    { tape = "tape", by = [] as number[], longest = LONGEST } = {},
  ): Promise<Live | null> {
    if (head.live === false || typeof WebAssembly === "undefined" || typeof Worker === "undefined") return null;
    try {
      const code = new Blob([await inflated("worker")], { type: "text/javascript" });
      const worker = new Worker(URL.createObjectURL(code));
      const { start, stop, tolerance, lasting, blamed: { entries: { length: entries } } } = head;
      const [wasm, own] = [(await inflated("wasm")).buffer, (await inflated(tape)).buffer];
      const setup: Setup = { wasm, tape: own, start, stop, rows, tolerance, lasting, by, longest, entries };
      const width = await new Promise<number>((resolve, reject) => {
        worker.onmessage = (event: MessageEvent<{ ready: number }>) => resolve(event.data.ready);
        worker.onerror = (event) => reject(new Error(event.message));
        worker.postMessage(setup, [wasm, own]);
      });
      return new Live(worker, width, told);
    } catch {
      return null;
    }
  }

  run([parameters, inputs]: Sliders["given"], pull: Order["pull"] = null): void {
    this.waiting = { parameters, inputs, pull };
    if (!this.busy) this.next();
  }

  end(): void {
    this.worker.terminate();
  }

  private next(): void {
    this.busy = this.waiting !== null;
    if (this.busy) this.worker.postMessage(this.waiting);
    this.waiting = null;
  }

  private arrived(answer: Answer): void {
    this.busy = false;
    this.told({ ...answer, motion: new Motion(this.width, answer.rows) });
    if (!this.busy) this.next();
  }
}
