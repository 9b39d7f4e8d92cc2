'use strict';
// Draws the numbers of a sensor during the last minute: one small line for each number, with a gap where no message came.

const SVG = 'http://www.w3.org/2000/svg';
const HEIGHT = 20;

function drawn(tag, attributes, into) {
  const made = into.appendChild(document.createElementNS(SVG, tag));
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

/** Returns the path through [values], scaled to the drawing's height; a single value is a short line. */
function coursePath(values, low, high) {
  const y = value => (high === low ? HEIGHT / 2 : 2 + (HEIGHT - 4) * (1 - (value - low) / (high - low))).toFixed(1);
  let path = '';
  let isDrawing = false;
  values.forEach((value, x) => {
    if (value !== null) path += `${isDrawing ? 'L' : 'M'}${x} ${y(value)}h1`;
    isDrawing = value !== null;
  });
  return path;
}

/** Shows [numbers], the values of each number, in [box]; nothing if there are none. */
function showCourse(box, numbers) {
  const key = JSON.stringify(numbers || []);
  if (box.dataset.shown === key) return;
  box.dataset.shown = key;
  box.replaceChildren();
  for (const values of numbers || []) {
    const known = values.filter(value => value !== null);
    if (!known.length) continue;
    const [low, high] = [Math.min(...known), Math.max(...known)];
    const words = low === high ? `${low} for the last minute` : `${low} to ${high} in the last minute`;
    const svg = drawn('svg', { viewBox: `0 0 ${values.length} ${HEIGHT}`, preserveAspectRatio: 'none', role: 'img', 'aria-label': words }, box);
    drawn('title', {}, svg).textContent = words;
    drawn('path', { d: coursePath(values, low, high), 'vector-effect': 'non-scaling-stroke' }, svg);
  }
}
