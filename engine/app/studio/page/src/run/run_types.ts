// Messages of the server about a run (protocol 1). Values are SI; times in s of the run.

import type {DisplayUnit} from "../scopes/display_unit";

/** Scalar signal; `unit` is the text of its SI unit. */
export interface Column {
  column: number;
  name: string;
  unit: string;
  recorded: boolean;
}

/** Parameter of the file or of a part, or number of a block; `low` and `high` are its bounds in the file [SI]. */
export interface Parameter {
  name: string;
  text: string;
  value: number;
  unit: string;
  /** Unit in which the file writes the value: SI * scale + offset. */
  shown: DisplayUnit;
  low: number | null;
  high: number | null;
  doc: string;
  block: boolean;
}

/** Signal in its display unit: SI * `scale` + `offset` (for degC; default 0). */
export interface TraceSpec {
  column: number;
  label: string;
  unit: string;
  scale: number;
  offset?: number;
  /** Expression with its unit, as the argument of scope.signal. */
  source?: string;
}

export interface ScopeSpec {
  title: string;
  traces: TraceSpec[];
}

export interface InputSpec {
  name: string;
  size: number;
  unit: string;
  low: number | null;
  high: number | null;
}

export interface Loaded {
  run: number;
  step: number;
  stop: number | null;
  columns: Column[];
  parameters: Parameter[];
  scopes: ScopeSpec[];
  inputs: InputSpec[];
  scene: boolean;
  figures: number;
  claims: {that: string}[];
  /** Present for a real-time loop; times in s. */
  loop?: {rate: number; period: number; policy: string; overrun: string};
}

export type RunState = "playing" | "paused" | "ended";

/** State of a run. `rate` is the measured number of simulated seconds per second of the clock; `wanted` the requested one, 0: as fast as possible. */
export interface RunNews {
  run: number;
  state: RunState;
  time: number;
  tick: number;
  rate: number;
  wanted: number;
  missed: number;
  compiled: boolean;
  fault: string | null;
}

/** Value that the run has accepted, with its first tick. */
export interface SetEcho {
  name: string;
  /** SI; null if it is no number. */
  value: number | null;
  text: string;
  tick: number;
}

export interface Verdict {
  that: string;
  verdict: "ok" | "FAIL" | "known" | "open";
  text: string;
}

/** Result of a sweep over a parameter; columns in the order of `columns`, SI. */
export interface Fan {
  name: string;
  /** Unit in which the file writes the parameter. */
  unit: DisplayUnit;
  columns: number[];
  points: {value: number; time: number[]; columns: number[][]}[];
}
