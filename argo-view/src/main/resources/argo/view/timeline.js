'use strict';
// The timeline of a recording, or of the last minutes of a running agent. The server sends the part in view. It sends heaps of items for a
// lane with too many items for the screen.

const $ = id => document.getElementById(id);
const LANES = ['LINE', 'PERCEPTS', 'EVENTS', 'INTENTIONS', 'COMMANDS', 'PRINTED'];
const NAMES = { LINE: 'line', PERCEPTS: 'percepts', EVENTS: 'events', INTENTIONS: 'intentions', COMMANDS: 'commands', PRINTED: 'printed' };
const LANE_HEIGHT = 44;
const HEAD = 26;           // height of an agent's name
const AXIS = 24;
const PIXELS_EACH = 3;     // the smallest width of an item; if items do not fit, they become heaps
const NEAR = 14;           // pixels from an item within which a click chooses it
const LEAST_SPAN = 0.002;  // seconds
const NEAR_COMMAND = 1;    // seconds shown before and after a command that the address asks about

const canvas = $('lanes');
let recording = null;
let from = 0, until = 1;   // the part in view, in seconds
let parts = [];            // the parts of the lanes, as the server sent them
let chosen = null;         // an item with its links
let lit = new Set();       // the ids of the chosen item and its links
let asked = 0;             // counts requests for parts; only the last answer is shown

// --- from the server ---

async function get(path) {
  const response = await fetch(path);
  const body = await response.json();
  if (!response.ok) throw new Error(body.message);
  return body;
}

function shownProblem(words) { $('problem').textContent = words; $('problem').hidden = !words; }

let waiting = false;
/** Asks for the part in view, and shows only the answer to the last request. */
async function load() {
  asked++;
  if (waiting) return;
  waiting = true;
  try {
    for (let number = 0; number !== asked;) {
      number = asked;
      const margin = (until - from) / 4;
      const most = Math.max(20, Math.floor(canvas.clientWidth * 1.5 / PIXELS_EACH));
      parts = await get(`items?from=${from - margin}&until=${until + margin}&most=${most}${ofNumber()}`);
      draw();
    }
  } catch (trouble) {
    shownProblem(recording.number ? trouble.message : `The recording is not served any more: ${trouble.message}`);
  } finally {
    waiting = false;
  }
}

/** Adds the timeline's number to a request, since a running agent's timeline is replaced when a page asks again. */
const ofNumber = () => `&of=${recording.number}`;

const choose = (id, beside) => chooseBy(`id=${id}${beside ? `&beside=${beside}` : ''}`);

async function chooseBy(which) {
  try {
    chosen = await get(`item?${which}${ofNumber()}`);
  } catch (trouble) {
    return shownProblem(trouble.message);
  }
  forgetWhy();
  lit = new Set([chosen.item, ...chosen.causes, ...chosen.effects].map(item => item.id));
  tell();
  const { item } = chosen;
  if (item.from < from || item.from > until) see(item.from - (until - from) / 2, item.from + (until - from) / 2); else draw();
}

// --- words ---

const clock = seconds => until - from < 1 ? `${seconds.toFixed(4)} s` : `${seconds.toFixed(3)} s`;
const nameOf = item => `${recording.agents[item.agent]}, ${NAMES[item.lane]}`;

function line(words) { const made = document.createElement('li'); made.textContent = words; return made; }

function link(item) {
  const made = document.createElement('li');
  const button = document.createElement('button');
  const where = document.createElement('small');
  where.textContent = `${clock(item.from)} ${NAMES[item.lane]}`;
  button.type = 'button';
  button.append(where, item.text);
  button.addEventListener('click', () => choose(item.id));
  made.append(button);
  return made;
}

/** Shows the chosen item and its links. */
function tell() {
  const { item, causes, effects } = chosen;
  $('item-title').textContent = item.text;
  const time = item.until == null ? clock(item.from) : `${clock(item.from)} to ${clock(item.until)}`;
  $('why').hidden = item.command == null;
  $('detail').replaceChildren(line(`${time} · ${nameOf(item)}`), ...(item.detail || []).map(line));
  for (const [id, items] of [['causes', causes], ['effects', effects]]) {
    $(`${id}-count`).textContent = items.length || '';
    $(id).replaceChildren(...(items.length ? items.map(link) : [line('nothing that the recording has')]));
  }
}

// --- why, in sentences ---

let whyAsked = 0; // counts questions; only the last answer is shown

