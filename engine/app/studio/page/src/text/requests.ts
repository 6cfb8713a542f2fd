// What other panes write into the text: events that bubble from them.

import {isolateHistory} from "@codemirror/commands";
import {Fault} from "../connection/connection";
import type {Context} from "../shell/context";
import {insertedItem} from "./insert_line";

async function insert({workbench, notify}: Context, {section, text}: {section: string; text: string}): Promise<void> {
  const document = await workbench.activate(workbench.root);
  workbench.dispatch(document, {changes: insertedItem(document.state, section, text), userEvent: "input.insert", annotations: isolateHistory.of("full")});
  notify(`a line is added to ${section} of ${document.name}`);
}

async function write({workbench, announce}: Context, {name, text}: {name: string; text: string}): Promise<void> {
  await workbench.splice(workbench.root, {kind: "number", name, text});
  announce(`${name} is written as ${text}`);
}

/** Does what panes ask for: `studio:insert` {section, text} adds an item to a list of the file, `studio:write` {name, text} a value. */
export function serveRequests(context: Context): void {
  const serve = (name: string, action: (context: Context, detail: any) => Promise<void>) => document.addEventListener(name, (event) => {
    event.preventDefault();
    action(context, (event as CustomEvent).detail).catch((thrown) => context.notify(Fault.from(thrown).message, "fault"));
  });
  serve("studio:insert", insert);
  serve("studio:write", write);
}
