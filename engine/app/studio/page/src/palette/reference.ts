import type {Connection} from "../connection/connection";

export interface PortReference {
  name: string;
  unit: string;
  doc: string;
  optional?: boolean;
  list?: boolean;
}

export interface ParameterReference {
  name: string;
  kind: string;
  unit: string;
  doc: string;
  required: boolean;
  default?: unknown;
}

/** Block type in the format of `blocks NAME --json`. */
export interface BlockType {
  name: string;
  folder: string;
  doc: string;
  source?: string;
  inputs: PortReference[];
  outputs: PortReference[];
  parameters: ParameterReference[];
  example?: string;
  keys?: string[];
}

/** Formats a default value as in a diagram. */
export const valueText = (value: unknown) => (value === undefined || value === null ? "" : typeof value === "object" ? JSON.stringify(value) : String(value));

let types: Promise<BlockType[]> | undefined;

/** Returns the block types of the program; reads them only once. */
export function blockTypes(connection: Connection): Promise<BlockType[]> {
  types ??= connection.call<{blocks: BlockType[]}>("blocks").then(({blocks}) => blocks);
  types.catch(() => { types = undefined; });
  return types;
}
