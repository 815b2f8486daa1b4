// The worker that integrates: at most one motion under way, and only the newest wish waits.
import { inflated, type Head } from "./head.ts";
import { Motion } from "./motion.ts";
import type { Answer, Order, Setup } from "./orders.ts";

export type Outcome = Omit<Answer, "rows"> & { motion: Motion };

/** A session that is not that of the machine: another tape; quantities that its end is differentiated by. */
export interface Wishes {
  tape?: string;
  by?: number[];
}

export class Live {
  private busy = false;
  private waiting: Omit<Order, "number"> | null = null;
  private number = 0;

  private constructor(
    private readonly worker: Worker,
    private readonly width: number,
    private readonly told: (outcome: Outcome) => void,
  ) {
    worker.onmessage = (event: MessageEvent<Answer>) => this.arrived(event.data);
  }

  /** Null where the browser cannot: the recorded motion stays. */
  static async begin(
    head: Head,
    rows: number,
    told: (outcome: Outcome) => void,
    { tape = "tape", by = [] }: Wishes = {},
  ): Promise<Live | null> {
    if (head.live === false || typeof WebAssembly === "undefined" || typeof Worker === "undefined") return null;
    try {
      const code = new Blob([await inflated("worker")], { type: "text/javascript" });
      const worker = new Worker(URL.createObjectURL(code));
      const setup: Setup = {
        wasm: (await inflated("wasm")).buffer,
        tape: (await inflated(tape)).buffer,
        start: head.start,
        stop: head.stop,
        rows,
        tolerance: head.tolerance,
        lasting: head.lasting,
        by,
        entries: head.blamed.entries.length,
      };
      const width = await new Promise<number>((resolve, reject) => {
        worker.onmessage = (event: MessageEvent<{ ready: number }>) => resolve(event.data.ready);
        worker.onerror = (event) => reject(new Error(event.message));
        worker.postMessage(setup, [setup.wasm, setup.tape]);
      });
      return new Live(worker, width, told);
    } catch {
      return null;
    }
  }

  run(parameters: Float64Array, inputs: Float64Array, pull: Order["pull"] = null): void {
    this.waiting = { parameters, inputs, pull };
    if (!this.busy) this.next();
  }

  private next(): void {
    if (this.waiting === null) return;
    this.worker.postMessage({ number: ++this.number, ...this.waiting });
    this.waiting = null;
    this.busy = true;
  }

  private arrived(answer: Answer): void {
    this.busy = false;
    this.told({ ...answer, motion: new Motion(this.width, answer.rows) });
    this.next();
  }
}

