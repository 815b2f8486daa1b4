// Films as GIF (CompuServe, version 89a): frames of 252 colors, six levels of red and blue, seven of green.

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

/** The place of a color in the table. */
function place(red: number, green: number, blue: number): number {
  return (Math.round((red * 5) / 255) * 7 + Math.round((green * 6) / 255)) * 6 + Math.round((blue * 5) / 255);
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
  for (let k = 0; k < 256; ++k) {
    const [red, green, blue] = [Math.floor(k / 42), Math.floor(k / 6) % 7, k % 6];
    out.put(Math.min(red * 51, 255), Math.min(Math.round(green * 42.5), 255), blue * 51);
  }
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
    for (let i = 0; i < pixels.length; ++i) pixels[i] = place(data[4 * i], data[4 * i + 1], data[4 * i + 2]);
    compressed(pixels, out);
  }
  out.put(0x3b);
  return new Blob([out.all], { type: "image/gif" });
}
