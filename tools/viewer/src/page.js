// SPDX-License-Identifier: GPL-2.0-or-later
// What every page does: it reads its data, or says why it cannot; follows its address and keeps it up to date;
// follows the reader's preference for dark pages; saves pictures.
import { NOT_SET } from './address.js';
import { showTables } from './tables.js';
import { SceneError } from './unpack.js';

/// Browsers refuse frequent changes of the address.
const ADDRESS_DELAY = 400; // milliseconds

/// Derived pages have a `stage` and a `panel`, then call `begin`. They say how settings are read from an
/// address (`fromAddress`) and written to one (`toAddress`), how they are shown (`show`), what the camera's
/// part of them is (`camera`), and what a picture is called (`pictureName`).
export class Page {
  constructor(scene, canvas) {
    this.scene = scene;
    this.canvas = canvas;
    this.dark = matchMedia('(prefers-color-scheme: dark)');
  }

  begin() {
    this.read(location.hash);
    this.dark.addEventListener('change', () => this.show());
    addEventListener('hashchange', () => {
      if (location.hash !== this.written) this.read(location.hash);
    });
    new ResizeObserver(() => {
      this.stage.resize();
      this.stage.refit();
    }).observe(this.canvas.parentElement);
  }

  /// light or dark.
  get theme() {
    const { theme } = this.settings;
    return theme === 'auto' ? (this.dark.matches ? 'dark' : 'light') : theme;
  }

  /// Show what an address says.
  read(hash) {
    this.settings = this.fromAddress(hash);
    const { panel, theme } = this.settings;
    document.documentElement.classList.toggle('bare', !panel);
    document.documentElement.dataset.theme = theme;
    this.stage.resize();
    this.show();
    this.stage.fit(this.settings);
  }

  reset() {
    this.settings = { ...this.settings, direction: NOT_SET, zoom: NOT_SET, target: NOT_SET };
    this.stage.fit(this.settings);
    this.noteAddress();
  }

  /// Keep the address up to date, so that it can be copied; later, not with each motion of the mouse.
  noteAddress() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.settings = { ...this.settings, ...this.camera() };
      this.written = this.toAddress();
      history.replaceState(null, '', this.written || location.pathname + location.search);
    }, ADDRESS_DELAY);
  }

  async save() {
    const { clientWidth, clientHeight } = this.canvas;
    const link = document.createElement('a');
    link.href = await this.stage.picture(clientWidth, clientHeight, 2, 1);
    link.download = `${this.pictureName()}.png`.replaceAll(/[^\w.()-]+/g, '_');
    link.click();
  }
}

function complain(message) {
  const place = document.getElementById('message');
  place.textContent = message;
  place.hidden = false;
  document.getElementById('controls').hidden = true;
  document.documentElement.dataset.ready = 'no';
}

function contextOf(canvas) {
  return canvas.getContext('webgl2', { antialias: true, alpha: true, powerPreference: 'high-performance' });
}

/// `readScene` reads the page's data, `make(scene, context, canvas)` makes the page.
export function open(readScene, make) {
  const canvas = document.getElementById('canvas');
  let scene;
  try {
    scene = readScene(document.getElementById('tetrarch-scene').textContent);
  } catch (error) {
    if (!(error instanceof SceneError)) throw error;
    return complain(error.message);
  }
  document.title = `${scene.title} \u00b7 Tetrarch`;
  document.getElementById('title').textContent = scene.title;
  showTables(scene.tables, document.getElementById('tables'));
  const context = contextOf(canvas);
  if (!context)
    return complain(
      'This browser shows no WebGL 2, which the picture needs. The tables can be read all the same.',
    );
  const page = make(scene, context, canvas);
  // For tests and for making pictures: what is shown, how many pictures were drawn, and a picture as a data:
  // address.
  window.tetrarch = {
    settings: () => ({ ...page.settings, ...page.camera() }),
    set: (part) => page.change(part),
    drawn: () => page.stage.drawn,
    picture: (width, height) => page.stage.picture(width, height, 1, 2),
  };
}
