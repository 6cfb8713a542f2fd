#pragma once

namespace stepwire::gallery {

/// Style sheet of the gallery: system fonts, light and dark, for widths from 320 px.
inline constexpr const char* gallery_style = R"css(:root {
  color-scheme: light dark;
  --page: #f7f7f5; --card: #ffffff; --text: #1d2226; --soft: #59636b; --line: #dfe2e4; --link: #0b5c9c;
  --good: #1a7038; --known: #835400; --bad: #b3261e; --quote: #8aa4b8;
  --key: #0b5c9c; --comment: #5f6b58; --string: #1f6f43; --number: #9a4a00; --name: #7a3fa0; --type: #9c2a55;
  --sans: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  --serif: Charter, "Bitstream Charter", "Iowan Old Style", Georgia, "DejaVu Serif", serif;
  --mono: ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #101214; --card: #191919; --text: #e4e8ea; --soft: #a2adb5; --line: #353c42; --link: #82c2f3;
    --good: #74d191; --known: #e6b866; --bad: #ff9188; --quote: #58718a;
    --key: #82c2f3; --comment: #97a391; --string: #8ad0a4; --number: #f0b37e; --name: #cda6ec; --type: #f29bbb;
  }
  img.plain, .plain img { filter: invert(.88) hue-rotate(180deg); }
}
* { box-sizing: border-box; }
html { scroll-padding-top: 4rem; }
body { margin: 0; background: var(--page); color: var(--text); font: 1rem/1.55 var(--sans); overflow-wrap: anywhere; }
main { max-width: calc(1400px + 3rem); margin: 0 auto; padding: 1.5rem 1.5rem 4rem; outline: none; }
a { color: var(--link); text-underline-offset: .15em; }
a:focus-visible, summary:focus-visible, button:focus-visible, input:focus-visible, pre:focus-visible, .frame:focus-visible {
  outline: 3px solid var(--link); outline-offset: 2px; border-radius: 4px;
}
h1 { font-size: clamp(1.5rem, 1.1rem + 1.6vw, 2.1rem); line-height: 1.2; margin: 0 0 .6rem; font-weight: 650; text-wrap: balance; }
h1 .label { color: var(--soft); font-weight: 450; margin-right: .3em; }
h2 { font-size: 1.2rem; line-height: 1.3; margin: 0 0 .6rem; font-weight: 650; }
h3 { font-size: 1rem; margin: 0 0 .6rem; color: var(--soft); font-weight: 600; }
p { margin: 0 0 .75rem; }
section { margin-top: 2.75rem; }
code { font: .86em/1.5 var(--mono); }
em { color: var(--soft); }
.soft, .count { color: var(--soft); }
.lead { max-width: 46rem; color: var(--soft); }
.chapter-summary { max-width: 46rem; margin: 0 0 1.25rem; }
.chapter-summary h4 { margin: 0 0 .4rem; }
.skip { position: absolute; left: -100rem; }
.skip:focus { left: 1rem; top: 1rem; z-index: 3; background: var(--card); padding: .5rem 1rem; }
.summary { display: inline-block; font-weight: 600; border-left: 4px solid; padding: .4rem .9rem; background: var(--card); margin: .25rem 0 0; border-radius: 0 6px 6px 0; }
.good.summary, .good .verdict { color: var(--good); }
.known.summary, .known .verdict { color: var(--known); }
.bad.summary, .bad .verdict, .error { color: var(--bad); }
.good > .verdict::before, .good a > .verdict::before { content: "✓ "; content: "✓ " / ""; }
.known > .verdict::before, .known a > .verdict::before { content: "≠ "; content: "≠ " / ""; }
.bad > .verdict::before, .bad a > .verdict::before { content: "✗ "; content: "✗ " / ""; }
.error { white-space: pre-wrap; }
table { border-collapse: collapse; width: 100%; font-size: .92rem; }
th, td { text-align: left; padding: .4rem .8rem .4rem 0; border-top: 1px solid var(--line); vertical-align: top; }
thead th { border-top: 0; color: var(--soft); font-weight: 600; }
summary { cursor: pointer; }
details[open] > summary { margin-bottom: .6rem; }

.findings { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 1fr)); margin-top: 1.75rem; align-items: start; }
.finding { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: .9rem 1.1rem; min-width: 0; }
.finding[open] { grid-column: 1 / -1; }
.finding h2 { display: inline; font-size: 1.02rem; }
.finding .count { font-size: .92rem; white-space: nowrap; }
.by-entry { margin: 0; max-width: 62rem; }
.by-entry dt { margin-top: 1rem; font-weight: 600; }
.by-entry dd { margin: 0; }
.by-entry ul, #unexpected ul { margin: .25rem 0 0; padding-left: 1.2rem; }
.by-entry li { margin-bottom: .4rem; }
#unexpected { border-left: 4px solid var(--bad); padding-left: 1rem; margin-top: 1.5rem; }

