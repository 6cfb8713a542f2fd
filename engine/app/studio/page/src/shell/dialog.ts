import {h} from "./dom";

/** Opens a dialog with a title. Esc, its cross or a button of `foot` closes it; `closed` runs once afterwards. */
export function openDialog(title: string, body: (Node | string)[], foot: (close: () => void) => Node[] = () => [], closed: () => void = () => {}): HTMLDialogElement {
  const dialog = h("dialog", {"aria-label": title});
  const close = () => dialog.close();
  const buttons = foot(close);
  dialog.append(
    h("div", {class: "dialog-head"}, h("h2", {}, title), h("button", {type: "button", class: "plain", "aria-label": "Close", onclick: close}, "×")),
    h("div", {class: "dialog-body"}, ...body), buttons.length > 0 ? h("div", {class: "dialog-foot"}, ...buttons) : "");
  dialog.addEventListener("close", () => {
    dialog.remove();
    closed();
  });
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}
