import type {Column, TraceSpec} from "../run/run_types";
import {type DisplayUnit, prefixed} from "./display_unit";

/** One curve of a scope. */
export interface Trace {
  /** Name or expression as it was given; by it the trace is found again after another load. */
  source: string;
  /** -1 while the run has none of it. */
  column: number;
  label: string;
  /** In which it is shown. Without it the SI unit, with a prefix by size. */
  unit: DisplayUnit | undefined;
  /** Text of the SI unit. */
  si: string;
  /** Of its colour and dash. */
  style: number;
}

/** Traces with the same key share an axis. */
export const scaleKey = (trace: Trace): string => (trace.unit ? `${trace.unit.text}*${trace.unit.scale}+${trace.unit.offset}` : trace.si || "1");

/** The unit of a trace while the largest magnitude on its axis is `magnitude` [SI]. */
export const unitOf = (trace: Trace, magnitude: number): DisplayUnit => trace.unit ?? prefixed(trace.si, magnitude);

/** A trace of a scope that the file asks for. */
export function traceOf(spec: TraceSpec, columns: Column[], style: number): Trace {
  const column = columns.find((one) => one.column === spec.column);
  const unit = {text: spec.unit, scale: spec.scale, offset: spec.offset ?? 0};
  const isSi = unit.scale === 1 && unit.offset === 0 && (!column || unit.text === column.unit);
  const source = spec.source ?? (!column ? spec.label : isSi ? column.name : `${column.name} in ${unit.text}`);
  return {source, column: spec.column, label: spec.label || source, unit: isSi ? undefined : unit, si: column?.unit ?? spec.unit, style};
}

/** A trace of a signal as it is recorded. */
export function traceOfColumn({column, name, unit}: Column, style: number): Trace {
  return {source: name, column, label: name, unit: undefined, si: unit, style};
}
