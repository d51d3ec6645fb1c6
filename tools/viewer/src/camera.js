// SPDX-License-Identifier: GPL-2.0-or-later
// The two kinds of camera. Each has a `view` (from the world to its eye) and a `projection`, and moves so that
// what lies under a finger follows it: `height` is that of its picture, in the same pixels as the motion.
import { cross, minus, parallel, perspective, plus, times, toEye, unit } from './linear.js';

/// Nobody looks straight along the axis that is upwards in the picture.
const POLE = 1e-6; // radians

/// Turns around a target, in perspective, with z upwards.
export class SolidCamera {
  constructor(field) {
    this.upward = Math.tan(field / 2);
    this.aspect = 1;
    this.target = [0, 0, 0];
    this.distance = 1;
    this.range = [0, Infinity];
    this.angles = [0, Math.PI / 2];
    this.depths = [0.01, 100];
  }

  /// The unit vector from the target to the camera.
  get direction() {
    const [round, down] = this.angles;
    return [Math.sin(down) * Math.sin(round), -Math.sin(down) * Math.cos(round), Math.cos(down)];
  }

  /// Look from a direction of any length.
  lookFrom(direction) {
    const [x, y, z] = unit(direction);
    this.angles = [Math.atan2(x, 0 - y), Math.acos(Math.max(-1, Math.min(1, z)))];
    this.turn(0, 0);
  }

  get axes() {
    const back = this.direction;
    const right = unit(cross([0, 0, 1], back));
    return [right, cross(back, right), back];
  }

  get view() {
    return toEye(plus(this.target, times(this.direction, this.distance)), ...this.axes);
  }

  get projection() {
    return perspective(this.upward, this.aspect, ...this.depths);
  }

  /// Turn by angles, as a globe does under a hand that moves to the right and down.
  turn(right, down) {
    const [round, from] = this.angles;
    this.angles = [round - right, Math.max(POLE, Math.min(Math.PI - POLE, from - down))];
  }

  move(dx, dy, height) {
    const [right, up] = this.axes;
    const pixel = (2 * this.upward * this.distance) / height;
    this.target = plus(this.target, plus(times(right, -dx * pixel), times(up, dy * pixel)));
  }

  zoom(factor) {
    const [nearest, farthest] = this.range;
    this.distance = Math.max(nearest, Math.min(farthest, this.distance / factor));
  }
}

/// Looks straight at a plane.
export class FlatCamera {
  constructor() {
    this.aspect = 1;
    this.target = [0, 0, 0];
    this.extent = 1;
    this.magnified = 1;
    this.range = [0, Infinity];
    this.face([0, 0, 1], [0, 1, 0]);
  }

  /// `back` leads from the plane to the camera.
  face(back, up) {
    this.axes = [cross(up, back), up, back];
  }

  /// Half the width and the height of what is seen.
  get halves() {
    const height = this.extent / this.magnified;
    return [height * this.aspect, height];
  }

  /// The camera is this far off, which says nothing but what may lie in front of the plane and behind it.
  get away() {
    return 100 * this.extent;
  }

  get view() {
    return toEye(plus(this.target, times(this.axes[2], this.away)), ...this.axes);
  }

  get projection() {
    return parallel(...this.halves, 0, 2 * this.away);
  }

  move(dx, dy, height) {
    const [right, up] = this.axes;
    const pixel = (2 * this.halves[1]) / height;
    this.target = plus(this.target, plus(times(right, -dx * pixel), times(up, dy * pixel)));
  }

  /// What is `at` a place of the picture, from (-1, -1) to (1, 1), stays there.
  zoom(factor, at = [0, 0]) {
    const [least, most] = this.range;
    const before = this.halves;
    this.magnified = Math.max(least, Math.min(most, this.magnified * factor));
    const [x, y] = minus(before, this.halves).map((gain, i) => gain * at[i]);
    const [right, up] = this.axes;
    this.target = plus(this.target, plus(times(right, x), times(up, y)));
  }
}
