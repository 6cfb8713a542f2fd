// Requests of other panes to insert lines and values into the text. The server computes the changes from the tree of the text.

import {Fault} from "../connection/connection";
import type {Context} from "../shell/context";

async function insert({workbench, notify}: Context, {section, text}: {section: string; text: string}): Promise<void> {
  const document = await workbench.activate(workbench.root);
  await workbench.splice(document.file, {kind: "item", section, text});
  notify(`a line is added to ${section} of ${document.name}`);
}

/** Adds a linear analysis of the loop through a signal, cut there at the time of the run, and its Bode plot. The plot follows live parameters. */
async function addBode({workbench, run, notify, show}: Context, {signal}: {signal: string}): Promise<void> {
  const document = await workbench.activate(workbench.root), {time} = run.news;
  await workbench.splice(document.file, {kind: "bode", signal, ...(time > 0 ? {at: `${Number(time.toPrecision(6))} s`} : {})});
  show("figures");
  notify(`a Bode plot of the loop opened at ${signal} is added to the text; Play or Restart (R) draws it`);
}

async function write({workbench, announce}: Context, {name, text}: {name: string; text: string}): Promise<void> {
  await workbench.splice(workbench.root, {kind: "number", name, text});
  announce(`${name} is written as ${text}`);
}

/**
 * Serves the requests of panes. `studio:insert` {section, text} adds an item to a list of the file, `studio:bode` {signal} a linear
 * analysis with its plot, `studio:write` {name, text} a value.
 */
export function serveRequests(context: Context): void {
  const serve = (name: string, action: (context: Context, detail: any) => Promise<void>) => document.addEventListener(name, (event) => {
    event.preventDefault();
    action(context, (event as CustomEvent).detail).catch((thrown) => context.notify(Fault.from(thrown).message, "fault"));
  });
  serve("studio:insert", insert);
  serve("studio:bode", addBode);
  serve("studio:write", write);
}
