// What other panes write into the text: events that bubble from them.

import {isolateHistory} from "@codemirror/commands";
import {Fault} from "../connection/connection";
import type {Context} from "../shell/context";
import {insertedItem, insertedPair} from "./insert_line";

async function insert({workbench, notify}: Context, {section, text}: {section: string; text: string}): Promise<void> {
  const document = await workbench.activate(workbench.root);
  workbench.dispatch(document, {changes: insertedItem(document.state, section, text), userEvent: "input.insert", annotations: isolateHistory.of("full")});
  notify(`a line is added to ${section} of ${document.name}`);
}

/** A linear analysis of the loop through a signal, cut there at the time of the run, and its Bode plot, which follows what is tuned. */
async function addBode({workbench, run, notify, show}: Context, {signal}: {signal: string}): Promise<void> {
  const document = await workbench.activate(workbench.root), {time} = run.news, at = time > 0 ? `, at: ${Number(time.toPrecision(6))} s` : "";
  const {name, changes} = insertedPair(document.state, "linear", "loop", `{from: ${signal}, to: ${signal}, open: ${signal}${at}}`);
  const figure = insertedItem(document.state, "figure", `{plot: bode, of: ${name}, title: The loop cut behind ${signal}}`);
  workbench.dispatch(document, {changes: [changes, figure].flat() as typeof changes[], userEvent: "input.insert", annotations: isolateHistory.of("full")});
  show("figures");
  notify(`a Bode plot of the loop cut behind ${signal} is added to the text; play or From the start (R) draws it`);
}

async function write({workbench, announce}: Context, {name, text}: {name: string; text: string}): Promise<void> {
  await workbench.splice(workbench.root, {kind: "number", name, text});
  announce(`${name} is written as ${text}`);
}

/** Does what panes ask for: `studio:insert` {section, text} adds an item to a list of the file, `studio:bode` {signal} a linear analysis with its plot, `studio:write` {name, text} a value. */
export function serveRequests(context: Context): void {
  const serve = (name: string, action: (context: Context, detail: any) => Promise<void>) => document.addEventListener(name, (event) => {
    event.preventDefault();
    action(context, (event as CustomEvent).detail).catch((thrown) => context.notify(Fault.from(thrown).message, "fault"));
  });
  serve("studio:insert", insert);
  serve("studio:bode", addBode);
  serve("studio:write", write);
}
