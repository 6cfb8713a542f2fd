import {openDialog} from "../shell/dialog";
import {h} from "../shell/dom";
import type {AxisGroup} from "./axis_group";
import {valueText} from "./legend";
import {numberText} from "./numbers";
import type {Scope} from "./scope";
import type {Trace} from "./trace";

/** Number of rows of the table. */
const rows = 21;

/** Shows the content of a scope as a table, with values at evenly spaced times of the window. */
export function showTable(scope: Scope): void {
  const {low, high} = scope.window.at(scope.shared.now), end = Math.min(high, Math.max(low, scope.shared.now));
  const shown = scope.groups.flatMap((group) => group.traces.map((trace): [Trace, AxisGroup] => [trace, group]));
  const head = h("tr", {}, h("th", {scope: "col"}, "time [s]"), ...shown.map(([{label}]) => h("th", {scope: "col"}, label)));
  const body = Array.from({length: rows}, (_, i) => low + ((end - low) * i) / (rows - 1)).map((time) => rowOf(scope, shown, time));
  openDialog(`Values of ${scope.name}`, [h("table", {class: "values"}, h("thead", {}, head), h("tbody", {}, ...body))]);
}

function rowOf(scope: Scope, shown: [Trace, AxisGroup][], time: number): HTMLElement {
  const cells = shown.map(([trace, {unit}]) => {
    const value = scope.valueOf(trace, time);
    return h("td", {}, value ? valueText(value, unit) : "–");
  });
  return h("tr", {}, h("th", {scope: "row"}, numberText(time, 6)), ...cells);
}
