// Of several layouts the one that reads best.

import {feedbackEdges} from "./feedback_edges.mjs";
import {inputId, layOut, outputId, portsOf} from "./layout.mjs";
import {enterSums, nameSide, placePorts} from "./ports.mjs";
import {steadied} from "./steady.mjs";
import {costOf} from "./wires.mjs";

const placement = "elk.layered.nodePlacement.strategy", alignment = "elk.layered.nodePlacement.bk.fixedAlignment";
const orderOf = (strategy, seed) => ({"elk.layered.considerModelOrder.strategy": strategy, "elk.randomSeed": seed});
const asInFile = orderOf("PREFER_NODES", "1"), shuffled = orderOf("PREFER_NODES", "2"), free = orderOf("NONE", "2");
const aligned = (side) => ({[placement]: "BRANDES_KOEPF", [alignment]: side});
const compact = {[placement]: "NETWORK_SIMPLEX"};
/**
 * Ways to order the nodes of a column and to place them: first the one that suits small diagrams, then those that find the
 * best picture of large ones most often, and take a third of its time. With a straight chain it is rather the wires to ports
 * of the file and to constants that bend than those between blocks.
 */
const styles = [
  {...asInFile, ...compact}, {...asInFile, ...aligned("LEFTDOWN")}, {...free, ...aligned("RIGHTUP")},
  {...free, ...aligned("LEFTDOWN")}, {...free, ...aligned("LEFTUP")}, {...shuffled, ...aligned("LEFTUP")},
  {...asInFile, ...compact, straightChain: true}, {...free, ...compact},
];
/** What makes one layout three times as fast as the first style, and not worse for more than a few nodes. */
const sketched = {"elk.layered.thoroughness": "1"}, quick = {...free, [placement]: "BRANDES_KOEPF"};
const few = 12;
/** So many layouts that follow each other may find nothing better before the search ends. */
const patience = 2;
/** Ways back that are led below seldom help where the first such layout costs so many times the best one. */
const hopeless = 1.1;

/** Wires back from the right of a block to the left of another, which can be led below. */
function backAround({nodes, back}) {
  const sides = new Map(nodes.flatMap(portsOf).map(({id, side}) => [id, side]));
  return [...back].filter(({from, to}) => sides.get(outputId(from)) === "EAST" && sides.get(inputId(to)) === "WEST");
}

/** A layout with what it costs a reader. */
async function judged(task, elk, style, led) {
  const laid = await layOut(task, elk, style, led);
  return {...laid, style, led, cost: costOf(laid.wires, task.wires.map((wire) => task.back.has(wire)))};
}

const better = (a, b) => (b.cost.total < a.cost.total ? b : a);
const isPerfect = ({cost}) => cost.faults + cost.crossed === 0;

/** The best of several layouts; first all wires are laid out alike, then what leads back to a box is led below. */
async function bestLayout(task, elk) {
  const apart = backAround(task);
  let best = await judged(task, elk, styles[0], new Set());
  const attempt = async (led) => {
    let vain = 0;
    for (const style of styles.slice(1)) {
      if (isPerfect(best) || vain === patience) return;
      const next = await judged(task, elk, style, led);
      if (led.size > 0 && next.cost.total > hopeless * best.cost.total) return;
      vain = next.cost.total < best.cost.total ? 0 : vain + 1;
      best = better(best, next);
    }
  };
  await attempt(new Set());
  if (best.cost.faults > 0 && apart.length > 0) await attempt(new Set(apart));
  return best;
}

const chooseNameSides = (nodes) => nodes.forEach((node) => { node.nameSide = node.name && !node.inner ? nameSide(node) : ""; });

/** How high each wire begins in a layout. */
const startsOf = (wires, laid) => new Map(wires.map((wire, i) => [wire, laid.wires[i].points[0][1]]));
const startsIn = async (task, elk, style) => startsOf(task.wires, await layOut(task, elk, style));

