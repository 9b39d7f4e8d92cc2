'use strict';
// Shows one agent. Texts of boards and agents go into the page as text, never as markup.

const $ = id => document.getElementById(id);
const TICK_MS = 200;
let state = null;          // the newest state
let receivedAt = 0;        // when the newest state came
let source = null;
let connection = 'connecting';
let frozen = null;         // shown instead of the newest state while the page is frozen
let courses = {};          // numbers of sensors in the last minute, by the sensors' keys
let filters = null;        // the names of all filters
let waits = false;         // true while a pressed button has no answer yet
const explained = new Map(); // by a percept's key: why it was kept or dropped, and its text and filter at that time

// --- words ---

function age(ms) {
  if (ms == null) return '–';
  if (ms < 1000) return `${Math.round(ms)} ms`;
  if (ms < 60000) return `${(ms / 1000).toFixed(1)} s`;
  if (ms < 3600000) return `${Math.floor(ms / 60000)} min`;
  return `${Math.floor(ms / 3600000)} h`;
}

const rate = perSecond => perSecond == null ? '–' : `${perSecond < 10 ? perSecond.toFixed(1) : Math.round(perSecond)} /s`;

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
const CONNECTIONS = {
  connecting: ['connecting', ''],
  live: ['live', 'good'],
  lost: ['no connection', 'bad'],
  full: ['too many pages', 'bad'],
  ended: ['ended', ''],
};
const INTENTIONS = { running: 'good', waiting: '', suspended: 'warn' };
const PORTS = { on: 'good', off: 'bad', timeout: 'warn' };

// --- elements ---

function text(element, words) { if (element.textContent !== words) element.textContent = words; }
function showOrHide(element, words) { text(element, words || ''); element.hidden = !words; }
function tell(words, isProblem) {
  text($('problem'), words);
  $('trouble').classList.toggle('problem', isProblem);
  $('trouble').hidden = !words;
}
function chip(element, words, kind) { text(element, words); element.className = `chip ${kind}`.trim(); }
function element(tag, name) { const made = document.createElement(tag); if (name) made.className = name; return made; }

