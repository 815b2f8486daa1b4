// What can be saved from the page: a picture, a table, a film.
import type { Head } from "./head.ts";
import type { Motion } from "./motion.ts";

export function save(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

export function picture(canvas: HTMLCanvasElement, head: Head): void {
  canvas.toBlob((blob) => blob !== null && save(blob, `${head.name}.png`), "image/png");
}

export function table(motion: Motion, head: Head): void {
  const columns = head.columns.slice(0, head.scene.first);
  const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const lines = [columns.map((column) => quoted(column.name)).join(",")];
  for (let row = 0; row < motion.count; ++row) lines.push(columns.map((_, i) => motion.at(row, i)).join(","));
  save(new Blob([`${lines.join("\n")}\n`], { type: "text/csv" }), `${head.name}.csv`);
}

/** Records the canvas while it plays; the returned function ends that. */
export function film(canvas: HTMLCanvasElement, head: Head): () => void {
  const parts: Blob[] = [];
  const recorder = new MediaRecorder(canvas.captureStream(60), { mimeType: "video/webm" });
  recorder.ondataavailable = (event) => parts.push(event.data);
  recorder.onstop = () => save(new Blob(parts, { type: "video/webm" }), `${head.name}.webm`);
  recorder.start();
  return () => recorder.stop();
}
