// History of the parameter values of a run: initial values, and values set during the run.

import type {Parameter} from "../run/run_types";
import {valueText} from "../tuning/parameter_range";

/** Event of a run, from the call `run.log`. */
export interface LogEvent {
  tick: number;
  name: string;
  text?: string;
  values?: number[];
}

/** Time between two values below which they belong to one slider movement [s]. */
const together = 0.25;
const secondsOf = (time: number) => `${Number(time.toPrecision(4))} s`;

/** Largest number of values that are listed one by one; a movement of a slider has more. */
const listed = 3;

/** True for a number without unit, which is SI. Sliders set such numbers, and typed ones have the unit of the field. */
const isBare = (text: string) => text.trim() !== "" && Number.isFinite(Number(text));

/** Formats a value that was set. */
function setText(text: string, parameter: Parameter | undefined): string {
  return parameter && isBare(text) ? valueText(Number(text), parameter.shown) : text;
}

/** Returns "then 3.8 kg at 0.7 s" for each value, and a single text for a slider movement. */
function changes(events: LogEvent[], parameter: Parameter | undefined, step: number): string[] {
  const moves: LogEvent[][] = [];
  for (const event of events) {
    const last = moves.at(-1)?.at(-1), areBare = [last, event].every((one) => isBare(one?.text ?? ""));
    if (last && areBare && (event.tick - last.tick) * step <= together) moves.at(-1)!.push(event);
    else moves.push([event]);
  }
  const textOf = (event: LogEvent) => setText(event.text ?? "", parameter), timeOf = ({tick}: LogEvent) => secondsOf(tick * step);
  return moves.flatMap((move) => {
    const first = move[0], last = move.at(-1)!;
    if (move.length <= listed || first.tick === last.tick) return move.map((one) => `then ${textOf(one)} at ${timeOf(one)}`);
    return [`then moved to ${textOf(last)} from ${timeOf(first)} to ${timeOf(last)}`];
  });
}

/** Returns "mass 2 kg, then 3.8 kg at 0.7 s" for each parameter that was set, and up to `others` unchanged parameters. */
export function historyOf(parameters: Parameter[], events: LogEvent[], step: number, others = 2): string[] {
  const set = new Map<string, LogEvent[]>(), find = (name: string) => parameters.find((one) => one.name === name);
  for (const event of events) if (event.text !== undefined) set.set(event.name, [...(set.get(event.name) ?? []), event]);
  const lines = [...set].map(([name, all]) => {
    const parameter = find(name), before = all.filter(({tick}) => tick <= 0).at(-1)?.text;
    const start = before === undefined ? parameter?.text ?? "its value in the text" : setText(before, parameter);
    return [`${name} ${start}`, ...changes(all.filter(({tick}) => tick > 0), parameter, step)].join(", ");
  });
  const unset = parameters.filter(({name, block}) => !block && !set.has(name)).slice(0, Math.max(0, others - lines.length));
  const inputs = [...new Set(events.filter(({values}) => values).map(({name}) => name))];
  return [...lines, ...unset.map(({name, text}) => `${name} ${text}`), ...(inputs.length > 0 ? [`moved by hand: ${inputs.join(", ")}`] : [])];
}
