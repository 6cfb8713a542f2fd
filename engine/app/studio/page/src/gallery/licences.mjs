// What the page is made of, for its "about": each package that it depends on, with its licence, as they lie in node_modules.

import {existsSync, readdirSync, readFileSync} from "node:fs";
import {dirname, join} from "node:path";

const name = "virtual:licences", resolved = "\0" + name;
const read = (path) => JSON.parse(readFileSync(path, "utf8"));

/** Where node finds a package from a folder. */
function folderOf(wanted, from) {
  for (let at = from; ; at = dirname(at)) {
    const folder = join(at, "node_modules", wanted);
    if (existsSync(join(folder, "package.json"))) return folder;
    if (at === dirname(at)) throw new Error(`the package '${wanted}' is not installed; ./stepwire setup installs it`);
  }
}

function licenceText(folder) {
  const file = readdirSync(folder).find((one) => /^(licen[cs]e|copying)/i.test(one));
  return file ? readFileSync(join(folder, file), "utf8").trim() : "";
}

/** All packages that a folder's package.json depends on, and those that these depend on, by name. */
export function licencesOf(root) {
  const found = new Map();
  const visit = (folder) => {
    for (const wanted of Object.keys(read(join(folder, "package.json")).dependencies ?? {})) {
      const own = folderOf(wanted, folder), {name: title, version, license} = read(join(own, "package.json"));
      if (found.has(title)) continue;
      found.set(title, {name: title, version, licence: typeof license === "string" ? license : (license?.type ?? "see its text"), text: licenceText(own)});
      visit(own);
    }
  };
  visit(root);
  return [...found.values()].sort((a, b) => a.name.localeCompare(b.name));
}

const file = "assets/licences.json";

/** The module "virtual:licences" of a page, for vite; the texts lie beside the scripts. */
export const licences = (root) => ({
  name: "licences",
  apply: "build",
  resolveId: (id) => (id === name ? resolved : undefined),
  load(id) {
    if (id !== resolved) return undefined;
    this.emitFile({type: "asset", fileName: file, source: JSON.stringify(licencesOf(root))});
    return `export const licences = await (await fetch("/${file}")).json();`;
  },
});
