import type {Context} from "../shell/context";

/** Entries of the page's menu for what is seldom needed; each is loaded when it is chosen. */
export function menuEntries(context: Context): [string, () => void][] {
  return [
    ["Examples…", () => void import("./gallery").then(({openGallery}) => openGallery(context))],
    ["Tour", () => void import("../tour/tour").then(({offerTour}) => offerTour(context))],
    ["About and licences", () => void import("./about").then(({openAbout}) => openAbout())],
  ];
}
