// Types of the news 'loop', which follow from the declaration in loop_thread.cpp. A test compares them.

/** Histogram of times with bins of a quarter octave. */
export interface Histogram {
  /** edges, one more than counts [s] */
  edges: number[];
  /** counts of the bins */
  counts: number[];
  /** number of times */
  count: number;
  /** median [s] */
  p50: number;
  /** not exceeded by 99 % [s] */
  p99: number;
  /** not exceeded by 99.9 % [s] */
  p999: number;
  /** longest [s] */
  max: number;
}

/** Cost of the blocks of a type. */
export interface LiveCost {
  /** type */
  type: string;
  /** number of blocks */
  blocks: number;
  /** mean time of a tick [s] */
  mean: number;
}

/** Timing of a real-time loop, which may be running. */
export interface LoopNews {
  /** period [s] */
  period: number;
  /** number of executed steps */
  served: number;
  /** late and dropped deadlines */
  missed: number;
  /** late deadlines */
  late: number;
  /** dropped deadlines */
  dropped: number;
  /** longest run of successive misses */
  longest: number;
  /** delay of the wake-up */
  lateness: Histogram;
  /** time until outputs are written */
  response: Histogram;
  /** duration of a whole wake-up */
  step: Histogram;
  /** cost by block type, most expensive first */
  costs: LiveCost[];
  /** number of the run */
  run: number;
  /** ticks that were lost on the way to the page */
  lost: number;
  /** effective policy */
  policy: string;
  /** requests that the system refused */
  refused: string[];
}
