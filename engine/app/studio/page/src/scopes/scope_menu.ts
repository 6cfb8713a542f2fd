import {copyText, insertText} from "./hand_over";
import {figureText, figureTextXy} from "./figure_text";
import {saveFile} from "./save_file";
import type {Scope} from "./scope";
import {scopeSvg} from "./scope_svg";
import {showTable} from "./scope_table";

type Entry = [string, () => void];

/** Returns the menu entries of a scope. */
export function entriesOf(scope: Scope): Entry[] {
  return [...kinds(scope), ...times(scope), ...files(scope), ["Table of values", () => showTable(scope)], ["Remove this scope", () => scope.host.remove(scope)]];
}

function kinds(scope: Scope): Entry[] {
  const back: Entry[] = scope.isAgainst || scope.comparedTo ? [["Show over time", () => scope.fill("time")]] : [];
  const against: Entry[] = scope.isAgainst ? [] : [["Plot against the first signal (XY)", () => scope.fill("against")]];
  const pins = scope.shared.pins.all.filter((pin) => pin !== scope.comparedTo);
  return [...back, ...against, ...pins.map((pin): Entry => [`Show the difference to ${pin.label}`, () => scope.fill(pin)])];
}

function times(scope: Scope): Entry[] {
  const range = scope.groups.some((group) => group.range.isChosen);
  const fit: Entry[] = range ? [["Fit the values", () => { scope.groups.forEach((group) => group.range.fit()); scope.shared.redraw(); }]] : [];
  const own: Entry = scope.own ? ["Same time as the other scopes", () => scope.shareTime()] : ["Independent time", () => void scope.takeOwnTime()];
  return [...fit, own];
}

function files(scope: Scope): Entry[] {
  return [
    ["Save the range as CSV", () => void saveCsv(scope)],
    ["Save the picture as SVG", () => saveFile(`${scope.name || "scope"}.svg`, "image/svg+xml", scopeSvg(scope))],
    ["Copy as a section figure", () => void copyText(scope.shared.context, `figure: ${figureOf(scope)}\n`, "figure")],
    ["Add as a figure to the text", () => insertText(scope.element, scope.shared.context, "figure", figureOf(scope))],
  ];
}

function figureOf(scope: Scope): string {
  const [first, ...others] = scope.traces, {isFollowing} = scope.window;
  if (scope.isAgainst && first) return figureTextXy(scope.name, first, others);
  return figureText(scope.name, scope.groups.map(({traces}) => traces), isFollowing ? undefined : scope.window.at(scope.shared.now));
}

/** Saves all samples between the cursors, or else of the window. */
async function saveCsv(scope: Scope): Promise<void> {
  const {context, cursors, now} = scope.shared, seen = scope.window.at(now), range = cursors.b === undefined ? seen : cursors.stretch!;
  const columns = scope.traces.map(({column}) => column).filter((column) => column >= 0);
  try {
    const {csv} = await context.connection.call<{csv: string}>("data.export", {columns, from: Math.max(0, range.low), to: range.high});
    saveFile(`${scope.name || "scope"}.csv`, "text/csv", csv);
  } catch (thrown) {
    context.notify(`no CSV: ${(thrown as Error).message}`, "fault");
  }
}
