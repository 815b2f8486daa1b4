// Films as GIF (CompuServe, version 89a), with the 256 colors that the frames have most.

class Bytes {
  private readonly list: number[] = [];

  put(...bytes: number[]): void {
    for (const byte of bytes) this.list.push(byte);
  }

  word(value: number): void {
    this.put(value & 255, value >> 8);
  }

  text(words: string): void {
    for (const character of words) this.put(character.charCodeAt(0));
  }

  get all(): Uint8Array<ArrayBuffer> {
    return Uint8Array.from(this.list);
  }
}

const LEVELS = 5; // bits of a color that tell it from another one

function codeOf(data: Uint8ClampedArray, at: number): number {
  return ((data[at] >> 3) << 10) | ((data[at + 1] >> 3) << 5) | (data[at + 2] >> 3);
}

/** The most frequent colors, and the place of the nearest one for each code. */
function palette(frames: ImageData[]): { colors: number[][]; places: Uint8Array } {
  const counts = new Uint32Array(1 << (3 * LEVELS));
  for (const { data } of frames) for (let at = 0; at < data.length; at += 4) ++counts[codeOf(data, at)];
  const color = (code: number): number[] => [10, 5, 0].map((shift) => Math.round((((code >> shift) & 31) * 255) / 31));
  const seen = [...counts.keys()].filter((code) => counts[code] > 0).sort((a, b) => counts[b] - counts[a]);
  const colors = seen.slice(0, 256).map(color);
  const places = new Uint8Array(counts.length);
  for (const code of seen) {
    const own = color(code);
    const away = colors.map((each) => each.reduce((sum, part, k) => sum + (part - own[k]) ** 2, 0));
    places[code] = away.indexOf(Math.min(...away));
  }
  return { colors, places };
}

/** T. A. Welch's compression with codes of 9 to 12 bits, in blocks of at most 255 bytes. */
function compressed(pixels: Uint8Array, out: Bytes): void {
  const [clear, end] = [256, 257];
  let table = new Map<number, number>();
  let [next, width, held, bits] = [258, 9, 0, 0];
  let block: number[] = [];
  const flush = (): void => {
    if (block.length > 0) out.put(block.length, ...block);
    block = [];
  };
  const code = (value: number): void => {
    held |= value << bits;
    bits += width;
    while (bits >= 8) {
      block.push(held & 255);
      held >>= 8;
      bits -= 8;
      if (block.length === 255) flush();
    }
  };
  out.put(8);
  code(clear);
  let prefix = pixels[0];
  for (let i = 1; i < pixels.length; ++i) {
    const key = (prefix << 8) | pixels[i];
    const known = table.get(key);
    if (known !== undefined) {
      prefix = known;
      continue;
    }
    code(prefix);
    if (next < 4096) {
      if (next === 1 << width && width < 12) ++width;
      table.set(key, next++);
    } else {
      code(clear);
      table = new Map();
      [next, width] = [258, 9];
    }
    prefix = pixels[i];
  }
  code(prefix);
  if (next === 1 << width && width < 12) ++width;
  code(end);
  if (bits > 0) block.push(held & 255);
  flush();
  out.put(0);
}

/** `frames` are pictures of one size; `delay` [ms] between them. They play again and again. */
export function gif(frames: ImageData[], delay: number): Blob {
  const out = new Bytes();
  const { width, height } = frames[0];
  out.text("GIF89a");
  out.word(width);
  out.word(height);
  out.put(0xf7, 0, 0);
  const { colors, places } = palette(frames);
  for (let k = 0; k < 256; ++k) out.put(...(colors[k] ?? [0, 0, 0]));
  out.put(0x21, 0xff, 11);
  out.text("NETSCAPE2.0");
  out.put(3, 1, 0, 0, 0);
  for (const { data } of frames) {
    out.put(0x21, 0xf9, 4, 0);
    out.word(Math.round(delay / 10));
    out.put(0, 0, 0x2c, 0, 0, 0, 0);
    out.word(width);
    out.word(height);
    out.put(0);
    const pixels = new Uint8Array(width * height);
    for (let i = 0; i < pixels.length; ++i) pixels[i] = places[codeOf(data, 4 * i)];
    compressed(pixels, out);
  }
  out.put(0x3b);
  return new Blob([out.all], { type: "image/gif" });
}
