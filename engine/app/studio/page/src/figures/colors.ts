// Colours of a figure. A spec assumes white paper. On a dark page lines, areas and letters keep their hue; their lightness is mirrored
// until the contrast suffices. Colours that represent values are unchanged.

type Rgb = readonly [number, number, number];

export interface Theme {
  dark: boolean;
  paper: string;
  ink: string; // titles, labels of axes
  ticks: string; // letters of ticks
  frame: string;
  grid: string;
}

export const light: Theme = {dark: false, paper: "#ffffff", ink: "#111111", ticks: "#333333", frame: "#8a8a8a", grid: "#e4e4e4"};
export const dark: Theme = {dark: true, paper: "#16191d", ink: "#eceef0", ticks: "#c4c9cf", frame: "#7f8790", grid: "#30353b"};

/** Returns the components of "#rrggbb", 0 to 255; black for any other text. */
export function rgbOf(color: string): Rgb {
  const number = /^#[0-9a-f]{6}$/i.test(color) ? Number.parseInt(color.slice(1), 16) : 0;
  return [number >> 16, (number >> 8) & 255, number & 255];
}

const hex = (rgb: Rgb) => "#" + rgb.map((one) => Math.round(Math.min(255, Math.max(0, one))).toString(16).padStart(2, "0")).join("");
const toLinear = (one: number) => (one <= 10.31475 ? one / 3294.6 : ((one / 255 + 0.055) / 1.055) ** 2.4);
const fromLinear = (one: number) => 255 * (one <= 0.0031308 ? 12.92 * one : 1.055 * Math.max(one, 0) ** (1 / 2.4) - 0.055);

/** Converts to lightness 0 to 1 and two colour axes: Björn Ottosson, "A perceptual color space for image processing" (Oklab), 2020. */
function oklab(rgb: Rgb): Rgb {
  const [r, g, b] = rgb.map(toLinear) as unknown as Rgb;
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

function fromOklab([lightness, a, b]: Rgb): Rgb {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    fromLinear(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    fromLinear(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    fromLinear(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

const luminance = (color: string) => {
  const [r, g, b] = rgbOf(color).map(toLinear) as unknown as Rgb;
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};

/** Returns the contrast ratio of two colours by WCAG 2, 1 to 21. */
export function contrast(one: string, other: string): number {
  const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

function mirrored(color: string, theme: Theme, least: number): string {
  const [lightness, a, b] = oklab(rgbOf(color));
  const floor = oklab(rgbOf(theme.paper))[0];
  let raised = floor + (1 - lightness) * (0.95 - floor), shown = hex(fromOklab([raised, a, b]));
  while (contrast(shown, theme.paper) < least && raised < 1) shown = hex(fromOklab([(raised += 0.02), a, b]));
  return shown;
}

const kept = new Map<string, string>();

function shown(color: string, theme: Theme, least: number): string {
  if (!theme.dark) return color;
  const key = `${color}${least}${theme.paper}`, known = kept.get(key);
  if (known !== undefined) return known;
  const made = mirrored(color, theme, least);
  kept.set(key, made);
  return made;
}

/** Colours of lines and symbols, of areas, and of letters on the paper of a theme. */
export const lineColor = (color: string, theme: Theme) => shown(color, theme, 3);
export const areaColor = (color: string, theme: Theme) => shown(color, theme, 1);
export const textColor = (color: string, theme: Theme) => shown(color, theme, 4.5);

/** Colour map along the colour axis, with as many steps as gnuplot gets. Stops map shares of the axis to colours. */
export class Palette {
  private static readonly count = 96;
  private readonly colors: string[] = [];
  constructor(stops: readonly { at?: number; color: string }[], private readonly low = 0, private readonly high = 1) {
    for (let i = 0; i < Palette.count; ++i) this.colors.push(between(stops, i / (Palette.count - 1)));
  }
  /** Returns the step of a value; -1 for a missing or non-finite one. */
  step(value: number | null | undefined): number {
    if (value === null || value === undefined || !Number.isFinite(value)) return -1;
    const share = this.high === this.low ? 0 : (value - this.low) / (this.high - this.low);
    return Math.min(Palette.count - 1, Math.max(0, Math.floor(share * Palette.count)));
  }
  color(value: number | null | undefined): string | undefined {
    return this.colors[this.step(value)];
  }
  get all(): readonly string[] {
    return this.colors;
  }
}

function between(stops: readonly { at?: number; color: string }[], share: number): string {
  const after = stops.findIndex(({at = 0}) => at >= share), next = stops[after === -1 ? stops.length - 1 : after];
  const before = stops[Math.max(0, after === -1 ? stops.length - 1 : after - 1)];
  if (!next || !before) return "#000000";
  const [from, to] = [before.at ?? 0, next.at ?? 0], part = to === from ? 0 : (share - from) / (to - from);
  const [a, b] = [rgbOf(before.color), rgbOf(next.color)];
  return hex([0, 1, 2].map((i) => a[i as 0]! + part * (b[i as 0]! - a[i as 0]!)) as unknown as Rgb);
}
