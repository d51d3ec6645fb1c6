// SPDX-License-Identifier: GPL-2.0-or-later
// The picture: renderer, camera, scenery and the body shown. It draws when something changed, not all the
// time.
import { Color, Scene, WebGLRenderer } from 'three';
import { BodyView } from './body.js';
import { framed } from './bounds.js';
import { Cameras, FIRST_DIRECTION } from './cameras.js';
import { THEMES } from './palette.js';
import { Scenery } from './scenery.js';
import { NOT_SET } from './settings.js';

/// More device pixels than this per CSS pixel cannot be seen, only waited for.
const DENSEST = 2;

export class Stage {
  constructor(canvas, context, onCamera) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true });
    this.scene = new Scene();
    this.scenery = new Scenery();
    this.scene.add(this.scenery.object);
    this.cameras = new Cameras(canvas, () => {
      this.draw();
      onCamera();
    });
    this.drawn = 0;
    this.size = [1, 1];
    this.density = 1;
  }

  get placed() {
    return this.cameras.placed;
  }

  /// Show a body as the settings say.
  show(body, settings, theme) {
    this.theme = THEMES[theme];
    if (this.view?.body !== body) {
      if (this.view) {
        this.scene.remove(this.view.object);
        this.view.dispose();
      }
      this.view = new BodyView(body);
      this.scene.add(this.view.object);
      this.cameras.use(body.view);
    }
    this.view.update(settings, this.theme);
    this.frame = framed(body, settings);
    this.scenery.update(body.view, settings, this.theme, this.frame);
    this.renderer.setClearColor(new Color().setRGB(0, 0, 0), 0);
    this.renderer.setClearAlpha(settings.background === 'none' ? 0 : 1);
    if (settings.background !== 'none') this.renderer.setClearColor(this.theme.background, 1);
    this.draw();
  }

  fit(settings) {
    this.cameras.fit(this.frame, settings.direction ?? FIRST_DIRECTION);
    if (settings.zoom || settings.target) this.cameras.place(settings);
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

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (!clientWidth || !clientHeight) return;
    this.setSize(clientWidth, clientHeight, Math.min(devicePixelRatio, DENSEST));
    this.draw();
  }

  setSize(width, height, density) {
    this.size = [width, height];
    this.density = density;
    this.renderer.setPixelRatio(density);
    this.renderer.setSize(width, height, false);
    this.cameras.resize(width / height);
  }

  draw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.render();
      document.documentElement.dataset.ready = '1';
    });
  }

  render() {
    if (!this.view) return;
    const { cameras } = this;
    const measures = cameras.measure(this.size[1], this.scenery.radius);
    cameras.camera.updateMatrixWorld();
    this.view.look(cameras.camera, measures);
    if (cameras.planar) this.scenery.look(this.view.body.view, cameras.camera, this.density);
    this.renderer.render(this.scene, cameras.camera);
    ++this.drawn;
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
