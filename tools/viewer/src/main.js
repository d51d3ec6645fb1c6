// SPDX-License-Identifier: GPL-2.0-or-later
// The page that `tetrarch view` writes: wires the controls to the picture.
import { NOT_SET } from './address.js';
import { open, Page } from './page.js';
import { Panel } from './panel.js';
import { readScene } from './scene.js';
import { completed, readHash, writeHash } from './settings.js';
import { Stage } from './stage.js';

class ViewPage extends Page {
  constructor(scene, context, canvas) {
    super(scene, canvas);
    this.stage = new Stage(canvas, context, () => this.noteAddress());
    this.panel = new Panel(scene, {
      change: (part) => this.change(part),
      reset: () => this.reset(),
      save: () => this.save(),
    });
    this.begin();
  }

  get body() {
    return this.scene.bodies[this.settings.body];
  }

  fromAddress(hash) {
    return completed(readHash(hash), this.scene);
  }
  toAddress() {
    return writeHash(this.settings, this.body);
  }
  camera() {
    return this.stage.camera(this.body);
  }
  pictureName() {
    return `${this.scene.title} ${this.body.name}`;
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

  show() {
    this.panel.show(this.settings);
    this.stage.show(this.body, this.settings, this.theme);
    const name = this.body.name;
    document.getElementById('caption').textContent = name;
    this.canvas.setAttribute(
      'aria-label',
      `Picture of ${this.scene.title}: ${name}. Arrow keys turn or move it, plus and minus come nearer and go away.`,
    );
  }
}

open(readScene, (scene, context, canvas) => new ViewPage(scene, context, canvas));
