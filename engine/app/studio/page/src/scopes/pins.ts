import type {Connection} from "../connection/connection";
import {Feed} from "./feed";
import type {Samples} from "./samples";
import type {Trace} from "./trace";

/** Pinned run, for comparison: samples by the source of each trace, SI. */
export interface Pin {
  label: string;
  to: number;
  pixels: number;
  samples: Map<string, Samples>;
}

/** Resolution of a pin over its whole length, and maximum number of pins. */
const pixels = 4000, most = 4;

/** Pinned runs, drawn behind later ones. */
export class Pins {
  readonly all: Pin[] = [];
  private number = 0;

  constructor(private readonly connection: Connection, private readonly changed: () => void) {}

  /** Pins these traces up to `to` [s]; removes the oldest pin if there are too many. */
  take(traces: Trace[], to: number, note: string): Promise<Pin> {
    const known = traces.filter(({column}) => column >= 0), columns = [...new Set(known.map(({column}) => column))].sort((a, b) => a - b);
    return new Promise((resolve) => {
      const feed = new Feed(this.connection, () => {
        const samples = new Map(known.map(({source, column}) => [source, copied(feed.samples.get(column)!)]));
        feed.stop();
        resolve(this.keep({label: `run ${++this.number}${note && `, ${note}`}`, to, pixels, samples}));
      });
      feed.want({columns, from: 0, to, pixels});
    });
  }

  drop(pin: Pin): void {
    const at = this.all.indexOf(pin);
    if (at >= 0) this.all.splice(at, 1);
    this.changed();
  }

  private keep(pin: Pin): Pin {
    this.all.push(pin);
    if (this.all.length > most) this.all.shift();
    this.changed();
    return pin;
  }
}

/** Copies samples out of a frame, whose memory block holds all columns. */
function copied({time, low, high}: Samples): Samples {
  const kept = low.slice();
  return {time: time.slice(), low: kept, high: high === low ? kept : high.slice()};
}
