import {h} from "../shell/dom";
import {type BlockType, type ParameterReference, type PortReference, valueText} from "./reference";

/** Returns a text with the words between backticks as code. */
const rich = (text: string): (Node | string)[] => text.split("`").map((piece, i) => (i % 2 === 1 ? h("code", {}, piece) : piece));

function ports(title: string, all: PortReference[]): (HTMLElement | null)[] {
  if (all.length === 0) return [];
  return [h("h4", {}, title), h("dl", {}, ...all.flatMap(({name, unit, doc, optional, list}) =>
    [h("dt", {}, name, unit ? ` [${unit}]` : "", list ? ", several" : "", optional ? ", optional" : ""), h("dd", {}, ...rich(doc))]))];
}

function parameters(all: ParameterReference[]): (HTMLElement | null)[] {
  if (all.length === 0) return [];
  return [h("h4", {}, "Parameters"), h("dl", {}, ...all.flatMap(({name, kind, unit, doc, required, default: other}) =>
    [h("dt", {}, name, unit ? ` [${unit}]` : "", required ? ", required" : valueText(other) ? ` = ${valueText(other)}` : ""), h("dd", {}, ...rich(doc), ` (${kind})`)]))];
}

/** Returns the reference page of a block type. */
export function referencePage({name, doc, source, inputs, outputs, parameters: own, example}: BlockType): Node[] {
  const parts = [h("h3", {}, name), h("p", {}, ...rich(doc)), example ? h("pre", {}, example) : null, ...ports("Inputs", inputs), ...ports("Outputs", outputs), ...parameters(own),
    source ? h("p", {class: "palette-source"}, `Source: ${source}`) : null];
  return parts.filter((part): part is HTMLElement => part !== null);
}
