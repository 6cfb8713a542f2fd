// Encoder of cells as a PNG data URL for an <image>. It needs no canvas, so a figure is SVG text even without a browser.

const table = Uint32Array.from({length: 256}, (_, byte) => {
  let c = byte;
  for (let i = 0; i < 8; ++i) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c >>> 0;
});

function checksum(bytes: Uint8Array): number {
  let c = 0xffffffff;
  for (const byte of bytes) c = table[(c ^ byte) & 255]! ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

function adler(bytes: Uint8Array): number {
  let a = 1, b = 0;
  for (const byte of bytes) b = (b + (a = (a + byte) % 65521)) % 65521;
  return ((b << 16) | a) >>> 0;
}

const number32 = (value: number) => [value >>> 24, (value >>> 16) & 255, (value >>> 8) & 255, value & 255];

function chunk(name: string, data: Uint8Array): Uint8Array {
  const letters = [...name].map((letter) => letter.charCodeAt(0));
  const named = new Uint8Array(4 + data.length);
  named.set(letters);
  named.set(data, 4);
  const whole = new Uint8Array(12 + data.length);
  whole.set(number32(data.length));
  whole.set(named, 4);
  whole.set(number32(checksum(named)), 8 + data.length);
  return whole;
}

/** Returns a zlib stream without compression, as there are few cells. */
function stored(bytes: Uint8Array): Uint8Array {
  const most = 65535, parts: number[][] = [], starts: number[] = [];
  for (let at = 0; at < bytes.length || at === 0; at += most) {
    const length = Math.min(most, bytes.length - at), last = at + most >= bytes.length ? 1 : 0;
    parts.push([last, length & 255, length >> 8, ~length & 255, (~length >> 8) & 255]);
    starts.push(at);
  }
  const stream = new Uint8Array(2 + bytes.length + 5 * parts.length + 4);
  stream.set([0x78, 0x01]);
  let at = 2;
  parts.forEach((head, i) => {
    const piece = bytes.subarray(starts[i], starts[i]! + most);
    stream.set(head, at);
    stream.set(piece, at + 5);
    at += 5 + piece.length;
  });
  stream.set(number32(adler(bytes)), at);
  return stream;
}

/** Returns "data:image/png;base64,..."; `pixels` has red, green, blue and opacity of each cell, 0 to 255. */
export function pngAddress(pixels: Uint8ClampedArray, columns: number, rows: number): string {
  const raw = new Uint8Array(rows * (4 * columns + 1));
  for (let row = 0; row < rows; ++row) raw.set(pixels.subarray(4 * columns * row, 4 * columns * (row + 1)), row * (4 * columns + 1) + 1);
  const header = Uint8Array.of(...number32(columns), ...number32(rows), 8, 6, 0, 0, 0);
  const files = [Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10), chunk("IHDR", header), chunk("IDAT", stored(raw)), chunk("IEND", new Uint8Array(0))];
  let text = "";
  for (const file of files) for (let i = 0; i < file.length; i += 8192) text += String.fromCharCode(...file.subarray(i, i + 8192));
  return "data:image/png;base64," + btoa(text);
}