/** Makes a line for a sentence of the tool `why`. The sentence begins with two blanks for each cause before it. */
function sentence(words) {
  const depth = (words.length - words.trimStart().length) / 2;
  const made = line(words.trimStart());
  made.style.marginLeft = `${Math.max(0, depth - 1)}rem`;
  if (depth > 1) made.className = 'aside';
  return made;
}

function shownSentences(title, lines) {
  $('told').hidden = false;
  $('told-title').textContent = title;
  $('sentences').replaceChildren(...lines.map(sentence));
}

/** Tells why the chosen command was sent. For the answer, the server runs the recorded agent again, which takes some time. */
async function askWhy() {
  const { item } = chosen;
  const number = ++whyAsked;
  const title = `Why ${item.text}?`;
  shownSentences(title, ['The recorded agent is run again up to this command …']);
  let lines;
  try {
    lines = (await get(`why?agent=${encodeURIComponent(recording.agents[item.agent])}&command=${item.command}`)).lines;
  } catch (trouble) {
    lines = [`There is no answer: ${trouble.message}`];
  }
  if (number === whyAsked) shownSentences(title, lines);
}

function forgetWhy() {
  whyAsked++;
  $('told').hidden = true;
}

$('why').addEventListener('click', askWhy);

// --- drawing ---

const height = () => AXIS + recording.agents.length * (HEAD + LANES.length * LANE_HEIGHT);
const laneTop = (agent, lane) => AXIS + agent * (HEAD + LANES.length * LANE_HEIGHT) + HEAD + LANES.indexOf(lane) * LANE_HEIGHT;
const x = seconds => (seconds - from) / (until - from) * canvas.clientWidth;
const secondsAt = pixels => from + pixels / canvas.clientWidth * (until - from);

function colours() {
  const style = getComputedStyle(document.documentElement);
  return name => style.getPropertyValue(`--${name}`).trim();
}

function draw() {
  if (!recording) return;
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  canvas.style.height = `${height()}px`;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height() * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height() * ratio);
  }
  const pen = canvas.getContext('2d');
  const colour = colours();
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height());
  drawAxis(pen, colour, width);
  recording.agents.forEach((agent, place) => drawFrame(pen, colour, agent, place, width));
  for (const part of parts) drawPart(pen, colour, part, width);
  drawLinks(pen, colour);
  $('range').textContent =
    `${clock(Math.max(0, from))} to ${clock(Math.min(until, recording.seconds))} of ${clock(recording.seconds)}`;
}

/** Returns a distance between marks of the axis: 1, 2 or 5 times a power of ten, at least [pixels] wide. */
function step(pixels) {
  const least = pixels / canvas.clientWidth * (until - from);
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map(times => times * power).find(wide => wide >= least);
}

function drawAxis(pen, colour, width) {
  const wide = step(90);
  const digits = Math.max(0, -Math.floor(Math.log10(wide) + 1e-9));
  pen.font = '12px system-ui, sans-serif';
  for (let at = Math.ceil(from / wide) * wide; at <= until; at += wide) {
    pen.fillStyle = colour('line');
    pen.fillRect(Math.round(x(at)), AXIS - 6, 1, height());
    pen.fillStyle = colour('soft');
    const words = `${at.toFixed(digits)} s`;
    const left = Math.min(width - pen.measureText(words).width, Math.max(0, x(at) + 3));
    pen.fillText(words, left, 13);
  }
}

function drawFrame(pen, colour, agent, place, width) {
  pen.fillStyle = colour('text');
  pen.font = '600 14px system-ui, sans-serif';
  pen.fillText(agent, 4, laneTop(place, 'LINE') - 8);
  pen.font = '12px system-ui, sans-serif';
  for (const lane of LANES) {
    pen.fillStyle = colour('quiet');
    pen.fillRect(0, laneTop(place, lane) + 17, width, LANE_HEIGHT - 21);
    pen.fillStyle = colour('soft');
    pen.fillText(NAMES[lane], 4, laneTop(place, lane) + 13);
  }
}

/** Sets the colour of an item. The item is dimmed while another item is chosen. */
function paint(pen, colour, id, isBad) {
  const isLit = lit.has(id);
  pen.globalAlpha = lit.size && !isLit ? 0.25 : 1;
  pen.fillStyle = colour(isBad ? 'bad' : isLit || !lit.size ? 'accent' : 'soft');
}

