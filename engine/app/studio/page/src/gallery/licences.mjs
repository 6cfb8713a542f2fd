// List of the packages on which the page depends, with their licences from node_modules, for its "about".

import {existsSync, readdirSync, readFileSync} from "node:fs";
import {dirname, join} from "node:path";

const name = "virtual:licences", resolved = "\0" + name;
const read = (path) => JSON.parse(readFileSync(path, "utf8"));

/** Returns the folder in which node finds a package from another folder. */
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

/** Returns all direct and indirect dependencies of a folder's package.json, by name. */
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

/** Plugin of vite with the module "virtual:licences"; the texts are stored beside the scripts. */
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