/** Shows [items] as the rows of a list. Rows that stay keep their elements, so focus and reading position also stay. */
function rows(list, items, keyOf, make, fill, none) {
  const before = new Map([...list.children].map(row => [row.dataset.key, row]));
  let next = list.firstElementChild;
  for (const item of items.length ? items : [null]) {
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

function fill(line, label, words, kind, ageWords = '', detail = '') {
  text(line.children[0], label);
  chip(line.children[1], words, kind);
  text(line.children[2], ageWords);
  text(line.children[3], detail);
}

function button(name, pressed) {
  const made = element('button', name);
  made.type = 'button';
  made.addEventListener('click', pressed);
  return made;
}

const times = count => count > 1 ? ` ×${count}` : '';
const inOrder = new Intl.Collator('en', { numeric: true }).compare;
const joined = (...parts) => parts.filter(Boolean).join(' · ');

// --- parts of the page ---

function showPicture(picture) {
  $('picture').hidden = !picture;
  if (!picture) return;
  const [image, caption] = $('picture').children;
  const source = `data:image/svg+xml,${encodeURIComponent(picture.svg)}`; // an image runs no scripts
  if (image.src !== source) image.src = source;
  text(caption, picture.words);
}

function showFigures(shown, since) {
  const { sensors, rates, beliefs } = shown;
  const plus = ms => ms === null ? null : ms + since;
  const figures = [
    ['newest message', age(plus(sensors.frameAgeMs))],
    ['last perception', age(plus(sensors.handedOverAgeMs))],
    ['age when perceived', age(sensors.delayMs), 'How old the newest message was when the agent perceived it'],
    ['messages', rate(rates?.frames)],
    ['perceptions', rate(rates?.handOvers)],
    ['commands', rate(rates?.commands)],
    ['cycles', rate(rates?.cycles)],
    ['beliefs shown', age(plus(beliefs.ageMs)), 'How old the beliefs and intentions on this page are'],
    ...(shown.skewMs === null ? [] : [['skew of the boards', age(shown.skewMs)]]),
    ['interval', shown.intervalMs === 0 ? 'none' : age(shown.intervalMs)],
    ['policy', shown.policy],
  ];
  rows($('figures'), figures, ([name]) => name, ([name]) => {
    const pair = element('div');
    pair.append(element('dt'), element('dd'));
    text(pair.children[0], name);
    return pair;
  }, (pair, [, value, title]) => {
    text(pair.children[1], value);
    pair.title = title || '';
  });
}

function showFilters(shown) {
  const active = shown.filter ? shown.filter.name : null;
  const names = [null, ...(filters || [])];
  if (active !== null && !names.includes(active)) names.push(active);
  const choices = names.map(name => ({ name }));
  rows($('filters'), choices, choice => JSON.stringify(choice), ({ name }) => button('', () => changeFilter(name)), (choice, { name }) => {
    text(choice, name ?? 'none');
    choice.setAttribute('aria-pressed', String(name === active));
    disable(choice);
  });
  text($('filter-words'), shown.filter ? shown.filter.words : 'Everything that the board sends reaches the agent.');
}

function showCritical(shown, since) {
  $('critical').hidden = !shown.critical.length;
  showOrHide($('critical-words'), shown.moreCritical && `${shown.moreCritical} more critical rules are not shown.`);
  rows($('critical'), shown.critical.map((rule, i) => [String(i), rule]), ([key]) => key, () => row(), (line, [, rule]) => fill(
    line, rule.rule, `the ${rule.watcher} watches`, rule.watcher === 'board' ? 'good' : '',
    rule.ageMs === null ? '' : age(rule.ageMs + since),
    joined(rule.reflex && `reflex ${rule.reflex} by the ${rule.by}`, rule.error),
  ));
}

/** Says how the agent uses a port, and how the port's board differs from others. */
function use(port, shown) {
  return joined(
    port.inUse ? 'in use' : port.perceived ? 'perceived' : 'not in use',
    port.namespace && `as ${port.namespace}`,
    port.perceived && port.intervalMs !== shown.intervalMs && (port.intervalMs === 0 ? 'no interval' : `every ${age(port.intervalMs)}`),
    port.perceived && port.filter !== (shown.filter ? shown.filter.name : null) && `filter ${port.filter ?? 'none'}`,
  );
}

function showPorts(shown, since) {
  rows($('ports'), shown.ports, port => port.name, () => row(), (line, port) => fill(
    line, port.name, port.status, PORTS[port.status] || '', port.ageMs === null ? '' : age(port.ageMs + since),
    joined(use(port, shown), port.status !== 'on' && port.reason),
  ), 'The agent has no port.');
}

/** Explains, in a line for each board, why sensors show old percepts although the agent perceives; empty if they show none. */
function silence(shown) {
  if (!shown.perceiving) return '';
  const used = shown.ports.filter(port => port.perceived);
  const silent = (used.length ? used : shown.ports).filter(port => port.status !== 'on' || port.stale);
  return silent.map(port => {
    const words = { off: 'is off', timeout: 'does not answer' }[port.status] || 'is silent';
    const whose = used.length > 1 ? 'Its sensors' : 'The sensors';
    const reason = port.reason ? `: ${port.reason}` : '';
    return `The port ${port.name} ${words}${reason}${/[.?!]$/.test(reason) ? '' : '.'} ${whose} show what came before.`;
  }).join('\n');
}

function perceptRow({ key }) {
  const label = button('text', () => {
    if (!explained.delete(key)) explain(key, label.dataset.percept);
    show();
  });
  label.title = 'Why?';
  const made = row(label);
  made.append(element('span', 'course'));
  return made;
}

function showSensors(shown, since) {
  const { percepts, more, moreCourses } = shown.sensors;
  const isPast = shown.perceiving && percepts.length > 0 && percepts.every(percept => percept.silent);
  const kept = percepts.filter(percept => percept.fate === 'kept').length;
  text($('sensors-count'), percepts.length ? `${kept} of ${percepts.length} ${isPast ? 'reached' : 'reach'} the agent` : '');
  const hint = percepts.length ? 'Press a percept to read why it is kept or dropped.' : '';
  text($('sensors-words'), [
    !shown.perceiving ? 'Percepts are blocked: the agent goes on believing what it perceived last.' : more ? '' : hint,
    more && `${more} more percepts are not shown.`,
    moreCourses && `The courses of ${moreCourses} more sensors are not shown.`,
  ].filter(Boolean).join(' '));
  rows($('sensors'), percepts, percept => percept.key, perceptRow, (line, percept) => {
    const [words, kind] = FATES[percept.fate] || [percept.fate, ''];
    const why = explained.get(percept.key)?.why;
    const isOld = shown.perceiving && percept.silent;
    const { described } = percept;
    const said = described ? described.text : percept.text;
    line.className = `sensor ${percept.fate === 'kept' && !isOld ? '' : 'off'} ${described?.deviation ? 'odd' : ''}`;
    showCourse(line.children[4], (frozen ? frozen.courses : courses)[percept.key], described?.ranges);
    line.children[0].dataset.percept = percept.text;
    fill(line, percept.board ? `${percept.board}::${said}` : said, words, isOld ? '' : kind, age(percept.ageMs + since),
      joined(described?.deviation && `not as the board describes it: ${described.deviation}`, why));
    line.children[0].setAttribute('aria-expanded', String(Boolean(why)));
    line.children[2].title = `the same for ${age(percept.sameMs + since)}`;
  }, shown.perceiving ? 'No message has come from the board yet.' : 'Nothing is perceived.');
}

const sourcesOf = ({ sources }) => sources.join(', ') || 'self';

/** Returns the [beliefs] whose text or sources contain each word of the search. */
function found(beliefs) {
  const words = $('find').value.toLowerCase().split(/\s+/).filter(Boolean);
  return beliefs.filter(belief => words.every(word => `${belief.text} ${sourcesOf(belief)}`.toLowerCase().includes(word)));
}

function showBeliefs(shown) {
  const { beliefs, total } = shown.beliefs;
  const order = belief => (belief.sources.includes('percept') ? '1' : '0') + belief.text;
  const all = found(beliefs);
  const sorted = all.sort((a, b) => inOrder(order(a), order(b)));
  text($('beliefs-count'), all.length < beliefs.length ? `${all.length} of ${total}` : total ? `${total}` : '');
  text($('beliefs-words'), total > beliefs.length ? `${total - beliefs.length} more are not shown, and not searched.` : '');
  const keyed = sorted.map((belief, i) => [belief.whole ?? String(i), belief]); // a row with a button is for one belief
  rows($('beliefs'), keyed, ([key]) => key, () => actingRow('forget'), (line, [, belief]) => {
    fill(line, belief.text, sourcesOf(belief), belief.sources.includes('percept') ? 'good' : '');
    showAct(line, belief.whole, `forget ${belief.text}`, 'The agent no longer believes this');
  }, shown.beliefs.ageMs === null ? 'Not seen yet.' : beliefs.length ? 'No belief has these words.' : 'The agent believes nothing.');
}

/** Makes a row with the button [verb], which sends the row's text to [path] under the field name [name]. */
function actingRow(verb, path = verb, name = 'text', more = {}) {
  const made = row();
  const act = button('act', async () => {
    const answer = made.closest('section').querySelector('.answer');
    answer.className = 'soft answer';
    text(answer, await order(path, { [name]: act.dataset.text, ...more }) ?? '');
  });
  text(act, verb);
  made.append(act);
  return made;
}

/** Gives the button of [line] the text [words]. Hides the button if there are no words. */
function showAct(line, words, name, title) {
  const act = line.children[4];
  act.hidden = !words;
  if (!words) return;
  act.dataset.text = words;
  act.title = title;
  act.setAttribute('aria-label', name);
  disable(act);
}

/** Makes a row that leads to the command's causes. */
function commandRow() {
  const made = row();
  const why = element('a', 'act');
  why.title = 'Shows the causes of this command, if the agent is recorded';
  text(why, 'why');
  made.append(why);
  return made;
}

function showCommands(shown, since) {
  const { waiting, unfinished, finished } = shown.commands;
  text($('commands-count'), waiting ? `${waiting} not out yet` : '');
  text($('commands-words'), waiting > unfinished.length ? `${waiting - unfinished.length} more wait and are not shown.` : '');
  const ports = new Set(shown.ports.map(port => port.name)).size;
  rows($('commands'), [...unfinished, ...finished], command => String(command.number), commandRow, (line, command) => {
    line.children[4].href = `timeline#command=${command.last}`;
    line.children[4].setAttribute('aria-label', `why ${command.text}`);
    const [words, kind] = STATES[command.state] || [command.state, ''];
    fill(line, command.text + times(command.times), command.tookMs === null ? words : `${words} in ${age(command.tookMs)}`, kind,
      age(command.ageMs + since), joined(ports > 1 && command.port, command.error));
  }, 'The agent has given no command.');
}

const place = plan => plan.file ? `${plan.file}:${plan.line}` : 'no file';

function showIntentions({ intentions: { total, intentions }, pause }) {
  text($('intentions-count'), total ? `${total}` : '');
  text($('intentions-words'), total > intentions.length ? `${total - intentions.length} more are not shown.` : '');
  rows($('intentions'), intentions, ({ id }) => String(id), () => actingRow('drop'), (line, { id, state, waitsFor, plans, more, goal }) => {
    const [words, kind] = id === pause.intention ? ['paused here', 'warn'] : [state, INTENTIONS[state] || ''];
    fill(
      line, plans[0]?.trigger ?? '', words, kind, '',
      joined(
        waitsFor && `waits for ${waitsFor}`, plans[0] && place(plans[0]),
        ...plans.slice(1).map(plan => `for ${plan.trigger} ${place(plan)}`), more && `${more} more plans`,
      ),
    );
    showAct(line, goal, `drop ${goal}`, `The agent drops each intention with the goal ${goal}`);
  }, 'The agent intends nothing.');
}

const breakpointRow = () => actingRow('remove', 'breakpoint', 'place', { isSet: false });

function showStops({ breakpoints }) {
  const at = ({ file, line }) => `${file}:${line}`;
  rows($('breakpoints'), breakpoints, stop => at(stop) + (stop.lost ? ' lost' : ''), breakpointRow, (line, { lost, ...stop }) => {
    fill(line, at(stop), lost ? 'lost' : '', 'warn', '', lost || '');
    line.children[1].hidden = !lost;
    showAct(line, at(stop), `remove ${at(stop)}`, 'The agent does not stop there');
  }, 'The agent stops at no line.');
}

function showPrinted({ printed }, since) {
  rows($('printed'), printed, line => String(line.number), () => row(), (line, { text: words, times: count, warning, ageMs }) => {
    fill(line, words + times(count), warning ? 'warning' : '', 'warn', age(ageMs + since));
    line.children[1].hidden = !warning;
  }, 'The agent has printed nothing.');
}

function showAgents({ agent, agents, moreAgents }) {
  $('agents').hidden = agents.length < 2;
  if (agents.length < 2) return;
  const tabs = moreAgents ? [...agents, { name: '' }] : agents;
  rows($('agents'), tabs, ({ name }) => name, ({ name }) => {
    if (!name) return element('span');
    const link = element('a');
    link.href = `../${encodeURIComponent(name)}/`;
    return link;
  }, (link, { name, silent }) => {
    text(link, !name ? `… ${moreAgents} more, each at its own /NAME/` : silent ? `${name}: board silent` : name);
    link.className = silent ? 'silent' : '';
    if (name === agent) link.setAttribute('aria-current', 'page'); else link.removeAttribute('aria-current');
  });
}

/** Returns a link to the view of an agent of this machine, or the name of another agent with the way to its view. */
function agentThere({ name, viewPort }, { near, address }) {
  const isNear = near && viewPort;
  const made = element(isNear ? 'a' : 'span');
  text(made, name);
  if (isNear) made.href = `//${location.hostname}:${viewPort}/${encodeURIComponent(name)}/`;
  else if (viewPort) made.title = `Its live view is at port ${viewPort} of ${address}: ssh -L ${viewPort}:127.0.0.1:${viewPort} ${address}`;
  return made;
}

function showComputers({ computers }) {
  $('fleet').hidden = !computers.length;
  rows($('computers'), computers, ({ name }) => name, () => row(), (line, computer) => {
    const { name, here, on, agents, more } = computer;
    fill(line, here ? `${name}, this one` : name, on ? 'on' : 'off', on ? 'good' : 'bad', '', line.children[3].textContent);
    const key = JSON.stringify(computer);
    if (line.dataset.shown === key) return;
    line.dataset.shown = key;
    const parts = agents.map(agent => agentThere(agent, computer)).concat(more ? [document.createTextNode(`${more} more`)] : []);
    line.children[3].replaceChildren(...parts.flatMap((part, i) => i ? [', ', part] : [part]));
  });
}

function showHead(shown) {
  text($('agent'), shown.agent);
  const title = `${shown.agent} · ARGO`;
  if (document.title !== title) document.title = title;
  text($('percepts'), shown.perceiving ? 'Block percepts' : 'Open percepts');
  $('percepts').title = shown.perceiving ? 'The agent stops perceiving its board and goes on acting on what it believes'
    : 'The agent perceives its board again';
  text($('pause'), isRunning(shown) ? 'Pause' : 'Go on');
  $('pause').title = isRunning(shown) ? 'Pauses the agent between two cycles; its boards are made safe before' : 'The agent goes on';
  ['percepts', 'reload', 'pause', 'step'].forEach(id => disable($(id)));
  $('step').disabled ||= isRunning(shown);
  document.querySelectorAll('form.send button').forEach(disable);
}

const isRunning = ({ pause }) => pause.phase === 'running';

function disable(button) { button.disabled = waits || connection !== 'live' || Boolean(state?.ended); }

function showConnection() {
  const isLive = connection === 'live';
  const paused = state && !isRunning(state) && [state.pause.phase === 'paused' ? 'paused' : 'is being paused', 'warn'];
  const special = frozen ? ['frozen', 'warn'] : state && silence(state) ? ['board silent', 'bad'] : paused;
  chip($('connection'), ...(isLive && special || CONNECTIONS[connection]));
}

function notice() {
  if (state?.ended) return 'The agent has ended. The page shows its last state.';
  if (frozen) return 'This page is frozen. The agent goes on.';
  if (connection === 'lost') {
    return 'The connection is lost: the program has ended or does not answer. The page shows the last state and tries again.';
  }
  if (connection === 'full') return 'Too many pages show this agent already. Close one and load this one again.';
  if (state?.waitingToStart) return 'The agent has not started yet.';
  if (state && !isRunning(state)) return state.pause.words;
  return '';
}

function show() {
  showConnection();
  showOrHide($('notice'), notice());
  const shown = frozen ? frozen.state : state;
  if (!shown) return;
  const stands = frozen || connection !== 'live';
  const since = frozen ? frozen.since : stands ? 0 : performance.now() - receivedAt;
  showOrHide($('silence'), state.ended ? '' : silence(shown));
  if (!stands) renewExplanations(shown);
  showHead(shown);
  showPicture(shown.picture);
  showFigures(shown, since);
  showFilters(shown);
  showCritical(shown, since);
  showPorts(shown, since);
  showSensors(shown, since);
  showBeliefs(shown);
  showCommands(shown, since);
  showIntentions(shown);
  showStops(shown);
  showPrinted(shown, since);
  showAgents(shown);
  showComputers(shown);
}

// --- requests to the agent ---

async function ask(path, body) {
  const options = body === undefined ? {} : { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) };
  const response = await fetch(path, options);
  const answer = await response.json();
  if (!response.ok) throw new Error(answer.message);
  return answer;
}

/** Lets the agent do something, and returns its answer. If the agent refuses, the page tells why, and the result is null. */
async function order(path, body) {
  waits = true;
  tell('', false);
  show();
  try {
    return (await ask(path, body)).message;
  } catch (trouble) {
    tell(trouble.message, true);
    return null;
  } finally {
    waits = false;
    show();
  }
}

/** Lets the agent do what the field of [form] says, and shows the answer under the field. */
async function send(form) {
  const [field] = form.elements;
  const words = field.value.trim();
  if (!words) return;
  const answer = (said, name) => {
    form.nextElementSibling.className = `soft answer ${name}`;
    text(form.nextElementSibling, said);
  };
  answer(`${words}: sent`, '');
  try {
    answer((await ask(form.dataset.path, { [field.name]: words })).message, '');
  } catch (trouble) {
    answer(trouble.message, 'failed');
  }
}

function changeFilter(name) { order('filter', { name }).then(loadFilters); }

/** Asks why [percept] is kept or dropped, and shows the answer under the row [key]. */
async function explain(key, percept) {
  const before = explained.get(key);
  const entry = { percept, filter: filterWords(), why: before?.why, isAsked: true };
  explained.set(key, entry);
  try {
    entry.why = (await ask(`explain?percept=${encodeURIComponent(percept)}`)).message;
    if (!before) text($('announced'), entry.why);
  } catch (trouble) {
    entry.why = `cannot be explained now: ${trouble.message}`;
  }
  entry.isAsked = false;
  show();
}

const filterWords = () => JSON.stringify(state.filter);

/** Asks again about each explained percept that has changed, or whose filter has changed. */
function renewExplanations(shown) {
  for (const { key, text: percept } of shown.sensors.percepts) {
    const entry = explained.get(key);
    if (entry && !entry.isAsked && (entry.percept !== percept || entry.filter !== filterWords())) explain(key, percept);
  }
}

async function loadFilters() {
  try {
    filters = (await ask('filters')).filters;
  } catch (trouble) {
    tell(trouble.message, true);
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
    if (state.courses) courses = state.courses;
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
  frozen = frozen || !state ? null : { state, courses, since: connection === 'live' ? performance.now() - receivedAt : 0 };
  showFreeze();
  show();
});
$('percepts').addEventListener('click', () => order('percepts', { open: !(frozen ? frozen.state : state).perceiving }));
$('reload').addEventListener('click', async () => {
  const report = await order('reload', {});
  if (report !== null) tell(report, false);
});
$('pause').addEventListener('click', () => order(isRunning(state) ? 'pause' : 'go', {}));
$('step').addEventListener('click', () => order('step', {}));

$('find').addEventListener('input', show);
$('dismiss').addEventListener('click', () => tell('', false));

document.querySelectorAll('form.send').forEach(form => form.addEventListener('submit', event => {
  event.preventDefault();
  if (!form.elements[1].disabled) send(form);
}));

// A hidden page closes its connection. It then causes the agent no work, and a browser's few connections are free for other pages.
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
