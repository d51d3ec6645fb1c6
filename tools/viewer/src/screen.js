// SPDX-License-Identifier: GPL-2.0-or-later
// A canvas that is drawn when something changed, not all the time. What is drawn is the business of derived
// classes: `arrange` for another size, `render`.
import { times } from './linear.js';
import { Painter } from './painter.js';
import { rgb } from './palette.js';

/// More device pixels than this per CSS pixel cannot be seen, only waited for.
const DENSEST = 2;

export class Screen {
  constructor(canvas, context) {
    this.canvas = canvas;
    this.painter = new Painter(context, () => this.draw());
    this.drawn = 0;
    this.size = [1, 1];
    this.density = 1;
  }

  setBackground(colour, { background }) {
    this.painter.background = background === 'none' ? [0, 0, 0, 0] : [...times(rgb(colour), 1 / 255), 1];
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (!clientWidth || !clientHeight) return;
    this.setSize(clientWidth, clientHeight, Math.min(devicePixelRatio, DENSEST));
    this.draw();
  }

  setSize(width, height, density) {
    this.size = [width, height];
    this.density = density;
    this.painter.setSize(width, height, density);
    this.arrange(width, height);
  }

  draw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.render();
      ++this.drawn;
      document.documentElement.dataset.ready = '1';
    });
  }

  /// A PNG as a data: address, `density` pixels for each of width x height; drawn `finer` times as fine and
  /// averaged.
  async picture(width, height, density, finer) {
    const before = [...this.size, this.density];
    this.setSize(width, height, density * finer);
    this.render();
    const paper = document.createElement('canvas');
    paper.width = width * density;
    paper.height = height * density;
    const pen = paper.getContext('2d');
    pen.imageSmoothingQuality = 'high';
    pen.drawImage(this.canvas, 0, 0, paper.width, paper.height);
    this.setSize(...before);
    this.draw();
    return paper.toDataURL('image/png');
  }
}
