// Bytes in the text of the page: four of them are five digits of base 85 (RFC 1924, with "," for "<").
const DIGITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;,=>?@^_`{|}~";

export function bytesOf(packed: string): Uint8Array<ArrayBuffer> {
  const places = new Uint8Array(128);
  for (let i = 0; i < 85; ++i) places[DIGITS.charCodeAt(i)] = i;
  const text = packed.trim();
  const found = new DataView(new ArrayBuffer(4 * Math.ceil(text.length / 5)));
  for (let i = 0; i < text.length; i += 5) {
    let word = 0;
    for (let k = 0; k < 5; ++k) word = word * 85 + (i + k < text.length ? places[text.charCodeAt(i + k)] : 84);
    found.setUint32((4 * i) / 5, word);
  }
  return new Uint8Array(found.buffer, 0, Math.floor((4 * text.length) / 5));
}

export async function inflate(packed: string): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytesOf(packed)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
