// What can be saved from the page: a table, films.
import { applyPalette, GIFEncoder, quantize } from "gifenc/src/index.js";
import { make } from "./dom.ts";
import type { Head } from "./head.ts";
import type { Motion } from "./motion.ts";

const FRAMES = 72;
const FRAME_WIDTH = 480;
const COLORS = 256; // one palette for all frames, so that what rests does not flicker
const TOLD = 8; // frames until the page shows how far a film is

export function save(blob: Blob, download: string): void {
  const link = make("a", { href: URL.createObjectURL(blob), download });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

export function table(motion: Motion, head: Head): Blob {
  const columns = head.columns.slice(0, head.scene.first);
  const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const lines = [columns.map((column) => quoted(column.name)).join(",")];
  for (let row = 0; row < motion.count; ++row) lines.push(columns.map((_, i) => motion.at(row, i)).join(","));
  return new Blob([`${lines.join("\n")}\n`], { type: "text/csv" });
}

/** Begins to record the canvas, or ends that, and then tells the film; true while it records. */
export function recorder(canvas: HTMLCanvasElement, made: (film: Blob) => void): () => boolean {
  let found: MediaRecorder | undefined;
  return () => {
    found ??= new MediaRecorder(canvas.captureStream(60), { mimeType: "video/webm" });
    found.ondataavailable = ({ data }) => made(data); // once, at the end
    if (found.state === "inactive") found.start();
    else found.stop();
    return found.state !== "inactive";
  };
}

/** A GIF of so many seconds; `pose` draws the canvas at a part of the motion. */
export async function framed(canvas: HTMLCanvasElement, seconds: number, pose: (part: number) => void): Promise<Blob> {
  const delay = (1000 * seconds) / FRAMES;
  const width = Math.min(FRAME_WIDTH, canvas.width);
  const height = Math.round((width * canvas.height) / canvas.width);
  const pen = make("canvas", { width, height }).getContext("2d", { willReadFrequently: true });
  if (pen === null) throw new Error("there is no canvas to draw a film on");
  pen.imageSmoothingQuality = "high";
  const frames: Uint8ClampedArray[] = [];
  const every = new Uint8ClampedArray(FRAMES * 4 * width * height);
  for (let k = 0; k < FRAMES; ++k) {
    pose(k / (FRAMES - 1));
    pen.drawImage(canvas, 0, 0, width, height);
    frames.push(pen.getImageData(0, 0, width, height).data);
    every.set(frames[k], k * frames[k].length);
    if (k % TOLD === 0) await new Promise((resolve) => setTimeout(resolve));
  }
  const palette = quantize(every, COLORS);
  const gif = GIFEncoder();
  frames.forEach((frame, k) => gif.writeFrame(applyPalette(frame, palette), width, height, { delay, ...(k === 0 && { palette }) }));
  gif.finish();
  return new Blob([gif.bytes()], { type: "image/gif" });
}
