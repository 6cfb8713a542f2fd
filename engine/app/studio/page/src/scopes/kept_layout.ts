import type {DisplayUnit} from "./display_unit";
import type {Trace} from "./trace";

/** Scope as stored between visits, and in the address of a view. */
export interface KeptScope {
  title: string;
  traces: {source: string; label: string; unit?: DisplayUnit; si: string; style: number}[];
  against?: boolean;
  own?: KeptWindow;
}

export interface KeptWindow {
  width: number;
  from: number | null;
  to: number | null;
}

export interface KeptLayout {
  version: 1;
  scopes: KeptScope[];
  window: KeptWindow;
  cursors?: {a?: number; b?: number};
}

export function keptTraces(traces: Trace[]): KeptScope["traces"] {
  return traces.map(({source, label, unit, si, style}) => ({source, label, unit, si, style}));
}

/** Returns the traces of a stored scope, without columns. */
export function tracesOf({traces}: KeptScope): Trace[] {
  return traces.map(({source, label, unit, si, style}) => ({source, label, unit, si, style, column: -1}));
}

const isNumber = (value: unknown): value is number => typeof value === "number" && Number.isFinite(value);
const isText = (value: unknown): value is string => typeof value === "string" && value.length < 2000;
const isWindow = (value: any): value is KeptWindow => isNumber(value?.width) && value.width > 0 && [value.from, value.to].every((end) => end === null || isNumber(end));
const isUnit = (value: any) => value === undefined || (isText(value?.text) && isNumber(value.scale) && value.scale !== 0 && isNumber(value.offset));
const isTrace = (value: any) => isText(value?.source) && isText(value.label) && isText(value.si) && isNumber(value.style) && isUnit(value.unit);
const isScope = (value: any) => isText(value?.title) && Array.isArray(value.traces) && value.traces.length <= 12 && value.traces.every(isTrace)
  && (value.own === undefined || isWindow(value.own));

/** Validates a layout from an address or a file; undefined if it is invalid. */
export function readLayout(value: any): KeptLayout | undefined {
  const fits = value?.version === 1 && Array.isArray(value.scopes) && value.scopes.length <= 50 && value.scopes.every(isScope) && isWindow(value.window);
  return fits ? (value as KeptLayout) : undefined;
}

const key = "#scopes=";

/** Returns the address of the page with these scopes. It contains no token: the recipient needs one of the same server. */
export function addressOf(layout: KeptLayout, page: string): string {
  return `${page.replace(/[?#].*$/, "")}${key}${encodeURIComponent(JSON.stringify(layout))}`;
}

export function layoutOfAddress(hash: string): KeptLayout | undefined {
  if (!hash.startsWith(key)) return undefined;
  try {
    return readLayout(JSON.parse(decodeURIComponent(hash.slice(key.length))));
  } catch {
    return undefined;
  }
}
