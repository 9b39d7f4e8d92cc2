'use strict';
// Draws a sensor's numbers of the last minute. Each number is a small line, with a gap where no message came. If the board describes a
// range, the number is drawn in this range.

const SVG = 'http://www.w3.org/2000/svg';
const HEIGHT = 20;

function drawn(tag, attributes, into) {
  const made = into.appendChild(document.createElementNS(SVG, tag));
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

/** Returns the place of [value] between [low] and [high], scaled to the drawing's height. */
function heightOf(value, low, high) {
  return (high === low ? HEIGHT / 2 : 2 + (HEIGHT - 4) * (1 - (value - low) / (high - low))).toFixed(1);
}

/** Returns the path through [values], scaled to the drawing's height. A single value is a short line. */
function coursePath(values, low, high) {
  let path = '';
  let isDrawing = false;
  values.forEach((value, x) => {
    if (value !== null) path += `${isDrawing ? 'L' : 'M'}${x} ${heightOf(value, low, high)}h1`;
    isDrawing = value !== null;
  });
  return path;
}

const inWords = ({ unit, min, max }) => [min, '…', max, unit].filter(word => word !== null && word !== '').join(' ');

/** Draws the limits of [range] as lines, and the [values] beyond them as a second path. */
function drawRange(svg, values, range, low, high) {
  for (const limit of [range.min, range.max]) {
    if (limit === null || low === high) continue;
    const y = heightOf(limit, low, high);
    drawn('line', { class: 'limit', x1: 0, x2: values.length, y1: y, y2: y, 'vector-effect': 'non-scaling-stroke' }, svg);
  }
  const isBeyond = value => value !== null && (value < (range.min ?? value) || value > (range.max ?? value));
  const beyond = values.map(value => isBeyond(value) ? value : null);
  if (!beyond.some(value => value !== null)) return;
  drawn('path', { class: 'beyond', d: coursePath(beyond, low, high), 'vector-effect': 'non-scaling-stroke' }, svg);
}

/**
 * Shows [numbers], the values of each number, in [box]. Shows nothing if there are none. [ranges] has each number's range, or null.
 */
function showCourse(box, numbers, ranges = []) {
  const key = JSON.stringify([numbers || [], ranges]);
  if (box.dataset.shown === key) return;
  box.dataset.shown = key;
  box.replaceChildren();
  for (const [i, values] of (numbers || []).entries()) {
    const known = values.filter(value => value !== null);
    if (!known.length) continue;
    const range = ranges[i];
    const limits = [range?.min, range?.max].filter(limit => typeof limit === 'number');
    const [least, most] = [Math.min(...known), Math.max(...known)];
    const [low, high] = [Math.min(least, ...limits), Math.max(most, ...limits)];
    const words = (least === most ? `${least} for the last minute` : `${least} to ${most} in the last minute`) +
      (range ? `, of ${inWords(range)}` : '');
    const line = box.appendChild(document.createElement('span'));
    const svg = drawn('svg', { viewBox: `0 0 ${values.length} ${HEIGHT}`, preserveAspectRatio: 'none', role: 'img', 'aria-label': words }, line);
    drawn('title', {}, svg).textContent = words;
    drawn('path', { d: coursePath(values, low, high), 'vector-effect': 'non-scaling-stroke' }, svg);
    if (!range) continue;
    drawRange(svg, values, range, low, high);
    line.appendChild(document.createElement('small')).textContent = inWords(range);
  }
}
