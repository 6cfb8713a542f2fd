import {h} from "../shell/dom";

const unwanted = /[^\p{L}\p{N} ._-]+/gu;

/** Starts a download of a text as a file. */
export function saveFile(name: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], {type}));
  const link = h("a", {href: address, download: name.replace(unwanted, "_")});
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
