// Layout of graphs in a worker, since it may take seconds. A newer order ends an older search.

import ELK from "elkjs/lib/elk-api.js";
import elkAddress from "elkjs/lib/elk-worker.min.js?url";
import {arrangeLike, arrangeRow, draw, piecesOf, relabeled} from "../../../../../view/drawing/draw.mjs";
import type {Answer, Graph, Order, Picture, Shape, Wire} from "./types";

class Stopped extends Error {}

const newElk = () => new ELK({workerFactory: () => new Worker(elkAddress)});
/** Instance for layouts during editing, which must not wait for the search. */
const elk = newElk();
let searcher: ReturnType<typeof newElk> | undefined;
let isSearching = false;
/** Cache of pictures of parts by their graphs, as parts seldom change. */
let known = new Map<string, string>();
const mostKnown = 400;
let newest = 0;

/** Returns an instance of elk for one order; its next layout throws Stopped if a newer order exists. */
const elkOf = (id: number, own = elk) => ({
  layout: (graph: any) => {
    if (id < newest) throw new Stopped();
    return own.layout(graph);
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

function pictureOf(id: number, arranged: any, isRelabeled: boolean): Picture {
  const {frames, wires, forks, blocks} = piecesOf(arranged) as any, {width, height, cost = Infinity} = arranged;
  return {id, isRelabeled, width, height, shapes: [...frames, ...blocks].map(shapeOf), wires: wires.map(wireOf), forks: forks as string, cost};
}

/** Newest pictures with their graphs; the page shows one of them. */
const kept = new Map<number, {graph: Graph; picture: any}>();
const mostKept = 4;

function keep(id: number, graph: Graph, picture: any): void {
  kept.set(id, {graph, picture});
  for (const old of kept.keys()) if (kept.size > mostKept) kept.delete(old);
}

/** Replaces only the words of the previous picture if nothing else has changed; otherwise computes a similar layout. */
async function sketched({id, graph, like}: Order & {want: "sketch"}): Promise<Picture> {
  const before = kept.get(like), same = before && relabeled(before, graph as any), picture = same ?? await arrangeLike(before?.picture.like ?? {}, graph as any, elkOf(id), known);
  keep(id, graph, picture);
  return pictureOf(id, picture, same !== undefined);
}

/** Ends a search within a layout, since that would take a processor from editing. */
function endSearch(): void {
  if (!isSearching) return;
  searcher?.terminateWorker();
  searcher = undefined;
  isSearching = false;
}

async function best(id: number, graph: Graph): Promise<Picture> {
  isSearching = true;
  const picture = await arrangeRow(graph as any, elkOf(id, searcher ??= newElk()), known);
  isSearching = false;
  keep(id, graph, picture);
  return pictureOf(id, picture, false);
}

async function done(order: Order): Promise<Answer> {
  const {id, graph, want} = order;
  if (known.size > mostKnown) known = new Map();
  if (want === "text") return {id, text: await draw(graph, elkOf(id))};
  return {id, picture: want === "sketch" ? await sketched(order) : await best(id, graph)};
}

/** Runs elk until its code is optimised, while the page still waits for its first graph. */
async function warmUp(): Promise<void> {
  const names = Array.from({length: 24}, (_, i) => `w${i}`), node = (id: string) => ({id, name: id, outline: "box", lines: ["w"], inputs: [{port: "u"}], outputs: [{port: "y"}]});
  const wires = names.slice(1).map((id, i) => ({from: {node: names[i % 3 === 0 ? i >> 1 : i], port: "y"}, to: {node: id, port: "u"}}));
  const graph = {inputs: [], outputs: [], nodes: names.map(node), wires} as any, isIdle = () => newest === 0;
  let like: object = {};
  for (let turn = 0; turn < 6 && isIdle(); ++turn) like = (await arrangeLike(like, graph, elk) as any).like;
}

void warmUp();

self.onmessage = async ({data}: MessageEvent<Order>) => {
  newest = data.id;
  endSearch();
  try {
    self.postMessage(await done(data));
  } catch (thrown) {
    self.postMessage({id: data.id, ...(thrown instanceof Stopped ? {stopped: true} : {fault: String((thrown as Error)?.message ?? thrown)})});
  }
};
