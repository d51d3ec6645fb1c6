// SPDX-License-Identifier: GPL-2.0-or-later
// What is shown, and the page's address that says so: page.html#model=ball&copies=200&direction=1,-1,0.5
import { COLOURINGS } from './body.js';
import { MODELS } from './models.js';

/// More copies than fill about this many triangles are shown only when asked for.
const FIRST_TRIANGLES = 400000;
const FIRST_COPIES = 400;

export const NOT_SET = null;

const DEFAULTS = {
  body: 0,
  model: 'half',
  copies: NOT_SET,
  explode: 0,
  colour: 'tetrahedron',
  faces: true,
  boundary: true,
  edges: true,
  opacity: 1,
  direction: NOT_SET,
  zoom: NOT_SET,
  target: NOT_SET,
  panel: true,
  theme: 'auto',
  background: 'theme',
};

const number = (low, high) => (text) => {
  const value = Number(text);
  return text.trim() !== '' && value >= low && value <= high ? value : undefined;
};
const choice =
  (...values) =>
  (text) =>
    values.includes(text) ? text : undefined;
const flag = (text) => ({ 0: false, 1: true })[text];
const vector = (text) => {
  const values = text.split(',').map(Number);
  return values.length === 3 && values.every(Number.isFinite) ? values : undefined;
};

const READERS = {
  body: number(0, 1e6),
  model: choice(...MODELS),
  copies: number(1, 1e9),
  explode: number(0, 1),
  colour: choice(...Object.keys(COLOURINGS)),
  faces: flag,
  boundary: flag,
  edges: flag,
  opacity: number(0.05, 1),
  direction: vector,
  zoom: number(0.01, 1e4),
  target: vector,
  panel: flag,
  theme: choice('auto', 'light', 'dark'),
  background: choice('theme', 'none'),
};

/// The settings written in an address' fragment. What is unknown or out of range is left out: a link should
/// show something.
export function readHash(hash) {
  const settings = { ...DEFAULTS };
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, ''))) {
    const value = READERS[name]?.(text);
    if (value !== undefined) settings[name] = value;
  }
  return settings;
}

const short = (x) => String(Number(x.toPrecision(5)));

/// The fragment that says what differs from the defaults.
export function writeHash(settings, body) {
  const usual = { ...DEFAULTS, copies: firstCopies(body) };
  const parts = [];
  for (const [name, value] of Object.entries(settings)) {
    if (value === NOT_SET || value === usual[name]) continue;
    const text =
      typeof value === 'boolean'
        ? Number(value)
        : Array.isArray(value)
          ? value.map(short).join(',')
          : typeof value === 'number'
            ? short(value)
            : value;
    parts.push(`${name}=${text}`);
  }
  return parts.length ? `#${parts.join('&')}` : '';
}

/// How many copies of a body are shown at first: one of a solid, as many as are quickly drawn of a tiling.
export function firstCopies(body) {
  const triangles = body.surfaces.reduce((sum, surface) => sum + surface.triangles.length / 3, 1);
  const wanted =
    body.shown ?? (body.view === 'space' ? 1 : Math.min(FIRST_COPIES, FIRST_TRIANGLES / triangles));
  return Math.max(1, Math.min(body.copies.count, Math.floor(wanted)));
}

/// The settings made possible: an existing body, a number of copies that it has, a model in which it can be
/// seen.
export function completed(settings, scene) {
  const index = Math.min(Math.floor(settings.body), scene.bodies.length - 1);
  const body = scene.bodies[index];
  return {
    ...settings,
    body: index,
    model: body.view === 'horizontal' ? 'half' : settings.model,
    copies:
      settings.copies === NOT_SET
        ? firstCopies(body)
        : Math.max(1, Math.min(body.copies.count, Math.floor(settings.copies))),
  };
}
