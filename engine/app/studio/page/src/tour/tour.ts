import {Fault} from "../connection/connection";
import {startFrom} from "../gallery/gallery";
import type {Entry} from "../gallery/search";
import type {Context} from "../shell/context";
import {openDialog} from "../shell/dialog";
import {h} from "../shell/dom";
import {markSeen, wasSeen} from "./seen";
import {stops} from "./stops";
import {TourCard} from "./tour_card";
import "./tour.css";

const example = "01-first-diagram";

/** Offers the tour once, at the first visit. */
export async function tourOnFirstVisit(context: Context): Promise<void> {
  if (!(await wasSeen(context))) await offerTour(context);
}

/** Offers the tour with example 01 or with the open diagram. */
export async function offerTour(context: Context): Promise<void> {
  const entries = await context.connection.call<{entries: Entry[]}>("gallery").then(({entries}) => entries, () => []);
  const first = entries.find(({name}) => name.includes(example));
  const isOpen = context.workbench.nameOf(context.workbench.root).includes(example);
  const choose = (text: string, isMain: boolean, action: () => void) => h("button", {type: "button", class: isMain ? "main" : "plain", autofocus: isMain, onclick: action}, text);
  openDialog("A short tour?", [h("p", {}, `${stops.length} steps, one minute: text, drawing, run, scopes and tuning.`)], (close) => [
    choose("Dismiss", false, close), choose("With this diagram", !first || isOpen, () => { close(); startTour(context); }),
    ...(first && !isOpen ? [choose("With a copy of example 01", true, () => { close(); void begin(context, first); })] : []),
  ], () => void markSeen(context));
}

async function begin(context: Context, first: Entry): Promise<void> {
  try {
    await startFrom(context, first, `${example}.yaml`);
  } catch (thrown) {
    context.notify(`example 01 was not copied: ${Fault.from(thrown).message}. The tour shows your diagram.`);
  }
  startTour(context);
}

export function startTour(context: Context): void {
  new TourCard(context, stops).show(0);
}
