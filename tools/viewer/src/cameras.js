// SPDX-License-Identifier: GPL-2.0-or-later
// Two cameras: one that turns around a solid, and one that moves over a plane.
import { FlatCamera, SolidCamera } from './camera.js';
import { fitPoints } from './fit.js';
import { follow } from './hands.js';

const FIELD = Math.PI / 6; // upwards
const KEY_STEP = Math.PI / 36;
const KEY_PIXELS = 40;
const KEY_ZOOM = 1.1;
export const FIRST_DIRECTION = [0.5, -0.78, 0.38];

/// Where a planar camera stands, seen from what it looks at, and what is upwards.
const PLANAR = {
  vertical: [
    [0, -1, 0],
    [0, 0, 1],
  ],
  horizontal: [
    [0, 0, 1],
    [0, 1, 0],
  ],
};

export class Cameras {
  constructor(element, onChange) {
    this.element = element;
    this.onChange = onChange;
    this.solid = new SolidCamera(FIELD);
    this.flat = new FlatCamera();
    this.view = 'space';
    this.radius = 1;
    this.fitted = 1;
    follow(element, {
      begin: () => (this.before = this.standing()),
      turn: (dx, dy) => this.drag(dx, dy),
      move: (dx, dy) => this.move(dx, dy),
      zoom: (factor, at) => this.zoomBy(factor, at),
      // A picture whose size or place someone chose is not fitted again behind their back.
      end: () => (this.placed ||= this.before !== this.standing()),
    });
    element.addEventListener('keydown', (event) => this.key(event));
  }

  get planar() {
    return this.view !== 'space';
  }
  get camera() {
    return this.planar ? this.flat : this.solid;
  }
  get height() {
    return this.element.clientHeight;
  }

  use(view) {
    this.view = view;
    if (this.planar) this.flat.face(...PLANAR[view]);
  }

  /// See what is framed (bounds.js), a solid from the given direction.
  fit({ low, high, points, ball, axis }, direction) {
    const middle = low.map((x, i) => (x + high[i]) / 2);
    const size = low.map((x, i) => Math.max(high[i] - x, 1e-9));
    this.radius = ball ? 1 : Math.hypot(...size) / 2;
    this.placed = false;
    if (this.planar) this.fitPlane(middle, size, axis);
    else this.fitSolid(direction, ball ? null : points);
  }

  fitSolid(direction, points) {
    const { solid } = this;
    const narrow = Math.atan(solid.upward * Math.min(1, solid.aspect));
    const { target, distance } = points
      ? fitPoints(points, direction, [solid.upward * solid.aspect, solid.upward])
      : { target: [0, 0, 0], distance: 1.04 / Math.sin(narrow) };
    this.fitted = distance;
    solid.target = target;
    solid.distance = distance;
    solid.range = [distance / 200, distance * 6];
    solid.lookFrom(direction);
  }

  fitPlane(middle, size, axis) {
    const { flat } = this;
    const [width, height] = this.view === 'vertical' ? [size[0], size[2]] : [size[0], size[1]];
    flat.extent = 0.52 * Math.max(height, width / flat.aspect);
    // Where the picture is taller than what it shows, an axis at infinity stays near its lower edge.
    if (axis) middle[2] += flat.extent - 0.52 * height;
    flat.target = middle;
    flat.magnified = 1;
    flat.range = [0.1, 2000];
  }

  resize(aspect) {
    this.solid.aspect = aspect;
    this.flat.aspect = aspect;
  }

  /// The unit vector from what is looked at to the camera.
  direction() {
    return this.solid.direction;
  }

  zoom() {
    return this.planar ? this.flat.magnified : this.fitted / this.solid.distance;
  }

  target() {
    return [...this.camera.target];
  }

  standing() {
    return [this.zoom(), ...this.target()].join();
  }

  /// Come nearer by a factor, and look at another point.
  place({ zoom, target }) {
    this.placed = true;
    if (target) this.camera.target = [...target];
    if (zoom) this.camera.zoom(zoom / this.zoom());
  }

  /// Set the near and far planes for the next picture, and say where things are in it: the depths between
  /// which they fade, how far it reaches from its middle, and the size of a pixel (at distance 1 in
  /// perspective) when it is `height` pixels high.
  measure(height, ground) {
    if (this.planar) {
      const reach = this.flat.halves[1];
      return { near: 0, far: 1, reach, pixel: (2 * reach) / height };
    }
    const { distance, upward } = this.solid;
    this.solid.depths = [
      Math.max(distance - 3 * this.radius, distance / 100, this.radius / 1000),
      distance + Math.max(3 * this.radius, 2 * ground),
    ];
    return {
      near: distance - 0.3 * this.radius,
      far: distance + this.radius,
      reach: upward * distance,
      pixel: (2 * upward) / height,
    };
  }

  /// A solid turns, a plane moves.
  drag(dx, dy) {
    if (this.planar) return this.move(dx, dy);
    const angle = (2 * Math.PI) / this.height;
    this.turn(dx * angle, dy * angle);
  }

  turn(right, down) {
    this.solid.turn(right, down);
    this.onChange();
  }

  move(dx, dy) {
    this.camera.move(dx, dy, this.height);
    this.onChange();
  }

  zoomBy(factor, at) {
    this.camera.zoom(factor, at);
    this.onChange();
  }

  key(event) {
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const step = steps[event.key];
    if (step && this.planar) this.move(-KEY_PIXELS * step[0], -KEY_PIXELS * step[1]);
    else if (step) this.turn(step[0] * KEY_STEP, step[1] * KEY_STEP);
    else if (event.key === '+' || event.key === '=') this.zoomBy(KEY_ZOOM);
    else if (event.key === '-') this.zoomBy(1 / KEY_ZOOM);
    else return;
    this.placed ||= !step || this.planar;
    event.preventDefault();
  }
}
