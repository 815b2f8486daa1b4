// Of gifenc, which comes without types, as much as films need.
declare module "gifenc/src/index.js" {
  type Palette = number[][];
  export function quantize(pixels: Uint8ClampedArray, most: number): Palette;
  export function applyPalette(pixels: Uint8ClampedArray, palette: Palette): Uint8Array;
  export function GIFEncoder(): {
    writeFrame(places: Uint8Array, width: number, height: number, given: { palette?: Palette; delay: number }): void;
    finish(): void;
    bytes(): Uint8Array<ArrayBuffer>;
  };
}
