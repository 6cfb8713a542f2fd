import type {Cursors} from "./cursors";
import {valueText} from "./legend";
import type {Scope} from "./scope";
import {marksText} from "./statistics";

/** What is said when a cursor has moved: where both are, and the values of one scope at the one that moved last. */
export function speechOf({a, b}: Cursors, scope: Scope | undefined): string {
  const values = (scope?.groups ?? []).flatMap(({traces, unit}) => traces.map((trace) => {
    const value = scope!.valueOf(trace, b ?? a);
    return value ? `${trace.label} ${valueText(value, unit)}` : "";
  }));
  return [marksText(a, b), ...values].filter(Boolean).join("; ");
}
