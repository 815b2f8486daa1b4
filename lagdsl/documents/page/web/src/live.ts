// The worker that integrates: at most one motion under way, and only the newest wish waits.
import { inflated, type Head } from "./head.ts";
import { Motion } from "./motion.ts";
import type { Answer, Setup } from "./orders.ts";

export interface Outcome {
  motion: Motion;
  status: number;
  time: number;
  took: number;
  derivatives: Float64Array;
}

/** A session that is not that of the machine: another tape; quantities that its end is differentiated by. */
export interface Wishes {
  tape?: string;
  by?: number[];
}

export class Live {
  private busy = false;
  private waiting: { parameters: Float64Array; inputs: Float64Array } | null = null;
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

  run(parameters: Float64Array, inputs: Float64Array): void {
    this.waiting = { parameters, inputs };
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
    const motion = new Motion(this.width, answer.rows);
    this.told({ motion, status: answer.status, time: answer.time, took: answer.took, derivatives: answer.derivatives });
    this.next();
  }
}

