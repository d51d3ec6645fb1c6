// SPDX-License-Identifier: GPL-2.0-or-later
// Where in the model the copies shown lie: what the camera is fitted to.
import { anchor, placed } from './models.js';

/// Points looked at: enough for the extent of a body to within a few per cent, few enough for thousands of
/// copies.
const POINTS_PER_BODY = 400;
const FEWEST_POINTS = 8;
const POINTS_IN_ALL = 60000;

/// Points of a body, each with its tetrahedron's centre: the ends of the edges, which are its corners, and
/// some in between.
function samples(body, most) {
  const list = [];
  const add = (points, i, tetrahedron) =>
    list.push({ X: points.subarray(4 * i, 4 * i + 4), centre: body.tetrahedra[tetrahedron].centre });
  const thinned = (count, visit) => {
    const step = Math.max(1, Math.ceil((count * (body.surfaces.length + 1)) / most));
    for (let i = 0; i < count; i += step) visit(i);
  };
  const { points, starts, tetrahedron } = body.tubes;
  thinned(starts.length - 1, (line) => {
    add(points, starts[line], tetrahedron[line]);
    add(points, starts[line + 1] - 1, tetrahedron[line]);
  });
  for (const surface of body.surfaces)
    thinned(surface.tetrahedron.length, (i) => add(surface.points, i, surface.tetrahedron[i]));
  return list;
}

/// Points of the copies shown, in model coordinates: an array for each coordinate.
function visible(body, { model, copies, explode }) {
  const perCopy = Math.max(FEWEST_POINTS, Math.min(POINTS_PER_BODY, POINTS_IN_ALL / copies));
  const list = samples(body, perCopy);
  const stride = Math.max(1, Math.ceil((copies * FEWEST_POINTS) / POINTS_IN_ALL));
  const fixed = anchor(body, model);
  const coordinates = [[], [], []];
  for (let copy = 0; copy < copies; copy += stride)
    for (const { X, centre } of list) {
      const p = placed(body, model, copy, X);
      const c = explode ? placed(body, model, copy, centre) : fixed;
      const q = p.map((x, i) => x + explode * (c[i] - fixed[i]));
      if (q.every(Number.isFinite)) q.forEach((x, i) => coordinates[i].push(x));
    }
  return coordinates;
}

/// In the balls the whole sphere at infinity is shown once the body reaches this far towards it.
const WHOLE_BALL_FROM = 0.55;
/// A tiling of the half plane fills it: there this many heights of the first copy are shown.
const HEIGHTS = 2.4;

function box(points) {
  const low = [];
  const high = [];
  for (const values of points) {
    low.push(values.reduce((a, b) => Math.min(a, b), Infinity));
    high.push(values.reduce((a, b) => Math.max(a, b), -Infinity));
  }
  return { low, high };
}

/// What the camera shall see: the box {low, high} of the copies shown and `points` of them; or `ball` in
/// place of the points.
export function framed(body, settings) {
  const points = visible(body, settings);
  const all = box(points);
  if (settings.model === 'half') {
    if (body.view !== 'vertical') return { ...all, points };
    return { ...halfPlane(all, box(visible(body, { ...settings, copies: 1 }))), points };
  }
  const reach = Math.max(...all.low.map(Math.abs), ...all.high.map(Math.abs));
  if (reach < WHOLE_BALL_FROM || reach > 1) return { ...all, points };
  return { low: [-1, -1, -1], high: [1, 1, 1], ball: true };
}

/// A part of the half plane from a little below its axis upwards: large enough for the first copy and its
/// neighbours.
function halfPlane(all, first) {
  const height = Math.min(all.high[2], HEIGHTS * first.high[2]);
  const middle = (first.low[0] + first.high[0]) / 2;
  const width = Math.min(all.high[0] - all.low[0], height);
  return { low: [middle - width / 2, 0, -0.06 * height], high: [middle + width / 2, 0, height], axis: true };
}
