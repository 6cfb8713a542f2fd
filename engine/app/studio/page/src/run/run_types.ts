// What the server says of a run (protocol 1). Values are SI; times in s of the run.

import type {DisplayUnit} from "../scopes/display_unit";

/** A scalar signal; `unit` is the text of its SI unit. */
export interface Column {
  column: number;
  name: string;
  unit: string;
  recorded: boolean;
}

/** A parameter of the file or of a part, or a number that a block was given; `low` and `high` [SI] where the file bounds it. */
export interface Parameter {
  name: string;
  text: string;
  value: number;
  unit: string;
  /** In which its file writes it: SI * scale + offset. */
  shown: DisplayUnit;
  low: number | null;
  high: number | null;
  doc: string;
  block: boolean;
}

/** A signal in the unit in which it is shown: SI times `scale` plus `offset` (of degC; 0 where it is left out). */
export interface TraceSpec {
  column: number;
  label: string;
  unit: string;
  scale: number;
  offset?: number;
  /** The expression with its unit, as scope.signal takes it. */
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
  /** Of a run that is a real-time loop; times in s. */
  loop?: {rate: number; period: number; policy: string; overrun: string};
}

export type RunState = "playing" | "paused" | "ended";

/** `rate` is seconds of the run in one of the clock, measured; `wanted` what was set, 0 for as fast as it goes. */
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

/** A value that was taken over, from which tick on. */
export interface SetEcho {
  name: string;
  /** SI; null of what is no number. */
  value: number | null;
  text: string;
  tick: number;
}

export interface Verdict {
  that: string;
  verdict: "ok" | "FAIL" | "known" | "open";
  text: string;
}

/** Results of a sweep over a parameter; columns in the order of `columns`, SI. */
export interface Fan {
  name: string;
  /** In which the file writes the parameter. */
  unit: DisplayUnit;
  columns: number[];
  points: {value: number; time: number[]; columns: number[][]}[];
}