function drawPart(pen, colour, part, width) {
  const top = laneTop(part.agent, part.lane) + 19;
  const tall = LANE_HEIGHT - 25;
  for (const heap of part.heaps || []) {
    paint(pen, colour, -1, heap.isBad);
    const share = Math.min(1, 0.35 + Math.log10(heap.count) / 3);
    pen.fillRect(x(heap.from), top + tall * (1 - share), Math.max(2, x(heap.until) - x(heap.from)), tall * share);
  }
  const items = part.items || [];
  const order = lit.size ? [...items].sort((a, b) => lit.has(a.id) - lit.has(b.id)) : items;
  for (const item of order) {
    paint(pen, colour, item.id, item.isBad);
    const wide = item.until == null ? 0 : x(item.until) - x(item.from);
    pen.fillRect(x(item.from), top, Math.max(3, wide), tall);
    if (chosen && chosen.item.id === item.id) {
      pen.strokeStyle = colour('text');
      pen.lineWidth = 2;
      pen.strokeRect(x(item.from) - 2, top - 2, Math.max(3, wide) + 4, tall + 4);
    }
  }
  drawTexts(pen, colour, items, top, tall, width);
  pen.globalAlpha = 1;
}

/** Writes an item's text to the right of the item, if there is room before the next item. */
function drawTexts(pen, colour, items, top, tall, width) {
  pen.font = '12px system-ui, sans-serif';
  items.forEach((item, place) => {
    const isOnBar = item.until != null && x(item.until) - x(item.from) > 60;
    const begin = (isOnBar || item.until == null ? x(item.from) : Math.max(x(item.from), x(item.until))) + 6;
    const end = place + 1 < items.length ? x(items[place + 1].from) - 4 : width;
    if (begin < -200 || begin > width || end - begin < 36) return;
    pen.globalAlpha = lit.size && !lit.has(item.id) ? 0.4 : 1;
    pen.fillStyle = colour(isOnBar ? 'page' : 'text');
    pen.save();
    pen.beginPath();
    pen.rect(begin, top - 2, end - begin, tall + 4);
    pen.clip();
    pen.fillText(item.text, begin, top + tall - 5);
    pen.restore();
  });
}

/** Draws lines from causes to their effects. */
function drawLinks(pen, colour) {
  if (!chosen) return;
  const all = new Map([chosen.item, ...chosen.causes, ...chosen.effects].map(item => [item.id, item]));
  pen.strokeStyle = colour('accent');
  pen.lineWidth = 1.5;
  pen.globalAlpha = 0.8;
  const middle = item => laneTop(item.agent, item.lane) + 19 + (LANE_HEIGHT - 25) / 2;
  for (const item of all.values()) {
    for (const cause of (item.causes || []).map(id => all.get(id)).filter(Boolean)) {
      pen.beginPath();
      pen.moveTo(x(cause.from) + 1, middle(cause));
      pen.lineTo(x(item.from) + 1, middle(item));
      pen.stroke();
    }
  }
  pen.globalAlpha = 1;
}

// --- moving ---

/** Shows the part from [newFrom] to [newUntil], as far as the recording goes. */
function see(newFrom, newUntil) {
  const whole = Math.max(recording.seconds, 0.01);
  const span = Math.min(Math.max(newUntil - newFrom, LEAST_SPAN), whole * 1.02);
  from = Math.min(Math.max(newFrom, -whole * 0.01), whole * 1.01 - span);
  until = from + span;
  draw();
  load();
}

function zoom(factor, at = (from + until) / 2) { see(at - (at - from) * factor, at + (until - at) * factor); }
function move(share) { see(from + (until - from) * share, until + (until - from) * share); }
const seeAll = () => see(-recording.seconds * 0.01, recording.seconds * 1.01);

/** Returns the id of the item nearest to a place on the canvas; null if none is near. */
function nearest(px, py) {
  const part = parts.find(one => py >= laneTop(one.agent, one.lane) && py < laneTop(one.agent, one.lane) + LANE_HEIGHT);
  if (!part) return null;
  let best = null, distance = NEAR;
  for (const item of [...(part.items || []), ...(part.heaps || [])]) {
    const right = Math.max(x(item.from) + 3, x(item.until ?? item.from));
    const away = px < x(item.from) ? x(item.from) - px : Math.max(0, px - right);
    if (away < distance || away === distance && away === 0) { best = item; distance = away; }
  }
  if (best?.count > 1) zoom(Math.max(0.1, 20 / canvas.clientWidth), best.from); // into the heap
  return best && best.id;
}

const pointers = new Map();
let moved = 0;
function spread() { const [a, b] = [...pointers.values()]; return Math.abs(a - b); }

