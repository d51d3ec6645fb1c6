// SPDX-License-Identifier: GPL-2.0-or-later
// The controls: they show the settings and report changes.
import { classCount, COLOURINGS, tintOf } from './body.js';
import { css } from './palette.js';

/// The copies' slider has this many steps, spaced evenly in the logarithm.
const STEPS = 1000;
/// A legend of more entries would say nothing.
const LONGEST_LEGEND = 14;

const NAMES = {
  space: { half: 'upper half space', ball: 'Poincar\u00e9 ball', klein: 'Klein ball' },
  vertical: { half: 'upper half plane', ball: 'Poincar\u00e9 disk', klein: 'Klein disk' },
  horizontal: { half: 'horosphere' },
};
const CLASS_NAMES = {
  tetrahedron: ['tetrahedron', 'tetrahedra'],
  face: ['face', 'faces'],
  boundary: ['component', 'components'],
  edge: ['edge', 'edges'],
  word: ['letter', 'letters'],
};

const element = (id) => document.getElementById(id);

function fill(select, options) {
  select.replaceChildren(...options.map(([value, text]) => new Option(text, value)));
}

export class Panel {
  /// `change` is called with the settings that someone changed; `reset` and `save` when their buttons are
  /// pressed.
  constructor(scene, { change, reset, save }) {
    this.scene = scene;
    this.change = change;
    fill(
      element('body'),
      scene.bodies.map((body, i) => [i, body.name]),
    );
    this.listen('body', 'change', (control) => ({ body: Number(control.value) }));
    this.listen('model', 'change', (control) => ({ model: control.value }));
    this.listen('colour', 'change', (control) => ({ colour: control.value }));
    this.listen('copies', 'input', (control) => ({ copies: this.copiesAt(control.valueAsNumber) }));
    this.listen('copies-number', 'change', (control) =>
      control.valueAsNumber >= 1 ? { copies: control.valueAsNumber } : {},
    );
    this.listen('explode', 'input', (control) => ({ explode: control.valueAsNumber }));
    this.listen('opacity', 'input', (control) => ({ opacity: control.valueAsNumber }));
    for (const id of ['faces', 'boundary', 'edges'])
      this.listen(id, 'change', (control) => ({ [id]: control.checked }));
    element('reset').addEventListener('click', reset);
    element('save').addEventListener('click', save);
  }

  listen(id, event, read) {
    element(id).addEventListener(event, ({ target }) => this.change(read(target)));
  }

  copiesAt(step) {
    return Math.round(Math.exp((step / STEPS) * Math.log(this.most)));
  }

  show(settings) {
    const body = this.scene.bodies[settings.body];
    if (this.body !== body) this.showBody(body);
    element('body').value = settings.body;
    element('model').value = settings.model;
    element('colour').value = settings.colour;
    for (const id of ['faces', 'boundary', 'edges']) element(id).checked = settings[id];
    for (const id of ['explode', 'opacity']) element(id).value = settings[id];
    element('copies-number').value = settings.copies;
    if (this.copiesAt(element('copies').valueAsNumber) !== settings.copies)
      element('copies').value = this.most > 1 ? (STEPS * Math.log(settings.copies)) / Math.log(this.most) : 0;
    element('copies').setAttribute('aria-valuetext', `${settings.copies} of ${this.most}`);
    this.showLegend(body, settings);
  }

  showBody(body) {
    this.body = body;
    this.most = body.copies.count;
    fill(element('model'), Object.entries(NAMES[body.view]));
    element('model').disabled = body.view === 'horizontal';
    element('copies').disabled = element('copies-number').disabled = this.most === 1;
    element('copies-number').max = this.most;
    element('copies-most').textContent = `of ${this.most}`;
    const has = (test) => body.surfaces.some(test);
    element('faces').disabled = element('opacity').disabled = !has((surface) => surface.kind === 'face');
    element('boundary').disabled = !has((surface) => surface.kind !== 'face');
    element('edges').disabled = body.tubes.starts.length < 2;
    element('hint').textContent =
      body.view === 'space'
        ? 'Drag to turn, scroll or pinch to come nearer, drag with the right button or two fingers to move.'
        : 'Drag to move, scroll or pinch to come nearer.';
  }

  showLegend(body, settings) {
    const count =
      settings.colour === 'word'
        ? this.longestShown(body, settings.copies) + 1
        : classCount(body, settings.colour);
    const all = classCount(body, settings.colour);
    const [one, many] = CLASS_NAMES[settings.colour];
    const legend = element('legend');
    const items = Array.from({ length: Math.min(count, LONGEST_LEGEND) }, (_, i) => {
      const item = document.createElement('li');
      const swatch = document.createElement('span');
      swatch.className = 'swatch';
      swatch.style.backgroundColor = css(tintOf(settings.colour, i, all));
      item.append(swatch, String(i));
      return item;
    });
    legend.replaceChildren(...items);
    legend.setAttribute('aria-label', `${count} ${count === 1 ? one : many}`);
    legend.dataset.more =
      count > LONGEST_LEGEND ? `\u2026 ${count} ${many}` : settings.colour === 'word' ? many : '';
  }

  longestShown(body, copies) {
    return body.copies.length.subarray(0, copies).reduce((a, b) => Math.max(a, b), 0);
  }
}

/// The names of the ways to colour must be those that the page offers.
export function checkOptions() {
  const offered = Array.from(element('colour').options, (option) => option.value);
  return (
    Object.keys(COLOURINGS).every((name) => offered.includes(name)) &&
    offered.length === Object.keys(COLOURINGS).length
  );
}
