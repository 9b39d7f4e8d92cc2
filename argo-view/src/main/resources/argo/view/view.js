'use strict';
// Shows one agent. Whatever a board or an agent says is put in as text, never as markup.

const $ = id => document.getElementById(id);
const TICK_MS = 200;
let state = null;          // what was said last
let receivedAt = 0;        // when
let source = null;
let connection = 'connecting';
let frozen = null;         // what is shown instead while the page is frozen
let filters = null;        // the names of the filters there are
let waits = false;         // for the answer to a button
const explained = new Map(); // a percept's key: its text when it was asked about, and why

// --- words ---

function age(ms) {
  if (ms === null || ms === undefined) return '–';
  if (ms < 1000) return `${Math.round(ms)} ms`;
  if (ms < 60000) return `${(ms / 1000).toFixed(1)} s`;
  if (ms < 3600000) return `${Math.floor(ms / 60000)} min`;
  return `${Math.floor(ms / 3600000)} h`;
}

const rate = perSecond => perSecond === undefined || perSecond === null ? '–' : `${perSecond < 10 ? perSecond.toFixed(1) : Math.round(perSecond)} /s`;

const FATES = {
  kept: ['kept', 'good'],
  dropped: ['dropped', ''],
  held: ['held back', 'warn'],
  unreadable: ['no percept', 'bad'],
};
const STATES = {
  line: ['on the line', 'warn'],
  waiting: ['waiting', ''],
  done: ['done', 'good'],
  failed: ['failed', 'bad'],
};
const PORTS = { on: 'good', off: 'bad', timeout: 'warn' };

// --- elements ---

function text(element, words) { if (element.textContent !== words) element.textContent = words; }
function say(element, words) { text(element, words || ''); element.hidden = !words; }
function chip(element, words, kind) { text(element, words); const name = `chip ${kind}`.trim(); if (element.className !== name) element.className = name; }
function element(tag, name) { const made = document.createElement(tag); if (name) made.className = name; return made; }

/** Makes the rows of a list those of [items], keeping the elements of rows that stay, so that focus and reading position stay too. */
function rows(list, items, keyOf, make, fill, none) {
  const before = new Map([...list.children].map(row => [row.dataset.key, row]));
  let next = list.firstElementChild;
  if (items.length === 0) items = [null];
  for (const item of items) {
    const key = item === null ? '\u0000none' : keyOf(item);
    let row = before.get(key);
    before.delete(key);
    if (!row) {
      row = item === null ? element('li', 'empty') : make(item);
      row.dataset.key = key;
    }
    if (row === next) next = next.nextElementSibling; else list.insertBefore(row, next);
    if (item === null) text(row, none); else fill(row, item);
  }
  before.forEach(row => row.remove());
}

function row(label) {
  const made = element('li');
  made.append(label || element('span', 'text'), element('span', 'chip'), element('span', 'age'), element('span', 'detail'));
  return made;
}

// --- parts of the page ---

function showPicture(picture) {
  $('picture').hidden = !picture;
  if (!picture) return;
  const put = (element, distance) => element.style.setProperty('--at', 1 - Math.min(1, Math.max(0, distance / picture.range)));
  const measure = value => `${value.toFixed(1)} ${picture.unit}`;
  const known = picture.distance !== null;
  text($('picture-distance'), known ? measure(picture.distance) : 'no distance yet');
  text($('picture-doing'), picture.doing);
  $('track-robot').style.display = known ? '' : 'none';
  if (known) put($('track-robot'), picture.distance);
  $('track-limit').style.display = picture.limit === null ? 'none' : '';
  if (picture.limit !== null) put($('track-limit'), picture.limit);
  text($('picture-range'), `${picture.range} ${picture.unit} from the wall`);
  text($('picture-limit'), picture.limit === null ? '' : `to stop at ${picture.limit} ${picture.unit}`);
  $('track').setAttribute('aria-label', `${known ? measure(picture.distance) : 'unknown distance'} from the wall, ${picture.doing}`);
}

function showFigures(shown, since) {
  const { sensors, rates, beliefs } = shown;
  const plus = ms => ms === null ? null : ms + since;
  const figures = [
    ['newest message', age(plus(sensors.frameAgeMs))],
    ['last perception', age(plus(sensors.handedOverAgeMs))],
    ['its delay', age(sensors.delayMs)],
    ['messages', rate(rates?.frames)],
    ['perceptions', rate(rates?.handOvers)],
    ['commands', rate(rates?.commands)],
    ['cycles', rate(rates?.cycles)],
    ['belief picture', age(plus(beliefs.ageMs))],
    ['interval', shown.intervalMs === 0 ? 'none' : age(shown.intervalMs)],
    ['policy', shown.policy],
  ];
  const list = $('figures');
  figures.forEach(([name, value], i) => {
    let pair = list.children[i];
    if (!pair) {
      pair = element('div');
      pair.append(element('dt'), element('dd'));
      list.append(pair);
    }
    text(pair.children[0], name);
    text(pair.children[1], value);
  });
}

