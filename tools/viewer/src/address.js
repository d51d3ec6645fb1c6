// SPDX-License-Identifier: GPL-2.0-or-later
// Settings written in the fragment of the page's address: page.html#model=ball&copies=200

export const NOT_SET = null;

/// Readers of one setting's text; undefined where the text is nonsense.
export const number = (low, high) => (text) => {
  const value = Number(text);
  return text.trim() !== '' && value >= low && value <= high ? value : undefined;
};
export const choice =
  (...values) =>
  (text) =>
    values.includes(text) ? text : undefined;
export const flag = (text) => ({ 0: false, 1: true })[text];
export const vector = (text) => {
  const values = text.split(',').map(Number);
  return values.length === 3 && values.every(Number.isFinite) ? values : undefined;
};

/// What every page has: how the camera stands where someone placed it, and the look of the page.
export const COMMON_DEFAULTS = {
  direction: NOT_SET,
  zoom: NOT_SET,
  target: NOT_SET,
  panel: true,
  theme: 'auto',
  background: 'theme',
};
export const COMMON_READERS = {
  direction: vector,
  zoom: number(0.01, 1e4),
  target: vector,
  panel: flag,
  theme: choice('auto', 'light', 'dark'),
  background: choice('theme', 'none'),
};

/// The settings that a fragment gives. What is unknown or out of range is left out: a link should show
/// something.
export function readFragment(hash, defaults, readers) {
  const settings = { ...defaults };
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, ''))) {
    const value = readers[name]?.(text);
    if (value !== undefined) settings[name] = value;
  }
  return settings;
}

const short = (x) => String(Number(x.toPrecision(5)));

/// The fragment that says what differs from what is usual.
export function writeFragment(settings, usual) {
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
