/** What may be chosen as the pace of a run: seconds of it in one of the clock; 0 is as fast as it goes. */
export const rates = [0.1, 0.2, 0.5, 1, 2, 5, 10, 0];

export const rateText = (rate: number): string => (rate === 0 ? "fastest" : `${rate}×`);

/** The next faster (1) or slower (-1) one. */
export function nextRate(rate: number, by: 1 | -1): number {
  const at = rates.indexOf(rate);
  return rates[Math.min(rates.length - 1, Math.max(0, (at < 0 ? rates.indexOf(1) : at) + by))];
}

/** "1.00×", "312×"; nothing while it stands. */
export function measuredText(rate: number, isPlaying: boolean): string {
  if (!isPlaying) return "–";
  return `${rate >= 100 ? rate.toFixed(0) : rate >= 10 ? rate.toFixed(1) : rate.toFixed(2)}×`;
}
