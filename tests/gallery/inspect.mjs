// Queries of a page by functions that run in the browser, and queries of a page's text.

export const widths = () => ({content: document.documentElement.scrollWidth, window: document.documentElement.clientWidth});

/** Ratios of width to height: what fits into its box or is cut by it keeps its own. */
export const pictures = async () => {
  const images = [...document.images];
  for (const image of images) image.loading = "eager";
  await Promise.all(images.map((image) => image.decode().catch(() => {})));
  return images.map((image) => {
    const fitted = ["contain", "cover"].includes(getComputedStyle(image).objectFit);
    const natural = image.naturalWidth / image.naturalHeight;
    return {src: image.src, natural, shown: fitted ? natural : image.clientWidth / image.clientHeight};
  });
};

export const links = () => [...document.querySelectorAll("[href], [src]")].map((part) => part.href || part.src);

export const idsTwice = () => {
  const ids = [...document.querySelectorAll("[id]")].map((part) => part.id);
  return ids.filter((id, i) => ids.indexOf(id) !== i);
};

export const headings = () => [...document.querySelectorAll("h1, h2, h3, h4, h5, h6")].map((part) => Number(part.tagName[1]));

/** How many elements of each name there are: one that a parser had to close or to add is one too many or too few. */
export const tagsOfDocument = () => {
  const counts = {};
  for (const part of document.querySelectorAll("*")) counts[part.localName] = (counts[part.localName] ?? 0) + 1;
  return Object.fromEntries(Object.entries(counts).sort());
};

export function tagsOfText(text) {
  const counts = {};
  for (const [, name] of text.matchAll(/<([a-z][a-z0-9]*)[\s>]/g)) counts[name] = (counts[name] ?? 0) + 1;
  return Object.fromEntries(Object.entries(counts).sort());
}

/** Contrast of each text with what is behind it, as WCAG 2 defines it. */
export const contrasts = () => {
  const parts = (color) => color.match(/[\d.]+/g).map(Number);
  const light = ([r, g, b]) => {
    const linear = (c) => (c / 255 <= 0.03928 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4);
    return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  };
  const behind = (part) => {
    for (let at = part; at; at = at.parentElement) {
      const color = parts(getComputedStyle(at).backgroundColor);
      if (color.length === 3 || color[3] === 1) return color;
    }
    return [255, 255, 255];
  };
  const ratio = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  const worst = new Map();
  for (const part of document.body.querySelectorAll("*")) {
    const text = [...part.childNodes].filter((node) => node.nodeType === 3).map((node) => node.data.trim()).join("");
    if (!text) continue;
    const color = getComputedStyle(part).color, back = behind(part), key = `${color} ${back}`;
    if (!worst.has(key)) worst.set(key, {text: text.slice(0, 40), ratio: ratio(light(parts(color)), light(back))});
  }
  return [...worst.values()];
};
