/** Rates that the user can choose: simulated seconds per second of the clock; 0: as fast as possible. */
export const rates = [0.1, 0.2, 0.5, 1, 2, 5, 10, 0];

export const rateText = (rate: number): string => (rate === 0 ? "fastest" : `${rate}×`);

/** Returns the next faster (1) or slower (-1) rate. */
export function nextRate(rate: number, by: 1 | -1): number {
  const at = rates.indexOf(rate);
  return rates[Math.min(rates.length - 1, Math.max(0, (at < 0 ? rates.indexOf(1) : at) + by))];
}

/** Formats a measured rate: "1.00×", "312×"; "–" while the run is not playing. */
export function measuredText(rate: number, isPlaying: boolean): string {
  if (!isPlaying) return "–";
  return `${rate >= 100 ? rate.toFixed(0) : rate >= 10 ? rate.toFixed(1) : rate.toFixed(2)}×`;
}