canvas.addEventListener('pointerdown', event => {
  if (pointers.size === 0) moved = 0;
  pointers.set(event.pointerId, event.offsetX);
  canvas.setPointerCapture(event.pointerId);
});
canvas.addEventListener('pointermove', event => {
  if (!pointers.has(event.pointerId)) return;
  const before = pointers.get(event.pointerId);
  const wide = pointers.size === 2 ? spread() : 0;
  pointers.set(event.pointerId, event.offsetX);
  moved += Math.abs(event.offsetX - before);
  if (pointers.size === 1) move((before - event.offsetX) / canvas.clientWidth);
  else if (wide > 0 && spread() > 0) zoom(wide / spread(), secondsAt([...pointers.values()].reduce((a, b) => a + b) / 2));
});
function released(event) {
  if (!pointers.delete(event.pointerId) || event.type !== 'pointerup' || moved > 5) return;
  const id = nearest(event.offsetX, event.offsetY);
  if (id == null) forget(); else choose(id);
}
canvas.addEventListener('pointerup', released);
canvas.addEventListener('pointercancel', released);
canvas.addEventListener('wheel', event => {
  event.preventDefault();
  if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) move((event.deltaX || event.deltaY) / canvas.clientWidth);
  else zoom(Math.exp(event.deltaY / 400), secondsAt(event.offsetX));
}, { passive: false });

function forget() {
  chosen = null;
  lit = new Set();
  forgetWhy();
  $('why').hidden = true;
  $('item-title').textContent = 'Select an item';
  ['detail', 'causes', 'effects', 'causes-count', 'effects-count'].forEach(id => $(id).replaceChildren());
  draw();
}

/** Chooses the first item in view. */
function chooseFirst() {
  const seen = parts.flatMap(part => part.items || part.heaps || []).filter(item => item.from >= from && item.from <= until);
  if (seen.length) choose(seen.reduce((a, b) => b.from < a.from ? b : a).id);
}
function beside(which) { if (chosen) choose(chosen.item.id, which); else chooseFirst(); }

const KEYS = {
  ArrowLeft: () => move(-0.2), ArrowRight: () => move(0.2), PageUp: () => move(-1), PageDown: () => move(1),
  '+': () => zoom(0.5), '=': () => zoom(0.5), '-': () => zoom(2), '0': seeAll,
  Home: () => see(-recording.seconds * 0.01, until - from - recording.seconds * 0.01),
  End: () => see(recording.seconds - (until - from), recording.seconds * 1.01),
  ',': () => beside('before'), '.': () => beside('after'), Enter: chooseFirst, Escape: forget,
};
const ON_CANVAS = ['Arrow', 'Page', 'Home', 'End', 'Enter']; // outside of the canvas they scroll the page, or press a button
document.addEventListener('keydown', event => {
  const act = KEYS[event.key];
  if (event.target !== canvas && ON_CANVAS.some(name => event.key.startsWith(name))) return;
  if (!act || !recording || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  act();
});
$('in').addEventListener('click', () => zoom(0.5));
$('out').addEventListener('click', () => zoom(2));
$('all').addEventListener('click', seeAll);
$('before').addEventListener('click', () => beside('before'));
$('after').addEventListener('click', () => beside('after'));
new ResizeObserver(() => { if (recording) { draw(); load(); } }).observe(canvas.parentElement);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);

/** Returns the number of the command that the page's address asks about; null if there is none. */
const askedCommand = () => /^#command=(\d+)$/.exec(location.hash)?.[1];

/** Chooses the command that the address asks about, so its causes are listed. */
async function chooseAsked() {
  const number = askedCommand();
  if (!number) return;
  shownProblem('');
  await chooseBy(`command=${number}`);
  if (!chosen) return shownProblem('This command is not in the recording of the last minutes.');
  see(chosen.item.from - NEAR_COMMAND, (chosen.item.until ?? chosen.item.from) + NEAR_COMMAND);
  await askWhy();
}

/** Loads the recording. For a running agent, loads the current state of its recording. */
async function open() {
  $('now').disabled = true;
  try {
    recording = await get('recording');
  } catch (trouble) {
    return shownProblem(`There is nothing to show: ${trouble.message}`);
  } finally {
    $('now').disabled = false;
  }
  document.title = `${recording.name} – ARGO`;
  $('name').textContent = recording.name;
  $('now').hidden = $('back').hidden = !recording.number;
  shownProblem(recording.problems.join('\n'));
  forget();
  seeAll();
}

$('now').addEventListener('click', open);
const openAsked = () => open().then(() => { if (recording) return chooseAsked(); });
addEventListener('hashchange', openAsked);
openAsked();