.chapter { margin-top: 1.5rem; }
.chapter .head { display: flex; flex-wrap: wrap; gap: 0 1.25rem; align-items: baseline; }
.chapter .head p { margin: 0; font-size: .92rem; }
.chapter[hidden], .card[hidden] { display: none; }
.cards { list-style: none; margin: 0; padding: 0; display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(min(15rem, 100%), 1fr)); }
.card a { display: block; height: 100%; padding: .8rem .9rem .9rem; background: var(--card); border: 1px solid var(--line); border-radius: 10px; color: inherit; text-decoration: none; }
.card a:hover { border-color: var(--link); }
.card a:hover .title { text-decoration: underline; }
.thumb { display: block; aspect-ratio: 4 / 3; margin-bottom: .6rem; }
.thumb img { display: block; width: 100%; height: 100%; object-fit: contain; border-radius: 4px; }
.thumb.wide img { object-fit: cover; object-position: left; }
.thumb.dense { overflow: hidden; }
.thumb.dense img { width: 220%; height: 220%; object-fit: cover; object-position: left top; }
.card .label { font-weight: 650; }
.card .verdict { display: block; font-size: .88rem; font-weight: 600; margin-top: .2rem; }
.search { display: flex; flex-wrap: wrap; gap: .6rem; align-items: center; margin: 0 0 1rem; }
.search input { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--soft); border-radius: 8px; padding: .45rem .75rem; width: min(24rem, 100%); }
.search button, .tools button { font: inherit; font-size: .92rem; color: var(--text); background: var(--card); border: 1px solid var(--soft); border-radius: 999px; padding: .3rem .85rem; cursor: pointer; }
.search button[aria-pressed="true"] { background: var(--link); border-color: var(--link); color: var(--page); }

.bar { position: sticky; top: 0; z-index: 2; display: grid; grid-template-columns: 1fr auto 1fr; gap: .5rem; align-items: center; padding: .55rem 1.5rem; background: var(--page); border-bottom: 1px solid var(--line); }
.bar a { text-decoration: none; padding: .2rem 0; }
.bar a:hover { text-decoration: underline; }
.bar .next { text-align: right; }
.source .bar, main .bar { position: static; padding: 1rem 0 0; margin-top: 3rem; border: 0; border-top: 1px solid var(--line); }
.source .bar { margin: 0 auto; padding: .55rem 1.5rem; border-top: 0; }
.place { color: var(--soft); margin: 0 0 .25rem; font-size: .95rem; }
.place-of-picture { margin-top: 1.5rem; }
.picture { margin: 0; }
.frame { position: relative; background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: .75rem; overflow: hidden; }
.frame img { display: block; max-width: 100%; height: auto; margin: 0 auto; }
.enlarge { position: absolute; inset: 0; cursor: zoom-in; border-radius: 10px; }
.enlarge span { position: absolute; right: .6rem; bottom: .5rem; font-size: .85rem; padding: .15rem .6rem; background: var(--card); border-radius: 6px; border: 1px solid var(--line); opacity: 0; }
.enlarge:hover span, .enlarge:focus-visible span { opacity: 1; }
.reduce { display: none; margin: 0 0 .5rem; width: fit-content; }
.picture:target .frame { overflow: auto; max-height: calc(100vh - 8rem); cursor: grab; overscroll-behavior: contain; }
.picture:target .frame.held { cursor: grabbing; user-select: none; }
.picture:target img { width: max(var(--wide), min(200%, 2 * var(--wide))); max-width: none; }
.picture:target .enlarge { display: none; }
.picture:target .reduce { display: block; }
figcaption { margin: .6rem 0 0; max-width: 62rem; color: var(--soft); }
figcaption strong { color: var(--text); font-weight: 600; }
.beside { display: grid; gap: 1rem 3rem; grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); }
.beside section { margin-top: 2rem; max-width: 44rem; }
.beside + section { margin-top: 2rem; }
blockquote { margin: 0; padding-left: 1rem; border-left: 3px solid var(--quote); font-family: var(--serif); font-size: 1.06rem; }
blockquote .caption { font-style: italic; }
.departure::before { content: "Departure: "; color: var(--known); font-weight: 600; }
.claims { list-style: none; margin: 0; padding: 0; max-width: 62rem; }
.claims li { padding: .55rem 0; border-top: 1px solid var(--line); }
.claims li > code, .claims li > em { display: block; color: var(--soft); }
.claims .verdict { font-weight: 600; margin-right: .35rem; }
.claims .value { font-weight: 600; }
.claims .value::before { content: "→ "; content: "→ " / ""; color: var(--soft); font-weight: 400; }
.downloads { display: grid; grid-template-columns: max-content 1fr; gap: .4rem 1.5rem; margin: 0; }
.downloads dt { color: var(--soft); }
.downloads dd { margin: 0; min-width: 0; }
.yaml { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 1rem; margin: 0; overflow-x: auto; tab-size: 2; overflow-wrap: normal; }
.yaml .key { color: var(--key); } .yaml .comment { color: var(--comment); } .yaml .string { color: var(--string); }
.yaml .number { color: var(--number); } .yaml .name { color: var(--name); } .yaml .type { color: var(--type); font-weight: 600; }
@media (max-width: 700px) {
  main { padding: 1rem 1rem 3rem; }
  .bar { padding: .5rem 1rem; font-size: .95rem; }
  .frame { padding: .35rem; }
  .downloads { display: block; } .downloads dd { margin-bottom: .6rem; }
  .yaml { white-space: pre-wrap; overflow-wrap: anywhere; padding: .75rem; }
  .cards { grid-template-columns: repeat(auto-fill, minmax(min(10.5rem, 100%), 1fr)); gap: .7rem; }
  .assumed thead { display: none; }
  .assumed tr { display: block; border-top: 1px solid var(--line); padding: .4rem 0; }
  .assumed td { display: block; border: 0; padding: 0; }
}
@media print {
  body { background: #fff; }
  .bar, .search, .tools, .enlarge, .reduce { display: none !important; }
  #downloads, #diagram { display: none; }
  .place-of-picture, .picture, .card, .claims li, .departure, tr { break-inside: avoid; }
  .frame { border: 0; padding: 0; }
  .frame img { max-height: 20cm; width: auto; }
  figcaption, h1, h2, h3 { break-after: avoid; } figcaption { break-before: avoid; break-after: auto; }
  .cards { grid-template-columns: repeat(3, 1fr); }
}
)css";

