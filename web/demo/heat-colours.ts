// SPDX-License-Identifier: MIT
// Colours for distances: from dark blue over green to yellow, told apart in any kind of sight.

// The style sheet has the same for the legend's bar.
const stops = [0x440154, 0x3b528b, 0x21918c, 0x5ec962, 0xfde725].map((colour) => [
  (colour >> 16) / 255,
  ((colour >> 8) & 255) / 255,
  (colour & 255) / 255,
]);

/** Three numbers a distance, in the linear space that three.js reckons in; `largest` has the last colour. */
export function coloursOf(
  distances: ArrayLike<number>,
  largest: number,
): Float32Array<ArrayBuffer> {
  const colours = new Float32Array(3 * distances.length);
  const scale = largest > 0 ? (stops.length - 1) / largest : 0;
  for (let i = 0; i < distances.length; ++i) {
    const place = Math.min((distances[i] as number) * scale, stops.length - 1);
    const first = Math.min(Math.floor(place), stops.length - 2);
    const [from, to] = [stops[first] as number[], stops[first + 1] as number[]];
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [from[k] as number, to[k] as number];
      colours[3 * i + k] = linear(a + (place - first) * (b - a));
    }
  }
  return colours;
}

// From sRGB.
const linear = (value: number): number =>
  value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
