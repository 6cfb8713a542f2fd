import type {Cursors} from "./cursors";
import {valueText} from "./legend";
import type {Scope} from "./scope";
import {marksText} from "./statistics";

/** Returns the text for screen readers after a cursor has moved: both cursors, and the values of one scope at the last one. */
export function speechOf({a, b}: Cursors, scope: Scope | undefined): string {
  const values = (scope?.groups ?? []).flatMap(({traces, unit}) => traces.map((trace) => {
    const value = scope!.valueOf(trace, b ?? a);
    return value ? `${trace.label} ${valueText(value, unit)}` : "";
  }));
  return [marksText(a, b), ...values].filter(Boolean).join("; ");
}