/// Script of the gallery: search, keyboard, panning of enlarged pictures, and PNG export.
inline constexpr const char* gallery_script = R"js('use strict';

const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

// --- the front page: search and filters ---

const filters = {disagrees: 'disagrees with the text', departures: 'has departures', fails: 'ends unexpectedly', table: 'tables'};

function addSearch(place) {
  const cards = [...document.querySelectorAll('.card')];
  const texts = new Map(cards.map(card => [card, (card.textContent + ' ' + card.dataset.words).toLowerCase()]));
  const input = element('input', {type: 'search', id: 'find', placeholder: 'Search figures, claims, departures  ( / )'});
  input.setAttribute('aria-label', 'Search figures and tables');
  const count = element('output', {className: 'soft', htmlFor: 'find'});
  const present = Object.keys(filters).filter(trait => cards.some(card => card.dataset.traits.split(' ').includes(trait)));
  const buttons = present.map(trait => {
    const button = element('button', {type: 'button', textContent: filters[trait]});
    button.dataset.trait = trait;
    button.onclick = () => { press(button, button.getAttribute('aria-pressed') !== 'true'); show(); };
    return button;
  });
  const press = (button, on) => button.setAttribute('aria-pressed', String(on));
  const pressed = () => buttons.filter(button => button.getAttribute('aria-pressed') === 'true').map(button => button.dataset.trait);

  function show() {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean), traits = pressed();
    let shown = 0;
    for (const card of cards) {
      const text = texts.get(card), has = card.dataset.traits.split(' ');
      card.hidden = !(words.every(word => text.includes(word)) && traits.every(trait => has.includes(trait)));
      shown += card.hidden ? 0 : 1;
    }
    for (const chapter of document.querySelectorAll('.chapter')) chapter.hidden = !chapter.querySelector('.card:not([hidden])');
    count.textContent = shown === cards.length ? '' : `${shown} of ${cards.length}`;
    history.replaceState({words: input.value, traits}, '');
  }

  const before = history.state || {};  // so that the way back from a figure leads to what was found
  input.value = before.words || '';
  for (const button of buttons) press(button, (before.traits || []).includes(button.dataset.trait));
  input.oninput = show;
  place.append(element('div', {className: 'search'}, input, ...buttons, count));
  place.firstChild.setAttribute('role', 'search');
  if (input.value || pressed().length) show();
}

