// SPDX-License-Identifier: GPL-2.0-or-later
// What is shown, and the page's address that says so: page.html#model=ball&copies=200&direction=1,-1,0.5
import {
  choice,
  COMMON_DEFAULTS,
  COMMON_READERS,
  flag,
  NOT_SET,
  number,
  readFragment,
  writeFragment,
} from './address.js';
import { COLOURINGS } from './body.js';
import { MODELS } from './models.js';

/// More copies than fill about this many triangles are shown only when asked for.
const FIRST_TRIANGLES = 400000;
const FIRST_COPIES = 400;

const DEFAULTS = {
  body: 0,
  model: 'half',
  copies: NOT_SET,
  explode: 0,
  colour: 'tetrahedron',
  faces: true,
  boundary: true,
  edges: true,
  opacity: 1,
  ...COMMON_DEFAULTS,
};

const READERS = {
  body: number(0, 1e6),
  model: choice(...MODELS),
  copies: number(1, 1e9),
  explode: number(0, 1),
  colour: choice(...Object.keys(COLOURINGS)),
  faces: flag,
  boundary: flag,
  edges: flag,
  opacity: number(0.05, 1),
  ...COMMON_READERS,
};

export const readHash = (hash) => readFragment(hash, DEFAULTS, READERS);
export const writeHash = (settings, body) =>
  writeFragment(settings, { ...DEFAULTS, copies: firstCopies(body) });

/// How many copies of a body are shown at first: one of a solid, as many as are quickly drawn of a tiling.
export function firstCopies(body) {
  const triangles = body.surfaces.reduce((sum, surface) => sum + surface.triangles.length / 3, 1);
  const wanted =
    body.shown ?? (body.view === 'space' ? 1 : Math.min(FIRST_COPIES, FIRST_TRIANGLES / triangles));
  return Math.max(1, Math.min(body.copies.count, Math.floor(wanted)));
}

/// The settings made possible: an existing body, a number of copies that it has, a model in which it can be
/// seen.
export function completed(settings, scene) {
  const index = Math.min(Math.floor(settings.body), scene.bodies.length - 1);
  const body = scene.bodies[index];
  return {
    ...settings,
    body: index,
    model: body.view === 'horizontal' ? 'half' : settings.model,
    copies:
      settings.copies === NOT_SET
        ? firstCopies(body)
        : Math.max(1, Math.min(body.copies.count, Math.floor(settings.copies))),
  };
}
