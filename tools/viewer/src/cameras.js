// SPDX-License-Identifier: GPL-2.0-or-later
// Two cameras: one that orbits a solid, and one that pans over a plane.
import { MOUSE, OrthographicCamera, PerspectiveCamera, TOUCH, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { fitPoints } from './fit.js';

const FIELD = 30; // degrees, upwards
const KEY_STEP = Math.PI / 36;
export const FIRST_DIRECTION = [0.5, -0.78, 0.38];

/// Where a planar camera stands, seen from what it looks at.
const PLANAR = { vertical: [0, -1, 0], horizontal: [0, 0, 1] };

export class Cameras {
  constructor(canvas, onChange) {
    this.canvas = canvas;
    this.solid = new PerspectiveCamera(FIELD, 1, 0.01, 100);
    this.flat = new OrthographicCamera(-1, 1, 1, -1, 0, 10);
    this.orbit = this.controls(this.solid, canvas, onChange);
    this.pan = this.controls(this.flat, canvas, onChange);
    this.pan.enableRotate = false;
    this.pan.zoomToCursor = true;
    this.pan.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
    this.pan.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    this.view = 'space';
    this.aspect = 1;
    this.radius = 1;
    this.fitted = 1;
    canvas.addEventListener('keydown', (event) => this.key(event));
  }

  controls(camera, canvas, onChange) {
    camera.up.set(0, 0, 1);
    const controls = new OrbitControls(camera, canvas);
    controls.addEventListener('change', () => {
      if (!this.quiet) onChange();
    });
    // A picture whose size or place someone chose is not fitted again behind their back.
    controls.addEventListener('start', () => {
      this.before = [this.zoom(), ...controls.target.toArray()].join();
    });
    controls.addEventListener('end', () => {
      if (this.before !== [this.zoom(), ...controls.target.toArray()].join()) this.placed = true;
    });
    return controls;
  }

  get planar() {
    return this.view !== 'space';
  }
  get camera() {
    return this.planar ? this.flat : this.solid;
  }
  get active() {
    return this.planar ? this.pan : this.orbit;
  }

  use(view) {
    this.view = view;
    this.orbit.enabled = !this.planar;
    this.pan.enabled = this.planar;
  }

  /// Change the camera without reporting it as someone's doing.
  quietly(change) {
    this.quiet = true;
    change();
    this.active.update();
    this.quiet = false;
  }

  /// See what is framed (bounds.js), a solid from the given direction.
  fit({ low, high, points, ball, axis }, direction) {
    const middle = low.map((x, i) => (x + high[i]) / 2);
    const size = low.map((x, i) => Math.max(high[i] - x, 1e-9));
    this.radius = ball ? 1 : Math.hypot(...size) / 2;
    this.placed = false;
    this.quietly(() => {
      if (this.planar) this.fitPlane(middle, size, axis);
      else this.fitSolid(direction, ball ? null : points);
    });
  }

  fitSolid(direction, points) {
    const upward = Math.tan((FIELD * Math.PI) / 360);
    const narrow = Math.atan(upward * Math.min(1, this.aspect));
    const fitted = points
      ? fitPoints(points, direction, [upward * this.aspect, upward])
      : { target: [0, 0, 0], distance: 1.04 / Math.sin(narrow) };
    this.fitted = fitted.distance;
    this.orbit.target.fromArray(fitted.target);
    this.solid.position.fromArray(direction).normalize().multiplyScalar(this.fitted).add(this.orbit.target);
    this.orbit.minDistance = this.fitted / 200;
    this.orbit.maxDistance = this.fitted * 6;
  }

  fitPlane(middle, size, axis) {
    const [width, height] = this.view === 'vertical' ? [size[0], size[2]] : [size[0], size[1]];
    this.extent = 0.52 * Math.max(height, width / this.aspect);
    // Where the picture is taller than what it shows, an axis at infinity stays near its lower edge.
    if (axis) middle[2] += this.extent - 0.52 * height;
    this.pan.target.fromArray(middle);
    this.flat.zoom = 1;
    this.flat.up.set(0, this.view === 'horizontal' ? 1 : 0, this.view === 'horizontal' ? 0 : 1);
    this.flat.position
      .fromArray(PLANAR[this.view])
      .multiplyScalar(100 * this.extent)
      .add(new Vector3().fromArray(middle));
    this.flat.near = 0;
    this.flat.far = 200 * this.extent;
    this.pan.minZoom = 0.1;
    this.pan.maxZoom = 2000;
    this.shape();
  }

  shape() {
    const height = this.extent ?? 1;
    this.flat.left = -height * this.aspect;
    this.flat.right = height * this.aspect;
    this.flat.top = height;
    this.flat.bottom = -height;
    this.flat.updateProjectionMatrix();
  }

  resize(aspect) {
    this.aspect = aspect;
    this.solid.aspect = aspect;
    this.shape();
  }

  /// The unit vector from what is looked at to the camera.
  direction() {
    return this.solid.position.clone().sub(this.orbit.target).normalize().toArray();
  }

  zoom() {
    return this.planar ? this.flat.zoom : this.fitted / this.solid.position.distanceTo(this.orbit.target);
  }

  target() {
    return this.active.target.toArray();
  }

  /// Come nearer by a factor, and look at another point.
  place({ zoom, target }) {
    this.placed = true;
    this.quietly(() => {
      const move = target ? new Vector3().fromArray(target).sub(this.active.target) : new Vector3();
      this.active.target.add(move);
      this.camera.position.add(move);
      if (!zoom) return;
      if (this.planar) this.flat.zoom = zoom;
      else
        this.solid.position
          .sub(this.orbit.target)
          .setLength(this.fitted / zoom)
          .add(this.orbit.target);
      this.flat.updateProjectionMatrix();
    });
  }

  /// Set the near and far planes for the next picture, and say where things are in it: the depths between
  /// which they fade, how far it reaches from its middle, and the size of a pixel (at distance 1 in
  /// perspective) when it is `height` pixels high.
  measure(height, ground) {
    if (this.planar) {
      const reach = this.extent / this.flat.zoom;
      return { near: 0, far: 1, reach, pixel: (2 * reach) / height };
    }
    const distance = this.solid.position.distanceTo(this.orbit.target);
    this.solid.near = Math.max(distance - 3 * this.radius, distance / 100, this.radius / 1000);
    this.solid.far = distance + Math.max(3 * this.radius, 2 * ground);
    this.solid.updateProjectionMatrix();
    const slope = Math.tan((FIELD * Math.PI) / 360);
    return {
      near: distance - 0.3 * this.radius,
      far: distance + this.radius,
      reach: slope * distance,
      pixel: (2 * slope) / height,
    };
  }

  key(event) {
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const step = steps[event.key];
    if (step && this.planar) this.active.pan(-40 * step[0], -40 * step[1]);
    else if (step) {
      this.orbit.rotateLeft(step[0] * KEY_STEP);
      this.orbit.rotateUp(step[1] * KEY_STEP);
    } else if (event.key === '+' || event.key === '=') this.active.dollyIn(1 / 1.1);
    else if (event.key === '-') this.active.dollyOut(1 / 1.1);
    else return;
    this.placed ||= !step || this.planar;
    this.active.update();
    event.preventDefault();
  }
}
