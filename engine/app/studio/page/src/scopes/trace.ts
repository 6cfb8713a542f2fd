import type {Column, TraceSpec} from "../run/run_types";
import {type DisplayUnit, prefixed} from "./display_unit";

/** Curve of a scope. */
export interface Trace {
  /** Original name or expression, from which the trace is resolved again after another load. */
  source: string;
  /** Column of the run; -1 if the run lacks it. */
  column: number;
  label: string;
  /** Display unit; undefined for the SI unit with an automatic prefix. */
  unit: DisplayUnit | undefined;
  /** Text of the SI unit. */
  si: string;
  /** Number of its colour and dash style. */
  style: number;
}

/** Returns the key of a trace's axis; traces with the same key share one. */
export const scaleKey = (trace: Trace): string => (trace.unit ? `${trace.unit.text}*${trace.unit.scale}+${trace.unit.offset}` : trace.si || "1");

/** Returns the unit of a trace for the largest magnitude on its axis [SI]. */
export const unitOf = (trace: Trace, magnitude: number): DisplayUnit => trace.unit ?? prefixed(trace.si, magnitude);

/** Returns a trace of a scope in the file. */
export function traceOf(spec: TraceSpec, columns: Column[], style: number): Trace {
  const column = columns.find((one) => one.column === spec.column);
  const unit = {text: spec.unit, scale: spec.scale, offset: spec.offset ?? 0};
  const isSi = unit.scale === 1 && unit.offset === 0 && (!column || unit.text === column.unit);
  const source = spec.source ?? (!column ? spec.label : isSi ? column.name : `${column.name} in ${unit.text}`);
  return {source, column: spec.column, label: spec.label || source, unit: isSi ? undefined : unit, si: column?.unit ?? spec.unit, style};
}

/** Returns a trace of a recorded signal. */
export function traceOfColumn({column, name, unit}: Column, style: number): Trace {
  return {source: name, column, label: name, unit: undefined, si: unit, style};
}
