// SPDX-License-Identifier: GPL-2.0-or-later
// The picture: the panes side by side, or one above the other where it is higher than wide.
import { THEMES } from '../palette.js';
import { Screen } from '../screen.js';
import { Pane } from './pane.js';

/// What is dragged: an element over a pane's part of the canvas, with the pane's name.
function handle({ name }) {
  const element = document.createElement('div');
  element.className = 'pane';
  element.tabIndex = 0;
  element.setAttribute('role', 'application');
  element.setAttribute(
    'aria-label',
    `Picture of ${name}. Arrow keys turn or move it, plus and minus come nearer and go away.`,
  );
  const caption = document.createElement('span');
  caption.textContent = name;
  element.append(caption);
  return element;
}

export class Stage extends Screen {
  constructor(scene, canvas, context, onCamera) {
    super(canvas, context);
    canvas.tabIndex = -1;
    this.panes = scene.panes.map((pane) => {
      const element = handle(pane);
      canvas.parentElement.insertBefore(element, document.getElementById('message'));
      return new Pane(pane, scene.vByU, element, () => {
        this.draw();
        onCamera();
      });
    });
  }

  show(settings, theme) {
    this.setBackground(THEMES[theme].background, settings);
    for (const pane of this.panes) pane.show(settings, THEMES[theme]);
    this.draw();
  }

  /// See everything; the settings' camera is that of the first pane.
  fit(settings) {
    this.panes.forEach((pane, i) => pane.fit(i === 0 ? settings : {}));
    this.draw();
  }

  /// See everything again in another size, where nobody has placed the camera.
  refit() {
    for (const { cameras, frame } of this.panes)
      if (!cameras.placed) cameras.fit(frame, cameras.direction());
    this.draw();
  }

  arrange(width, height) {
    const count = this.panes.length;
    const stacked = height > width;
    this.areas = this.panes.map((_, i) =>
      stacked
        ? [0, ((count - 1 - i) * height) / count, width, height / count]
        : [(i * width) / count, 0, width / count, height],
    );
    this.canvas.parentElement.classList.toggle('stacked', stacked);
    this.panes.forEach(({ cameras }, i) => {
      const [, , paneWidth, paneHeight] = this.areas[i];
      cameras.resize(paneWidth / paneHeight);
    });
  }

  render() {
    this.panes.forEach((pane, i) => pane.render(this.painter, this.areas[i]));
  }
}
