// Graphs after single edits of a graph, as in a drawing, each with the affected blocks.

const inputsOf = (graph) => graph.nodes.flatMap(({id, inputs}) => inputs.map(({port}) => ({node: id, port})));
const key = ({node, port}) => `${node} ${port}`;
const gain = (id) => ({id, name: id, type: "Gain", outline: "triangle", lines: ["2"], inputs: [{port: "u"}], outputs: [{port: "y"}]});
const isBlock = (end) => Boolean(end.node);

function* deletions(graph) {
  for (const {id} of graph.nodes)
    yield {what: `delete ${id}`, own: [id], graph: {...graph, nodes: graph.nodes.filter((node) => node.id !== id), wires: graph.wires.filter(({from, to}) => from.node !== id && to.node !== id)}};
}

/** Inserts a new block before the sink of each wire. */
function* insertions(graph) {
  for (const [i, wire] of graph.wires.entries()) {
    if (wire.from.constant !== undefined) continue;
    const wires = [...graph.wires.slice(0, i), {...wire, to: {node: "new", port: "u"}}, {from: {node: "new", port: "y"}, to: wire.to}, ...graph.wires.slice(i + 1)];
    yield {what: `insert before ${key(wire.to)}`, own: ["new"], graph: {...graph, nodes: [...graph.nodes, gain("new")], wires}};
  }
}

/** Adds a new block behind each block, without a sink. */
function* additions(graph) {
  for (const {id, outputs} of graph.nodes)
    if (outputs.length > 0) yield {what: `add behind ${id}`, own: ["new"], graph: {...graph, nodes: [...graph.nodes, gain("new")], wires: [...graph.wires, {from: {node: id, port: outputs[0].port}, to: {node: "new", port: "u"}}]}};
}

function* disconnections(graph) {
  for (const [i, wire] of graph.wires.entries())
    yield {what: `disconnect ${key(wire.to)}`, own: [], graph: {...graph, wires: graph.wires.filter((_, k) => k !== i)}};
}

/** Connects each input to another block's first output; removes its previous wire. */
function* connections(graph) {
  for (const input of inputsOf(graph))
    for (const {id, outputs} of graph.nodes) {
      const from = {node: id, port: outputs[0]?.port}, old = graph.wires.find(({to}) => key(to) === key(input));
      if (!from.port || id === input.node || (old && isBlock(old.from) && key(old.from) === key(from))) continue;
      yield {what: `connect ${key(from)} to ${key(input)}`, own: [id, input.node], graph: {...graph, wires: [...graph.wires.filter((wire) => wire !== old), {from, to: input}]}};
    }
}

/** Changes a number to a long one: no block, port or wire changes. */
function* relabels(graph) {
  for (const [i, node] of graph.nodes.entries())
    if (node.outline === "box" && node.lines.length > 0)
      yield {what: `relabel ${node.id}`, own: [], graph: {...graph, nodes: graph.nodes.map((one, k) => (k === i ? {...one, lines: ["12345.678 N/mm"]} : one))}};
}

export const kinds = {deletions, insertions, additions, disconnections, connections, relabels};
