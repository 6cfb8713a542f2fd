// Light or dark theme: the system's choice, or the user's.

export type Choice = "system" | "light" | "dark";

export class Theme {
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");
  private readonly listeners = new Set<() => void>();
  private own: Choice = "system";

  constructor() {
    this.dark.addEventListener("change", () => this.show());
    this.show();
  }

  get choice(): Choice {
    return this.own;
  }

  choose(choice: Choice): void {
    this.own = choice;
    this.show();
  }

  get isDark(): boolean {
    return this.own === "system" ? this.dark.matches : this.own === "dark";
  }

  /** True if the user prefers reduced motion. */
  get isStill(): boolean {
    return this.still.matches;
  }

  /** Returns the value of a token such as "--ink", for canvases. */
  token(name: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  }

  /** Adds a listener for changes of colours. Returns a function that removes it. */
  on(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  private show(): void {
    document.documentElement.dataset.theme = this.isDark ? "dark" : "light";
    for (const listener of [...this.listeners]) listener();
  }
}
