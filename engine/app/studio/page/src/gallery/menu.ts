import type {Context} from "../shell/context";

/** Returns the menu entries for rare actions, each of which loads its module when chosen. */
export function menuEntries(context: Context): [string, () => void][] {
  return [
    ["Examples…", () => void import("./gallery").then(({openGallery}) => openGallery(context))],
    ["Tour", () => void import("../tour/tour").then(({offerTour}) => offerTour(context))],
    ["About and licences", () => void import("./about").then(({openAbout}) => openAbout())],
  ];
}
