import type {Parameter} from "../run/run_types";
import {type DisplayUnit, shownOf} from "../scopes/display_unit";
import {plainNumber} from "../scopes/numbers";

/** Returns the range of the slider [SI]: the bounds of the file, else from 0 to twice the value, and for 0 from -1 to 1. */
export function sliderRange({low, high, value}: Pick<Parameter, "low" | "high" | "value">): {low: number; high: number} {
  const usual = value === 0 ? {low: -1, high: 1} : {low: Math.min(0, 2 * value), high: Math.max(0, 2 * value)};
  const range = {low: low ?? Math.min(usual.low, high ?? 0), high: high ?? Math.max(usual.high, low ?? 0)};
  return range.high > range.low ? range : {low: range.low, high: range.low + (Math.abs(value) || 1)};
}

/** Number of positions of a slider. */
export const places = 1000;

export function valueAt(place: number, {low, high}: {low: number; high: number}): number {
  return low + ((high - low) * place) / places;
}

export function placeOf(value: number, {low, high}: {low: number; high: number}): number {
  return Math.round((places * Math.min(high, Math.max(low, value)) - places * low) / (high - low));
}

/** Formats a value in the unit of the file, "8.25 kg", with the resolution of the slider. */
export function valueText(value: number, unit: DisplayUnit): string {
  const shown = shownOf(value, unit), number = plainNumber(Math.abs(shown) < 1e-12 * Math.abs(unit.offset) ? 0 : shown, 5);
  return unit.text === "" || unit.text === "1" ? number : `${number} ${unit.text}`;
}
