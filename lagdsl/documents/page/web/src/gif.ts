// Films as GIF (CompuServe, version 89a), with the 256 colors that the frames have most.

const LEVELS = 5; // bits of a color that tell it from another one

const word = (value: number): number[] => [value & 255, value >> 8];
const text = (words: string): number[] => [...words].map((character) => character.charCodeAt(0));

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

/** T. A. Welch's compression with codes of 9 to 12 bits, in blocks of at most 255 bytes, after the size of a pixel. */
function compressed(pixels: Uint8Array): number[] {
  const [clear, end] = [256, 257];
  let table = new Map<number, number>();
  let [next, width, held, bits] = [258, 9, 0, 0];
  const packed: number[] = [];
  const code = (value: number): void => {
    held |= value << bits;
    for (bits += width; bits >= 8; bits -= 8, held >>= 8) packed.push(held & 255);
  };
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
  if (bits > 0) packed.push(held & 255);
  const blocks = Array.from({ length: Math.ceil(packed.length / 255) }, (_, k) => packed.slice(255 * k, 255 * (k + 1)));
  return [8, ...blocks.flatMap((block) => [block.length, ...block]), 0];
}

/** `frames` are pictures of one size; `delay` [ms] between them. They play again and again. */
export function gif(frames: ImageData[], delay: number): Blob {
  const { width, height } = frames[0];
  const size = [...word(width), ...word(height)];
  const { colors, places } = palette(frames);
  const table = Array.from({ length: 256 }, (_, k) => colors[k] ?? [0, 0, 0]).flat();
  const head = [...text("GIF89a"), ...size, 0xf7, 0, 0, ...table, 0x21, 0xff, 11, ...text("NETSCAPE2.0"), 3, 1, 0, 0, 0];
  const pictures = frames.map(({ data }) => {
    const pixels = Uint8Array.from({ length: width * height }, (_, i) => places[codeOf(data, 4 * i)]);
    const own = [0x21, 0xf9, 4, 0, ...word(Math.round(delay / 10)), 0, 0, 0x2c, 0, 0, 0, 0, ...size, 0];
    return Uint8Array.from(own.concat(compressed(pixels)));
  });
  return new Blob([Uint8Array.from(head), ...pictures, Uint8Array.of(0x3b)], { type: "image/gif" });
}