function showFilters(shown) {
  const active = shown.filter ? shown.filter.name : null;
  const names = [null, ...(filters || [])];
  if (active !== null && !names.includes(active)) names.push(active);
  const group = $('filters');
  names.forEach((name, i) => {
    let button = group.children[i];
    if (!button) {
      button = element('button');
      button.type = 'button';
      button.addEventListener('click', () => changeFilter(button.dataset.name ?? null));
      group.append(button);
    }
    if (name === null) delete button.dataset.name; else button.dataset.name = name;
    text(button, name === null ? 'none' : name);
    button.setAttribute('aria-pressed', String(name === active));
    disable(button);
  });
  while (group.children.length > names.length) group.lastElementChild.remove();
  text($('filter-words'), shown.filter ? shown.filter.words : 'Everything that the board says reaches the agent.');
}

function showPorts(shown, since) {
  rows($('ports'), shown.ports, port => port.name, () => row(), (line, port) => {
    text(line.children[0], port.name);
    chip(line.children[1], port.status, PORTS[port.status] || '');
    text(line.children[2], port.ageMs === null ? '' : age(port.ageMs + since));
    text(line.children[3], [port.inUse ? 'in use' : 'not in use', port.status === 'on' ? null : port.reason].filter(Boolean).join(' · '));
  }, 'The agent has asked for no port.');
}

function perceptRow(percept) {
  const button = element('button', 'text');
  button.type = 'button';
  button.title = 'Why?';
  const made = row(button);
  button.addEventListener('click', () => explain(percept.key, button.textContent));
  return made;
}

function showSensors(shown, since) {
  const { percepts, more } = shown.sensors;
  const kept = percepts.filter(percept => percept.fate === 'kept').length;
  text($('sensors-count'), percepts.length ? `${kept} of ${percepts.length} reach the agent` : '');
  text($('sensors-words'), !shown.perceiving ? 'Percepts are blocked: the agent goes on believing what it perceived last.'
    : percepts.length ? 'Press a percept to read why it is kept or dropped.' : '');
  rows($('sensors'), percepts, percept => percept.key, perceptRow, (line, percept) => {
    const [words, kind] = FATES[percept.fate] || [percept.fate, ''];
    const why = explained.get(percept.key);
    line.className = percept.fate === 'kept' ? '' : 'off';
    text(line.children[0], percept.text);
    line.children[0].setAttribute('aria-expanded', String(Boolean(why)));
    chip(line.children[1], words, kind);
    text(line.children[2], age(percept.ageMs + since));
    line.children[2].title = `the same for ${age(percept.sameMs + since)}`;
    text(line.children[3], why || '');
  }, shown.perceiving ? 'The board has said nothing yet.' : 'Nothing is perceived.');
  if (more) text($('sensors-words'), `${more} more percepts are not shown.`);
}

function showBeliefs(shown) {
  const { beliefs, total } = shown.beliefs;
  const order = belief => (belief.sources.includes('percept') ? '1' : '0') + belief.text;
  const sorted = [...beliefs].sort((a, b) => order(a) < order(b) ? -1 : 1);
  text($('beliefs-count'), total ? `${total}` : '');
  text($('beliefs-words'), total > beliefs.length ? `${total - beliefs.length} more are not shown.` : '');
  rows($('beliefs'), sorted.map((belief, i) => [String(i), belief]), ([key]) => key, () => row(), (line, [, belief]) => {
    text(line.children[0], belief.text);
    chip(line.children[1], belief.sources.join(', ') || 'self', belief.sources.includes('percept') ? 'good' : '');
  }, shown.beliefs.ageMs === null ? 'Not seen yet.' : 'The agent believes nothing.');
}

function showCommands(shown, since) {
  const { waiting, unfinished, finished } = shown.commands;
  text($('commands-count'), waiting ? `${waiting} not out yet` : '');
  text($('commands-words'), waiting > unfinished.length ? `${waiting - unfinished.length} more wait and are not shown.` : '');
  const ports = new Set(shown.ports.map(port => port.name)).size;
  rows($('commands'), [...unfinished, ...finished], command => String(command.number), () => row(), (line, command) => {
    const [words, kind] = STATES[command.state] || [command.state, ''];
    text(line.children[0], command.text);
    chip(line.children[1], command.tookMs === null ? words : `${words} in ${age(command.tookMs)}`, kind);
    text(line.children[2], age(command.ageMs + since));
    text(line.children[3], [ports > 1 ? command.port : null, command.error].filter(Boolean).join(' · '));
  }, 'The agent has given no command.');
}

