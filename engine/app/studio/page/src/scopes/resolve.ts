import type {Connection} from "../connection/connection";
import type {Column} from "../run/run_types";
import {type Trace, traceOfColumn} from "./trace";

interface Signal {
  column: number;
  name: string;
  unit: string;
  scale?: number;
  offset?: number;
}

/** Resolves a name, or an expression with units, which the server computes, to a trace. Rejects with a Fault. */
export async function resolve(source: string, columns: Column[], connection: Connection, style: number): Promise<Trace> {
  const text = source.trim(), known = columns.find(({name}) => name === text);
  if (known) return traceOfColumn(known, style);
  const {column, unit, scale = 1, offset = 0} = await connection.call<Signal>("scope.signal", {expression: text});
  const isSi = scale === 1 && offset === 0;
  return {source: text, column, label: text, unit: isSi ? undefined : {text: unit, scale, offset}, si: unit, style};
}

/** Resolves a trace again after another load. A trace that no longer exists remains, without values. */
export async function resolveAgain(trace: Trace, columns: Column[], connection: Connection): Promise<Trace> {
  const plain = trace.source.replace(/\s+in\s+[^()]*$/, ""), known = columns.find(({name}) => name === plain);
  if (known && (trace.unit !== undefined || plain === trace.source)) return {...trace, column: known.column};
  try {
    const found = await resolve(trace.source, columns, connection, trace.style);
    return {...found, label: trace.label};
  } catch {
    return {...trace, column: -1};
  }
}
