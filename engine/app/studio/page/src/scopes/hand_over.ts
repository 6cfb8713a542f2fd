import type {Context} from "../shell/context";

/** Copies a text to the clipboard; if the browser refuses, it shows the text for copying. */
export async function copyText(context: Context, text: string, what: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    context.notify(`copied: ${what}`);
  } catch {
    context.notify(text);
  }
}

/** Offers an item of a section to the text by the event `studio:insert`; copies it if no listener handles the event. */
export function insertText(from: HTMLElement, context: Context, section: "claims" | "figure", text: string): void {
  const isOpen = from.dispatchEvent(new CustomEvent("studio:insert", {bubbles: true, cancelable: true, detail: {section, text}}));
  if (isOpen) void copyText(context, `- ${text}`, `an item of ${section}`);
}
