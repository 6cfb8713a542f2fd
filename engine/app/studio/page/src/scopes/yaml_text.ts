// Texts that go into a diagram file.

const plain = /^[A-Za-z(][^:#{}[\],&*!|>'"%@`\n\t\\]*$/;
const words = /^(true|false|null|yes|no|on|off|~)$/i;

/** A text as a scalar of a flow mapping, quoted where YAML would read anything else into it. */
export function yamlScalar(text: string): string {
  return plain.test(text) && !words.test(text) && text.trim() === text ? text : JSON.stringify(text);
}

/** `{a: 1, b: [x, y]}` of texts that are scalars already. */
export function flowMapping(entries: [string, string | string[] | undefined][]): string {
  const parts = entries.filter(([, value]) => value !== undefined)
    .map(([key, value]) => `${key}: ${Array.isArray(value) ? (value.length === 1 ? value[0] : `[${value.join(", ")}]`) : value}`);
  return `{${parts.join(", ")}}`;
}