// --- pictures: pan what is enlarged ---

const enlarged = () => document.querySelector('.picture:target');

function reduce() {
  const figure = enlarged();
  if (!figure) return;
  location.hash = figure.querySelector('.reduce').hash;
  figure.querySelector('.enlarge').focus({preventScroll: true});
}

function addPanning(figure) {
  const frame = figure.querySelector('.frame');
  let from = null;
  figure.querySelector('.enlarge').addEventListener('click', event => {
    const box = frame.getBoundingClientRect();
    const at = event.detail === 0 ? [0.5, 0] : [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    addEventListener('hashchange', () => {
      frame.tabIndex = 0;
      frame.focus({preventScroll: true});
      frame.scrollTo(at[0] * frame.scrollWidth - frame.clientWidth / 2, at[1] * frame.scrollHeight - frame.clientHeight / 2);
    }, {once: true});
  });
  frame.addEventListener('pointerdown', event => {
    if (enlarged() !== figure || event.pointerType !== 'mouse' || event.button !== 0) return;
    from = {x: event.clientX, y: event.clientY, left: frame.scrollLeft, top: frame.scrollTop, moved: false};
    frame.setPointerCapture(event.pointerId);
    frame.classList.add('held');
    event.preventDefault();
  });
  frame.addEventListener('pointermove', event => {
    if (!from) return;
    from.moved ||= Math.hypot(event.clientX - from.x, event.clientY - from.y) > 4;
    frame.scrollTo(from.left - (event.clientX - from.x), from.top - (event.clientY - from.y));
  });
  frame.addEventListener('pointerup', () => {
    frame.classList.remove('held');
    if (from && !from.moved) reduce();
    from = null;
  });
}

// --- pictures as PNG, made here ---

let texts = null;
// pictures.js calls it with JSON, packed by gzip, in base64
window.stepwirePictures = packed => {
  const bytes = Uint8Array.from(atob(packed), letter => letter.charCodeAt(0));
  texts = new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).json();
};

function loadTexts() {
  if (texts) return Promise.resolve(texts);
  return new Promise((done, fail) => {
    document.head.append(element('script', {src: 'pictures.js', onload: () => done(texts), onerror: fail}));
  });
}

async function pngOf(image) {
  const name = decodeURIComponent(image.src.split('/').pop());
  const text = (await loadTexts())[name].replaceAll('(prefers-color-scheme: dark)', 'not all');
  const source = new Image();
  source.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(text);
  await source.decode();
  const canvas = element('canvas', {width: 2 * source.naturalWidth, height: 2 * source.naturalHeight});
  canvas.getContext('2d').drawImage(source, 0, 0, canvas.width, canvas.height);
  const blob = await new Promise(done => canvas.toBlob(done, 'image/png'));
  const link = element('a', {href: URL.createObjectURL(blob), download: name.replace(/\.svg$/, '.png')});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

function addPng(list) {
  const cell = element('dd', {className: 'tools'});
  for (const image of document.querySelectorAll('.picture img')) {
    const name = decodeURIComponent(image.src.split('/').pop()).replace(/\.svg$/, '.png');
    const button = element('button', {type: 'button', textContent: name});
    button.onclick = () => pngOf(image).catch(() => { button.textContent = name + ' cannot be made'; });
    cell.append(button, ' ');
  }
  if (cell.firstChild) list.querySelector('dd').after(element('dt', {textContent: 'Pictures, PNG'}), cell);
}

// --- keys ---

function openTarget() {
  const target = location.hash.length > 1 && document.getElementById(location.hash.slice(1));
  if (target && target.matches('details')) target.open = true;
}

function onKey(event) {
  if (event.altKey || event.ctrlKey || event.metaKey || event.shiftKey) return;
  const typing = event.target.closest('input, pre');
  const find = document.getElementById('find');
  if (event.key === 'Escape' && enlarged()) return reduce();
  if (event.key === '/' && find && !typing) {
    event.preventDefault();
    return find.focus();
  }
  const relation = {ArrowLeft: 'prev', ArrowRight: 'next'}[event.key];
  const link = relation && !typing && !enlarged() && document.querySelector(`a[rel="${relation}"]`);
  if (link) location.href = link.href;
}

const place = document.getElementById('search');
if (place) addSearch(place);
document.querySelectorAll('.picture').forEach(addPanning);
const downloads = document.querySelector('.downloads');
if (downloads) addPng(downloads);
addEventListener('keydown', onKey);
addEventListener('hashchange', openTarget);
openTarget();
)js";

}  // namespace stepwire::gallery