function showHead(shown) {
  text($('agent'), shown.agent);
  const title = `${shown.agent} · ARGO`;
  if (document.title !== title) document.title = title;
  text($('percepts'), shown.perceiving ? 'Block percepts' : 'Open percepts');
  $('percepts').title = shown.perceiving ? 'The agent stops perceiving its board and goes on acting on what it believes' : 'The agent perceives its board again';
  disable($('percepts'));
}

function disable(button) { button.disabled = waits || connection !== 'live' || Boolean(state?.ended); }

function showConnection() {
  const words = { connecting: ['connecting', ''], live: ['live', 'good'], lost: ['no connection', 'bad'], full: ['too many pages', 'bad'], ended: ['ended', ''] }[connection];
  if (frozen && connection === 'live') chip($('connection'), 'frozen', 'warn'); else chip($('connection'), ...words);
}

function notice() {
  if (state?.ended) return `Ended: ${state.ended}. What you see is how it was then.`;
  if (frozen) return 'This page is frozen. The agent goes on.';
  if (connection === 'lost') return 'The connection is lost: the program has ended or does not answer. What you see is how it was then; this page tries again by itself.';
  if (connection === 'full') return 'Too many pages show this agent already. Close one and load this one again.';
  if (state?.waitingToStart) return 'The agent has not started yet.';
  return '';
}

function show() {
  showConnection();
  say($('notice'), notice());
  const shown = frozen ? frozen.state : state;
  if (!shown) return;
  const stands = frozen || connection !== 'live';
  const since = frozen ? frozen.since : stands ? 0 : performance.now() - receivedAt;
  showHead(shown);
  showPicture(shown.picture);
  showFigures(shown, since);
  showFilters(shown);
  showPorts(shown, since);
  showSensors(shown, since);
  showBeliefs(shown);
  showCommands(shown, since);
}

// --- what the agent is asked ---

async function ask(path, body) {
  const options = body === undefined ? {} : { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) };
  const response = await fetch(path, options);
  const answer = await response.json();
  if (!response.ok) throw new Error(answer.words);
  return answer;
}

async function order(path, body) {
  waits = true;
  say($('problem'), '');
  show();
  try {
    await ask(path, body);
  } catch (trouble) {
    say($('problem'), trouble.message);
  } finally {
    waits = false;
    show();
  }
}

function changeFilter(name) { order('filter', { name }).then(loadFilters); }

async function explain(key, percept) {
  if (explained.delete(key)) return show();
  try {
    explained.set(key, (await ask(`explain?percept=${encodeURIComponent(percept)}`)).words);
    text($('told'), explained.get(key));
  } catch (trouble) {
    explained.set(key, `cannot be told now: ${trouble.message}`);
  }
  show();
}

async function loadFilters() {
  try {
    filters = (await ask('filters')).filters;
  } catch (trouble) {
    say($('problem'), trouble.message);
  }
  show();
}

// --- the connection ---

function connect() {
  source = new EventSource('events');
  source.onmessage = event => {
    const isNew = connection !== 'live';
    state = JSON.parse(event.data);
    receivedAt = performance.now();
    connection = state.ended ? 'ended' : 'live';
    if (isNew && !state.ended) {
      explained.clear();
      loadFilters();
    }
    if (state.ended) frozen = null;
    showFreeze();
    show();
  };
  source.onerror = () => {
    if (connection !== 'ended') connection = source.readyState === EventSource.CLOSED ? 'full' : 'lost';
    show();
  };
}

function showFreeze() {
  $('freeze').setAttribute('aria-pressed', String(Boolean(frozen)));
  text($('freeze'), frozen ? 'Unfreeze page' : 'Freeze page');
  $('freeze').disabled = Boolean(state?.ended);
}

$('freeze').addEventListener('click', () => {
  frozen = frozen || !state ? null : { state, since: connection === 'live' ? performance.now() - receivedAt : 0 };
  showFreeze();
  show();
});
$('percepts').addEventListener('click', () => order('percepts', { open: !(frozen ? frozen.state : state).perceiving }));

// A page that nobody sees does not keep the agent busy, nor one of the few connections that a browser has for one address.
document.addEventListener('visibilitychange', () => {
  if (document.hidden) {
    source?.close();
    source = null;
  } else if (!source) {
    connect();
  }
});

setInterval(() => { if (!frozen && connection === 'live' && !document.hidden) show(); }, TICK_MS);
if (!document.hidden) connect();
