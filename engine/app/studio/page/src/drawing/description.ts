import type {Picture, Shape} from "./types";

const named = (id: string) => id.replace(/^:(input|output|constant):/, "");

/** Describes a shape for screen readers. */
export function describe(shape: Shape, {wires}: Picture): string {
  if (shape.own) return `${shape.own} ${named(shape.id)} of the file`;
  if (shape.id.startsWith(":constant:")) return `constant ${shape.lines.join(" ")}`;
  const sources = [...new Set(wires.filter(({to}) => to?.node === shape.id).map(({from}) => named(from.node)))];
  const sinks = [...new Set(wires.flatMap(({from, to}) => (from.node === shape.id && to ? [named(to.node)] : [])))];
  const kind = `${shape.name || shape.id}, ${shape.isPart ? "part " : ""}${shape.type}`;
  return [kind, sources.length > 0 ? `from ${sources.join(", ")}` : "", sinks.length > 0 ? `to ${sinks.join(", ")}` : ""].filter(Boolean).join("; ");
}
