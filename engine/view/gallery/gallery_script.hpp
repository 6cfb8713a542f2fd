#pragma once

namespace stepwire::gallery {

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
