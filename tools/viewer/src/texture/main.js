// SPDX-License-Identifier: GPL-2.0-or-later
// The page that `tetrarch slit` and `tetrarch product` write: a surface beside its image in a domain, both with
// the same pattern.
import {
  choice,
  COMMON_DEFAULTS,
  COMMON_READERS,
  flag,
  number,
  readFragment,
  writeFragment,
} from '../address.js';
import { open, Page } from '../page.js';
import { css } from '../palette.js';
import { readScene } from './read.js';
import { PATTERNS } from './shaders.js';
import { range } from './shape.js';
import { Stage } from './stage.js';

const DEFAULTS = { pattern: PATTERNS[0], squares: 40, lines: true, inside: false, ...COMMON_DEFAULTS };
const READERS = {
  squares: number(2, 1000),
  lines: flag,
  inside: flag,
  ...COMMON_READERS,
};

const element = (id) => document.getElementById(id);

/// Each patch, where patches are shown, else each number of a line, once with its colour.
function showLegend({ panes }, pattern) {
  const colours = new Map();
  if (pattern === 'patches') for (const { name, colour } of panes[0].patches.list) colours.set(name, colour);
  else
    for (const { numbers, colours: list } of panes.flatMap((pane) => pane.lines))
      numbers.forEach((number, i) => colours.set(number, list[i]));
  const items = Array.from(colours, ([number, colour]) => {
    const item = document.createElement('li');
    const swatch = document.createElement('span');
    swatch.className = 'swatch';
    swatch.style.backgroundColor = css(colour);
    item.append(swatch, String(number));
    return item;
  });
  element('legend').replaceChildren(...items);
}

/// The patterns that these panes have something for.
function available({ panes }) {
  return PATTERNS.filter(
    (pattern) => !['field', 'patches'].includes(pattern) || panes.every((pane) => pane[pattern]),
  );
}

const short = (x) => String(Number(x.toPrecision(3)));

function squaresSaid({ pattern, squares }, panes) {
  if (pattern !== 'field') return `${squares} across the domain`;
  const [low, high] = range(panes[0].field.values);
  return `${squares / 2} levels from ${short(low)} to ${short(high)}`;
}

class TexturePage extends Page {
  constructor(scene, context, canvas) {
    super(scene, canvas);
    this.stage = new Stage(scene, canvas, context, () => this.noteAddress());
    const listen = (id, event, read) =>
      element(id).addEventListener(event, ({ target }) => this.change(read(target)));
    this.patterns = available(scene);
    for (const option of [...element('pattern').options]) {
      if (!this.patterns.includes(option.value)) option.remove();
      else if (option.value === 'field') option.textContent = `field ${scene.panes[0].field.name}`;
    }
    element('lines-name').textContent = scene.linesName;
    // In a plane there is no inside.
    const solid = scene.panes.some(({ flat, patches }) => !flat && patches);
    for (const part of [element('inside').parentElement, element('inside').labels[0]]) part.hidden = !solid;
    listen('inside', 'change', (control) => ({ inside: control.checked }));
    listen('pattern', 'change', (control) => ({ pattern: control.value }));
    listen('squares', 'input', (control) => ({ squares: control.valueAsNumber }));
    listen('lines', 'change', (control) => ({ lines: control.checked }));
    element('reset').addEventListener('click', () => this.reset());
    element('save').addEventListener('click', () => this.save());
    element('caption').textContent = scene.panes.map((pane) => pane.name).join(' and ');
    element('hint').textContent =
      'Drag to turn a solid or to move a plane, scroll or pinch to come nearer, drag with the right button or two fingers to move.';
    this.begin();
  }

  fromAddress(hash) {
    return readFragment(hash, DEFAULTS, { ...READERS, pattern: choice(...this.patterns) });
  }
  toAddress() {
    return writeFragment(this.settings, DEFAULTS);
  }
  camera() {
    return this.stage.panes[0].camera();
  }
  pictureName() {
    return this.scene.title;
  }

  /// Show the settings, some of which changed.
  change(part) {
    this.settings = { ...this.settings, ...part };
    this.show();
    this.noteAddress();
  }

  show() {
    const { pattern, squares, lines, inside } = this.settings;
    element('pattern').value = pattern;
    element('squares').value = squares;
    element('squares').disabled = pattern === 'patches';
    element('squares-name').textContent = pattern === 'field' ? 'Levels' : 'Squares';
    element('squares-said').textContent = squaresSaid(this.settings, this.scene.panes);
    element('lines').checked = lines;
    element('inside').checked = inside;
    showLegend(this.scene, pattern);
    this.stage.show(this.settings, this.theme);
  }
}

open(readScene, (scene, context, canvas) => new TexturePage(scene, context, canvas));
