import {svg} from "../shell/dom";

const paths = {
  play: "M4 2.5v11l9-5.5z",
  pause: "M4 2.5h3v11H4zM9 2.5h3v11H9z",
  tick: "M3 2.5v11l7-5.5zM11.5 2.5h2v11h-2z",
  restart: "M8 2.5a5.5 5.5 0 1 1-5.3 4l1.9.5A3.5 3.5 0 1 0 8 4.5V7L3.8 3.5 8 0z",
  keep: "M7 1.5h2v6h3L8 12 4 7.5h3zM2 10.5h2v2.5h8v-2.5h2v4.5H2z",
  pin: "M5 1.5h6v1.6l-1.2.8V7l2.4 2.2v1.3H8.8v4l-.8 1-.8-1v-4H3.8V9.2L6.2 7V3.9L5 3.1z",
};

/** Returns an icon for a button, whose label is the text for screen readers. */
export function icon(name: keyof typeof paths): SVGElement {
  return svg("svg", {class: "icon", width: 14, height: 14, viewBox: "0 0 16 16", "aria-hidden": "true", fill: "currentColor"}, svg("path", {d: paths[name]}));
}
