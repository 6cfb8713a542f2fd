// Texts for insertion into a diagram file.

const plain = /^[A-Za-z(][^:#{}[\],&*!|>'"%@`\n\t\\]*$/;
const words = /^(true|false|null|yes|no|on|off|~)$/i;

/** Returns a text as a scalar of a flow mapping, quoted if YAML would interpret it otherwise. */
export function yamlScalar(text: string): string {
  return plain.test(text) && !words.test(text) && text.trim() === text ? text : JSON.stringify(text);
}

/** Returns `{a: 1, b: [x, y]}` from texts that are valid scalars. */
export function flowMapping(entries: [string, string | string[] | undefined][]): string {
  const parts = entries.filter(([, value]) => value !== undefined)
    .map(([key, value]) => `${key}: ${Array.isArray(value) ? (value.length === 1 ? value[0] : `[${value.join(", ")}]`) : value}`);
  return `{${parts.join(", ")}}`;
}
