import type {Context} from "../shell/context";

const key = "tour.seen";

/** Returns whether the tour was shown to this user. It is stored for the user if the server can do so, else with the file. */
export async function wasSeen({connection, settings}: Context): Promise<boolean> {
  if (settings.get(key, false)) return true;
  const kept = await connection.call<{state: Record<string, unknown> | null}>("user.get").catch(() => null);
  return Boolean(kept?.state?.[key]);
}

export async function markSeen({connection, settings}: Context): Promise<void> {
  settings.set(key, true);
  const kept = await connection.call<{state: Record<string, unknown> | null}>("user.get").catch(() => null);
  if (kept) await connection.call("user.put", {state: {...kept.state, [key]: true}}).catch(() => {});
}
