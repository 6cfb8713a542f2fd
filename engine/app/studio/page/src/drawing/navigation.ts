import type {Placed} from "./shapes";

const middle = ({shape: {x, y, width, height}}: Placed) => [x + width / 2, y + height / 2] as const;
const directions: Record<string, readonly [number, number]> = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

/** Returns the next shape in the direction of an arrow key; without a present shape the leftmost one. */
export function nextShape(all: Placed[], now: Placed | undefined, key: string): Placed | undefined {
  const direction = directions[key];
  if (!direction || all.length === 0) return undefined;
  if (!now) return [...all].sort((a, b) => a.shape.x - b.shape.x || a.shape.y - b.shape.y)[0];
  const [x, y] = middle(now), [dx, dy] = direction;
  const ranked = all.filter((one) => one !== now).map((one) => {
    const [u, v] = middle(one), along = (u - x) * dx + (v - y) * dy, across = Math.abs((u - x) * dy) + Math.abs((v - y) * dx);
    return {one, along, cost: along + 2.5 * across};
  }).filter(({along, cost}) => along > 2 && cost < 4 * along + 40);
  return ranked.sort((a, b) => a.cost - b.cost)[0]?.one;
}
