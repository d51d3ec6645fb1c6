// SPDX-License-Identifier: GPL-2.0-or-later
// The page: reads the scene, wires the controls to the picture.
import { Panel } from './panel.js';
import { readScene, SceneError } from './scene.js';
import { completed, NOT_SET, readHash, writeHash } from './settings.js';
import { Stage } from './stage.js';
import { showTables } from './tables.js';

/// Browsers refuse frequent changes of the address.
const ADDRESS_DELAY = 400; // milliseconds

function complain(message) {
  const place = document.getElementById('message');
  place.textContent = message;
  place.hidden = false;
  document.getElementById('controls').hidden = true;
  document.documentElement.dataset.ready = 'no';
}

/// three.js would report a missing WebGL as an error on the console; we say it on the page.
function contextOf(canvas) {
  return canvas.getContext('webgl2', { antialias: true, alpha: true, powerPreference: 'high-performance' });
}

class Page {
  constructor(scene, context, canvas) {
    this.scene = scene;
    this.canvas = canvas;
    this.dark = matchMedia('(prefers-color-scheme: dark)');
    this.stage = new Stage(canvas, context, () => this.noteAddress());
    this.panel = new Panel(scene, {
      change: (part) => this.change(part),
      reset: () => this.reset(),
      save: () => this.save(),
    });
    this.read(location.hash);
    this.dark.addEventListener('change', () => this.show());
    addEventListener('hashchange', () => {
      if (location.hash !== this.written) this.read(location.hash);
    });
    new ResizeObserver(() => this.stage.resize()).observe(canvas.parentElement);
  }

  get body() {
    return this.scene.bodies[this.settings.body];
  }

  /// Show what an address says.
  read(hash) {
    this.settings = completed(readHash(hash), this.scene);
    const { panel, theme } = this.settings;
    document.documentElement.classList.toggle('bare', !panel);
    document.documentElement.dataset.theme = theme;
    this.stage.resize();
    this.show();
    this.stage.fit(this.settings);
  }

  /// Show the settings, some of which changed.
  change(part) {
    const another = 'body' in part && part.body !== this.settings.body;
    const direction = this.stage.direction(this.body);
    const next = another ? { ...part, copies: NOT_SET } : part;
    this.settings = completed(
      { ...this.settings, ...next, direction, zoom: NOT_SET, target: NOT_SET },
      this.scene,
    );
    this.show();
    if (another || 'model' in part || !this.stage.placed) this.stage.fit(this.settings);
    this.noteAddress();
  }

  reset() {
    this.settings = { ...this.settings, direction: NOT_SET, zoom: NOT_SET, target: NOT_SET };
    this.stage.fit(this.settings);
    this.noteAddress();
  }

  show() {
    const theme =
      this.settings.theme === 'auto' ? (this.dark.matches ? 'dark' : 'light') : this.settings.theme;
    this.panel.show(this.settings);
    this.stage.show(this.body, this.settings, theme);
    const name = this.body.name;
    document.getElementById('caption').textContent = name;
    this.canvas.setAttribute(
      'aria-label',
      `Picture of ${this.scene.title}: ${name}. Arrow keys turn or move it, plus and minus come nearer and go away.`,
    );
  }

  /// Keep the address up to date, so that it can be copied; later, not with each motion of the mouse.
  noteAddress() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.settings = { ...this.settings, ...this.stage.camera(this.body) };
      this.written = writeHash(this.settings, this.body);
      history.replaceState(null, '', this.written || location.pathname + location.search);
    }, ADDRESS_DELAY);
  }

  async save() {
    const { clientWidth, clientHeight } = this.canvas;
    const link = document.createElement('a');
    link.href = await this.stage.picture(clientWidth, clientHeight, 2, 1);
    link.download = `${this.scene.title} ${this.body.name}.png`.replaceAll(/[^\w.()-]+/g, '_');
    link.click();
  }
}

function start() {
  const canvas = document.getElementById('canvas');
  let scene;
  try {
    scene = readScene(document.getElementById('tetrarch-scene').textContent);
  } catch (error) {
    if (!(error instanceof SceneError)) throw error;
    return complain(error.message);
  }
  document.title = `${scene.title} · Tetrarch`;
  document.getElementById('title').textContent = scene.title;
  showTables(scene.tables, document.getElementById('tables'));
  const context = contextOf(canvas);
  if (!context)
    return complain(
      'This browser shows no WebGL 2, which the picture needs. The tables can be read all the same.',
    );
  const page = new Page(scene, context, canvas);
  // For tests and for making pictures: what is shown, how many pictures were drawn, and a picture as a data:
  // address.
  window.tetrarch = {
    settings: () => ({ ...page.settings, ...page.stage.camera(page.body) }),
    set: (part) => page.change(part),
    drawn: () => page.stage.drawn,
    picture: (width, height) => page.stage.picture(width, height, 1, 2),
  };
}

start();
