import {h} from "../shell/dom";

const unwanted = /[^\p{L}\p{N} ._-]+/gu;

/** Hands a text to the browser as a file to be saved. */
export function saveFile(name: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], {type}));
  const link = h("a", {href: address, download: name.replace(unwanted, "_")});
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
