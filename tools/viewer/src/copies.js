// SPDX-License-Identifier: GPL-2.0-or-later
// Which copies are drawn, and how finely. Most copies of a large piece of the universal cover are a few
// pixels wide: they get coarse surfaces and thin prisms for edges, and those that would not be seen at all
// are left out.
import { placed } from './models.js';
import { attribute } from './painter.js';

/// Sizes in units of what the picture shows, from its middle to its rim.
const FINE_FROM = 0.05;
const EDGES_FROM = 0.01;
const SEEN_FROM = 0.0015;
/// The picture may be magnified this much before the choice is made anew.
const SLACK = 1.5;
/// Points of a body by which its size is measured.
const PROBES = 12;

/// The motions of some copies as the shaders read them: a matrix, and the word's length and whether the
/// motion is a mirror.
class Instances {
  constructor(capacity) {
    this.motion = attribute(new Float32Array(16 * capacity), 16, { instanced: true });
    this.traits = attribute(new Float32Array(2 * capacity), 2, { instanced: true });
    this.count = 0;
  }

  fill(copies, mirrored, order, first, last) {
    this.count = last - first;
    for (let i = first; i < last; ++i) {
      const copy = order[i];
      this.motion.array.set(copies.matrices.subarray(16 * copy, 16 * copy + 16), 16 * (i - first));
      this.traits.array.set([copies.length[copy], mirrored[copy]], 2 * (i - first));
    }
    for (const changed of [this.motion, this.traits]) {
      changed.used = this.count * changed.size;
      ++changed.version;
    }
  }
}

/// The sign of a Lorentz matrix' determinant is that of its upper left block's, which has no cancellation: 1
/// for a mirror.
function mirrors({ matrices, count }) {
  return Uint8Array.from({ length: count }, (_, copy) => {
    const [a, b, c] = [0, 1, 2].map((column) =>
      matrices.subarray(16 * copy + 4 * column, 16 * copy + 4 * column + 3),
    );
    return (
      a[0] * (b[1] * c[2] - b[2] * c[1]) -
        a[1] * (b[0] * c[2] - b[2] * c[0]) +
        a[2] * (b[0] * c[1] - b[1] * c[0]) <
      0
    );
  });
}

export class Copies {
  constructor(body) {
    this.body = body;
    this.mirrored = mirrors(body.copies);
    this.near = new Instances(body.copies.count);
    this.far = new Instances(body.copies.count);
    const points = (body.surfaces[0] ?? body.tubes).points;
    this.probes = Array.from(
      { length: PROBES },
      (_, i) => 4 * Math.floor((i * (points.length / 4 - 1)) / (PROBES - 1)),
    ).map((start) => points.subarray(start, start + 4));
  }

  /// About half the width of a copy in a model.
  size(model, copy) {
    const seen = this.probes.map((X) => placed(this.body, model, copy, X));
    const widths = [0, 1, 2].map(
      (i) => Math.max(...seen.map((p) => p[i])) - Math.min(...seen.map((p) => p[i])),
    );
    return Math.hypot(...widths) / 2;
  }

  /// Look at the first `count` copies in a model.
  choose(model, count) {
    if (this.model === model && this.order.length === count) return;
    this.model = model;
    const sizes = Float64Array.from({ length: count }, (_, copy) => this.size(model, copy));
    this.order = Array.from({ length: count }, (_, i) => i).sort((i, j) => sizes[j] - sizes[i] || i - j);
    this.sizes = this.order.map((copy) => sizes[copy]);
    this.chosenFor = 0;
  }

  /// Distribute the copies for a picture that shows `reach` around its middle. Says whether that changed
  /// anything.
  distribute(reach) {
    if (this.chosenFor && reach < this.chosenFor * SLACK && reach > this.chosenFor / SLACK) return false;
    this.chosenFor = reach;
    const until = (size) => {
      const i = this.sizes.findIndex((s) => s < size * reach);
      return i < 0 ? this.sizes.length : i;
    };
    const [fine, edged, seen] = [FINE_FROM, EDGES_FROM, SEEN_FROM].map(until);
    this.near.fill(this.body.copies, this.mirrored, this.order, 0, fine);
    this.far.fill(this.body.copies, this.mirrored, this.order, fine, seen);
    this.farEdges = edged - fine;
    return true;
  }
}
