import type {Parameter} from "../run/run_types";
import {plainNumber} from "../scopes/numbers";

/** The unit in which a parameter is written: shown = SI * scale. */
export interface OwnUnit {
  text: string;
  scale: number;
}

const quantity = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*((?:[\p{L}%°(1][\p{L}\d%°()^*/. -]*)?)$/iu;

/** Reads the unit off the text in the file, "10 mm" of 0.01; an expression, or a zero, is shown in SI. */
export function ownUnit({text, value, unit}: Pick<Parameter, "text" | "value" | "unit">): OwnUnit {
  const match = quantity.exec(text), number = Number(match?.[1]), si = unit === "1" ? "" : unit;
  if (!match || !Number.isFinite(number) || number === 0 || !(number / value > 0)) return {text: si, scale: 1};
  const scale = number / value;
  return {text: match[2].trim(), scale: Math.abs(scale - 1) < 1e-9 ? 1 : scale};
}

/** The ends of the slider [SI]: those of the file, else from 0 to twice the value, and of a zero from -1 to 1. */
export function sliderRange({low, high, value}: Pick<Parameter, "low" | "high" | "value">): {low: number; high: number} {
  const usual = value === 0 ? {low: -1, high: 1} : {low: Math.min(0, 2 * value), high: Math.max(0, 2 * value)};
  const range = {low: low ?? Math.min(usual.low, high ?? 0), high: high ?? Math.max(usual.high, low ?? 0)};
  return range.high > range.low ? range : {low: range.low, high: range.low + (Math.abs(value) || 1)};
}

/** Places of a slider, and what one of them is worth. */
export const places = 1000;

export function valueAt(place: number, {low, high}: {low: number; high: number}): number {
  return low + ((high - low) * place) / places;
}

export function placeOf(value: number, {low, high}: {low: number; high: number}): number {
  return Math.round((places * Math.min(high, Math.max(low, value)) - places * low) / (high - low));
}

/** "8.25 kg": as many digits as a slider tells apart. */
export function valueText(value: number, {text, scale}: OwnUnit): string {
  const number = plainNumber(value * scale, 5);
  return text === "" ? number : `${number} ${text}`;
}
