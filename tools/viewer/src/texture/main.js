// SPDX-License-Identifier: GPL-2.0-or-later
// The page that `tetrarch slit` writes: a surface beside its image in a domain, both with the same pattern.
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
import { Stage } from './stage.js';

const DEFAULTS = { pattern: PATTERNS[0], squares: 40, lines: true, ...COMMON_DEFAULTS };
const READERS = {
  pattern: choice(...PATTERNS),
  squares: number(2, 1000),
  lines: flag,
  ...COMMON_READERS,
};

const element = (id) => document.getElementById(id);

/// Each number of a line once, with its colour.
function showLegend({ panes }) {
  const colours = new Map();
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

class TexturePage extends Page {
  constructor(scene, context, canvas) {
    super(scene, canvas);
    this.stage = new Stage(scene, canvas, context, () => this.noteAddress());
    const listen = (id, event, read) =>
      element(id).addEventListener(event, ({ target }) => this.change(read(target)));
    listen('pattern', 'change', (control) => ({ pattern: control.value }));
    listen('squares', 'input', (control) => ({ squares: control.valueAsNumber }));
    listen('lines', 'change', (control) => ({ lines: control.checked }));
    element('reset').addEventListener('click', () => this.reset());
    element('save').addEventListener('click', () => this.save());
    element('caption').textContent = scene.panes.map((pane) => pane.name).join(' and ');
    element('hint').textContent =
      'Drag to turn a solid or to move a plane, scroll or pinch to come nearer, drag with the right button or two fingers to move.';
    showLegend(scene);
    this.begin();
  }

  fromAddress(hash) {
    return readFragment(hash, DEFAULTS, READERS);
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
    const { pattern, squares, lines } = this.settings;
    element('pattern').value = pattern;
    element('squares').value = squares;
    element('squares-said').textContent = `${squares} across the domain`;
    element('lines').checked = lines;
    this.stage.show(this.settings, this.theme);
  }
}

open(readScene, (scene, context, canvas) => new TexturePage(scene, context, canvas));
