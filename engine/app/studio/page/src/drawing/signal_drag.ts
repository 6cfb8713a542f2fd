// Dragging of a wire or block out of the drawing: the drop target, such as a scope, receives the name of its signal.

import {h, listen} from "../shell/dom";
import type {Places} from "./places";
import type {Shapes} from "./shapes";

/** Returns the signal under the pointer as the run names it, or "". */
function signalOf(target: EventTarget | null, shapes: Shapes, {scope, relative}: {scope: string[]; relative: (id: string) => string[]}): string {
  const wire = shapes.wireOf(target)?.wire, shape = wire ? shapes.find(wire.from.node)?.shape : shapes.of(target)?.shape;
  const port = wire ? wire.from.port : shape?.outputs[0]?.port;
  if (!shape || port === undefined || shape.id.startsWith(":constant:")) return "";
  if (shape.own) return shape.own === "input" ? [...scope, port].join(".") : "";
  const name = [...scope, ...relative(shape.id)].join(".");
  return shape.outputs.length === 1 && !shape.isPart ? name : `${name}.${port}`;
}

/** Starts a drag when a pressed pointer leaves the drawing. Returns a function that removes the listeners. */
export function dragSignals(canvas: HTMLElement, shapes: Shapes, places: Places): () => void {
  return listen(canvas, "pointerdown", (event: PointerEvent) => {
    const signal = event.button === 0 && !canvas.classList.contains("connecting") ? signalOf(event.target, shapes, {scope: places.scope, relative: (id) => places.relative(id)}) : "";
    if (signal) follow(canvas, signal);
  });
}

function follow(canvas: HTMLElement, signal: string): void {
  const label = h("div", {class: "dragged-signal"}, signal), isInside = ({clientX: x, clientY: y}: PointerEvent) => {
    const {left, right, top, bottom} = canvas.getBoundingClientRect();
    return x >= left && x <= right && y >= top && y <= bottom;
  };
  const ends = [
    listen(document, "pointermove", (event: PointerEvent) => {
      if (isInside(event) || canvas.classList.contains("connecting")) return label.remove();
      document.body.append(label);
      label.style.setProperty("transform", `translate(${event.clientX + 12}px, ${event.clientY + 12}px)`);
    }),
    listen(document, "pointerup", (event: PointerEvent) => { stop(); if (label.isConnected) drop(event, signal); label.remove(); }),
    listen(document, "pointercancel", () => { stop(); label.remove(); }),
  ];
  const stop = () => ends.forEach((end) => end());
}

/** Dispatches the drop of a text to the element under the pointer. */
function drop({clientX, clientY}: PointerEvent, signal: string): void {
  const dataTransfer = new DataTransfer();
  dataTransfer.setData("text/plain", signal);
  document.elementFromPoint(clientX, clientY)?.dispatchEvent(new DragEvent("drop", {bubbles: true, cancelable: true, clientX, clientY, dataTransfer}));
}
