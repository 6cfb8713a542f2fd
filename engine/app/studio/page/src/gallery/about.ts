import {openDialog} from "../shell/dialog";
import {h} from "../shell/dom";
import "./gallery.css";

/** Shows the packages of the program and its page, with all licences. */
export async function openAbout(version = ""): Promise<void> {
  const {licences} = await import("virtual:licences");
  const list = licences.map(({name, version: own, licence, text}) =>
    h("details", {class: "licence"}, h("summary", {}, h("strong", {}, name), ` ${own}, ${licence}`), h("pre", {tabindex: 0, "aria-label": `Licence of ${name}`}, text || `The package has no licence text (${licence}).`)));
  openDialog("About the studio", [
    h("p", {}, `Stepwire ${version} runs block diagrams that are written as text. Licence: MIT.`.replace("  ", " ")),
    h("p", {}, "The page runs the program on this computer only; nothing is sent anywhere else. Resistance in a scene is seen, not felt."),
    h("h3", {}, `Third-party packages (${licences.length})`), ...list,
  ]);
}
