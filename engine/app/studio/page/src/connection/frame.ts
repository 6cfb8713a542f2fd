/** Samples of some columns for one view, from a binary frame of the server; values in SI units. */
export interface Frame {
  view: number;
  sequence: number;
  /** All samples, or the minimum and maximum of each pixel: then each signal has two columns. */
  kind: "samples" | "extremes";
  /** Number of the run; increases with load, restart and seek. */
  run: number;
  /** Newest time of the run [s]. */
  newest: number;
  time: Float64Array;
  columns: Float64Array[];
}

const magic = 0x31445753;  // "SWD1", little endian
const headerSize = 32;

/** Reads a frame of protocol 1 without a copy: the columns are views of the message. Throws RangeError for any other message. */
export function readFrame(message: ArrayBuffer): Frame {
  const header = new DataView(message);
  if (message.byteLength < headerSize || header.getUint32(0, true) !== magic || header.getUint8(4) !== 1)
    throw new RangeError("this is no data frame of version 1");
  const rows = header.getUint32(12, true), count = header.getUint16(16, true);
  if (message.byteLength !== headerSize + 8 * rows * count || count < 1) throw new RangeError("the data frame is cut");
  const columns = Array.from({length: count}, (_, i) => new Float64Array(message, headerSize + 8 * rows * i, rows));
  return {
    view: header.getUint16(6, true), sequence: header.getUint32(8, true), kind: header.getUint8(5) === 0 ? "samples" : "extremes",
    run: header.getUint32(20, true), newest: header.getFloat64(24, true), time: columns[0], columns: columns.slice(1),
  };
}
