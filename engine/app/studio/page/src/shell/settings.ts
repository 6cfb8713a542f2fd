// Settings that persist between visits: one JSON per FILE in the user's state folder, through the server.

import type {Connection} from "../connection/connection";

const quiet = 500;  // ms without a change before it is written

export class Settings {
  private state: Record<string, unknown> = {};
  private timer: number | undefined;
  private readonly listeners = new Set<(key: string) => void>();

  constructor(private readonly connection: Connection) {}

  /** Reads the stored settings; values that were set here before take precedence. */
  async load(): Promise<void> {
    const {state} = await this.connection.call<{state: Record<string, unknown> | null}>("state.get");
    this.state = {...(state ?? {}), ...this.state};
    for (const key of Object.keys(this.state)) this.changed(key);
  }

  get<T>(key: string, otherwise: T): T {
    return (this.state[key] as T | undefined) ?? otherwise;
  }

  set(key: string, value: unknown): void {
    this.state[key] = value;
    this.changed(key);
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.write(), quiet);
  }

  /** Adds a listener that gets the key of each changed value. Returns a function that removes it. */
  on(listener: (key: string) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  private changed(key: string): void {
    for (const listener of [...this.listeners]) listener(key);
  }

  private write(): void {
    this.connection.call("state.put", {state: this.state}).catch(() => {});  // the next change retries
  }
}
