// SPDX-License-Identifier: GPL-2.0-or-later
// The picture: camera, scenery and the body shown.
import { NOT_SET } from './address.js';
import { BodyView } from './body.js';
import { framed } from './bounds.js';
import { Cameras, FIRST_DIRECTION } from './cameras.js';
import { THEMES } from './palette.js';
import { Scenery } from './scenery.js';
import { Screen } from './screen.js';

export class Stage extends Screen {
  constructor(canvas, context, onCamera) {
    super(canvas, context);
    this.scenery = new Scenery();
    this.cameras = new Cameras(canvas, () => {
      this.draw();
      onCamera();
    });
  }

  get placed() {
    return this.cameras.placed;
  }

  /// Show a body as the settings say.
  show(body, settings, theme) {
    this.theme = THEMES[theme];
    if (this.view?.body !== body) {
      if (this.view) this.painter.forget(this.view.things);
      this.view = new BodyView(body);
      this.cameras.use(body.view);
    }
    this.view.update(settings, this.theme);
    this.frame = framed(body, settings);
    this.scenery.update(body.view, settings, this.theme, this.frame);
    this.setBackground(this.theme.background, settings);
    this.draw();
  }

  fit(settings) {
    this.cameras.fit(this.frame, settings.direction ?? FIRST_DIRECTION);
    if (settings.zoom || settings.target) this.cameras.place(settings);
    this.draw();
  }

  /// See everything again in another size, unless someone has placed the camera.
  refit() {
    if (this.frame && !this.placed) this.cameras.fit(this.frame, this.cameras.direction());
    this.draw();
  }

  direction(body) {
    return body.view === 'space' ? this.cameras.direction() : NOT_SET;
  }

  /// The camera's part of the settings: nothing where it stands as it was fitted.
  camera(body) {
    const direction = this.direction(body);
    const first =
      direction &&
      Math.hypot(...direction.map((x, i) => x - FIRST_DIRECTION[i] / Math.hypot(...FIRST_DIRECTION))) < 1e-3;
    return {
      direction: first ? NOT_SET : direction,
      zoom: this.placed ? this.cameras.zoom() : NOT_SET,
      target: this.placed ? this.cameras.target() : NOT_SET,
    };
  }

  arrange(width, height) {
    this.cameras.resize(width / height);
  }

  render() {
    if (!this.view) return;
    const { cameras } = this;
    const measures = cameras.measure(this.size[1], this.scenery.radius);
    this.view.look(cameras.camera, measures);
    if (cameras.planar) this.scenery.look(this.view.body.view, cameras.camera, this.density);
    this.painter.render([...this.scenery.things, ...this.view.things], cameras.camera);
  }
}
