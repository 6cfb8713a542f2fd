// Lays out graphs beside the page: a layout may take seconds. A newer order stops an older search before its next layout.

import ELK from "elkjs/lib/elk-api.js";
import elkAddress from "elkjs/lib/elk-worker.min.js?url";
import {arrange, arrangeLike, draw, piecesOf} from "../../../../../view/drawing/draw.mjs";
import type {Answer, Order, Picture, Shape, Wire} from "./types";

class Stopped extends Error {}

const elk = new ELK({workerFactory: () => new Worker(elkAddress)});
/** Pictures of parts, by their graphs: they seldom change. */
let known = new Map<string, string>();
const mostKnown = 400;
let newest = 0;

/** elk for one order. */
const elkOf = (id: number) => ({
  layout: (graph: any) => {
    if (id < newest) throw new Stopped();
    return elk.layout(graph);
  },
});

const portOf = ({port, x, y, unit}: any) => ({port, x: x ?? 0, y: y ?? 0, unit});

function shapeOf({block, svg}: {block: any; svg: string}): Shape {
  const {id, name = "", type = "", x, y, width, height, own = "", part, inner, lines = [], within = [], inputs, outputs} = block;
  return {id, name, type, x, y, width, height, own, isPart: Boolean(part), isFrame: Boolean(inner), lines, within, inputs: inputs.map(portOf), outputs: outputs.map(portOf), svg};
}

function wireOf({wire, svg}: {wire: any; svg: string}): Wire {
  return {from: wire.from, to: wire.to ?? null, within: wire.within ?? [], unit: wire.unit ?? "", points: wire.points, svg};
}

function pictureOf(arranged: any): Picture {
  const {frames, wires, forks, blocks} = piecesOf(arranged) as any, {width, height, style, flips, cost = Infinity} = arranged;
  return {width, height, shapes: [...frames, ...blocks].map(shapeOf), wires: wires.map(wireOf), forks: forks as string, like: {style, flips}, cost};
}

async function done(order: Order): Promise<Answer> {
  const {id, graph} = order, own = elkOf(id);
  if (known.size > mostKnown) known = new Map();
  if (order.want === "text") return {id, text: await draw(graph, own)};
  const arranged = order.like ? await arrangeLike(order.like, graph as any, own, known) : await arrange(graph as any, own, known);
  return {id, picture: pictureOf(arranged)};
}

self.onmessage = async ({data}: MessageEvent<Order>) => {
  newest = data.id;
  try {
    self.postMessage(await done(data));
  } catch (thrown) {
    self.postMessage({id: data.id, ...(thrown instanceof Stopped ? {stopped: true} : {fault: String((thrown as Error)?.message ?? thrown)})});
  }
};
