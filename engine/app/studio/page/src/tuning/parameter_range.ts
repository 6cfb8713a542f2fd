import type {Parameter} from "../run/run_types";
import {plainNumber} from "../scopes/numbers";

/** The unit in which a parameter is written: shown = SI * scale. */
export interface OwnUnit {
  text: string;
  scale: number;
}

const quantity = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(.*?)\s*$/i;

/** Reads the unit off the text in the file, "10 mm" of 0.01; an expression, or a zero, is shown in SI. */
export function ownUnit({text, value, unit}: Pick<Parameter, "text" | "value" | "unit">): OwnUnit {
  const match = quantity.exec(text), number = Number(match?.[1]), si = unit === "1" ? "" : unit;
  if (!match || !Number.isFinite(number) || number === 0 || !(number / value > 0)) return {text: si, scale: 1};
  const scale = number / value;
  return {text: match[2], scale: Math.abs(scale - 1) < 1e-9 ? 1 : scale};
}

/** The ends of the slider [SI]: those of the file, else from 0 to twice the value. */
export function sliderRange({low, high, value}: Pick<Parameter, "low" | "high" | "value">): {low: number; high: number} {
  const size = Math.abs(value) || 1, below = low ?? (value < 0 ? -2 * size : value === 0 ? (high !== null && high <= 0 ? high - 1 : -1) : Math.min(0, high ?? 0));
  const above = high ?? (value < 0 ? Math.max(0, below) : Math.max(2 * value, below + size));
  return above > below ? {low: below, high: above} : {low: below, high: below + size};
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