/** The same as an earlier layout had it. */
function startsAsHinted({nodes, wires, hints}) {
  const byId = new Map(nodes.map((node) => [node.id, node]));
  return new Map(wires.map((wire) => [wire, (hints.get(wire.from.node).y ?? 0) + byId.get(wire.from.node).outputs.find(({port}) => port === wire.from.port).y]));
}

/** Lets signals enter sums from where they begin. */
function settleSums({nodes, wires, reversed}, heights) {
  for (const node of nodes) for (const port of node.inputs) delete port.side;
  enterSums(nodes, wires, reversed, heights);
  nodes.forEach(placePorts);
  chooseNameSides(nodes);
}

/** The ports of all nodes, once it is known which wires lead back and which nodes are drawn from right to left; sums by where wires begin. */
async function settlePorts(task, startsOfTask) {
  for (const node of task.nodes) {
    node.flipped = task.flipped.has(node.id);
    for (const port of node.inputs) delete port.side;
    placePorts(node);
  }
  chooseNameSides(task.nodes);
  if (task.nodes.some((node) => node.outline === "circle")) settleSums(task, await startsOfTask(task));
}

/** Puts the ports back to where they are now. */
function keepPorts(nodes) {
  const kept = nodes.map((node) => ({node, flipped: node.flipped, sides: node.inputs.map((port) => port.side)}));
  return () => {
    for (const {node, flipped, sides} of kept) {
      node.flipped = flipped;
      node.inputs.forEach((port, i) => { port.side = sides[i]; });
      placePorts(node);
    }
    chooseNameSides(nodes);
  };
}

const sidesOf = ({nodes}) => nodes.flatMap((node) => node.inputs.map((port) => port.side)).join();

/** In the best layout signals may begin elsewhere than in the first one: where that is better, sums are entered anew. */
async function reenterSums(task, elk, laid) {
  const restore = keepPorts(task.nodes), sides = sidesOf(task);
  settleSums(task, startsOf(task.wires, laid));
  if (sidesOf(task) === sides) return laid;
  const best = better(laid, await judged(task, elk, laid.style, laid.led));
  if (best === laid) restore();
  return best;
}

/** What it costs a reader that a block in a way back is drawn as if it led forward. */
const forwardCost = 4;

/** How large a picture becomes, by one layout. */
export async function sizeOfLayout(nodes, wires, elk) {
  const task = {nodes, wires, ...feedbackEdges(nodes, wires, true)};
  await settlePorts(task, (sized) => startsIn(sized, elk, styles[0]));
  const {width, height} = await layOut(task, elk, styles[0]);
  return {width, height};
}

/** One layout in the style of an earlier one, and close to it where it was one of nearly the same nodes; of none in a quick style. */
async function layOutQuickly(nodes, wires, elk, kept) {
  const {style = nodes.length > few ? quick : styles[0], flips = true, led = false} = kept, soon = {...style, ...sketched};
  const task = {nodes, wires, ...(steadied(nodes, wires, kept) ?? feedbackEdges(nodes, wires, flips))};
  await settlePorts(task, (sized) => (task.hints ? startsAsHinted(sized) : startsIn(sized, elk, soon)));
  return {...await judged(task, elk, soon, new Set(led ? backAround(task) : [])), style, flips};
}

/**
 * Lays out with ways back from right to left; where these find no good place, also without, and takes the better. With
 * `like`, what is kept of an earlier layout (keptOf) or {}, there is no search.
 */
export async function searchLayout(nodes, wires, elk, like) {
  if (like) return layOutQuickly(nodes, wires, elk, like);
  const attempt = async (flip) => {
    const task = {nodes, wires, ...feedbackEdges(nodes, wires, flip)};
    await settlePorts(task, (sized) => startsIn(sized, elk, styles[0]));
    return {flipped: task.flipped, laid: {...await reenterSums(task, elk, await bestLayout(task, elk)), flips: flip}};
  };
  const {flipped, laid: first} = await attempt(true);
  if (first.cost.faults === 0 || flipped.size === 0) return first;
  const restore = keepPorts(nodes), {laid: second} = await attempt(false);
  if (second.cost.total + forwardCost * flipped.size < first.cost.total) return second;
  restore();
  return first;
}
