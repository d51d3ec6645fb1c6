// SPDX-License-Identifier: GPL-2.0-or-later
// One half of the picture: a surface with a pattern on it, its loops, and a camera of its own.
import { NOT_SET } from '../address.js';
import { Cameras, FIRST_DIRECTION } from '../cameras.js';
import { times } from '../linear.js';
import { attribute, thing } from '../painter.js';
import { mix, rgb, SCALE } from '../palette.js';
import { segments, wideLines } from './lines.js';
import { patternFragment, PATTERNS, patternVertex } from './shaders.js';
import { normals, range, splitByPatch, standing } from './shape.js';

const LINE_WIDTH = 3; // CSS pixels
const RIM_WIDTH = 4.5;
/// Fibres, of which there are many, and none has a name.
const FIBER_WIDTH = 1.2;
/// How opaque the surface is when one is to see inside.
const GLASS = 0.3;
/// Points that the camera is fitted to: enough for any surface's extent.
const PROBES = 5000;

/// The values of a field from 0, the lowest, to 1.
function levels({ values }) {
  const [low, high] = range(values);
  return values.map((x) => (x - low) / (high - low || 1));
}

function patchColours({ patches, patchOf }) {
  const colours = new Map(patches.list.map(({ number, colour }) => [number, colour]));
  return new Uint8Array(patchOf.flatMap((patch) => colours.get(patch)));
}

function surface(pane, uniforms) {
  const attributes = { position: attribute(pane.points, 3), uv: attribute(pane.textures, 2) };
  if (!pane.flat) attributes.normal = attribute(normals(pane), 3);
  if (pane.field) attributes.value = attribute(levels(pane.field), 1);
  if (pane.patches) attributes.patchColour = attribute(patchColours(pane), 3, { normalised: true });
  return thing({
    attributes,
    triangles: pane.triangles,
    vertex: patternVertex,
    fragment: patternFragment,
    uniforms,
    premultiplied: true,
    // The loops lie on it and are to be seen whole.
    behind: true,
  });
}

/// Polylines as segments of the polylines' colours, above a rim that sets them off from any pattern.
function polylines({ points, starts, colours, numbers }, flat) {
  const from = [];
  const to = [];
  const tints = [];
  colours.forEach((colour, line) => {
    for (let i = starts[line]; i + 1 < starts[line + 1]; ++i) {
      from.push(...points.subarray(3 * i, 3 * i + 3));
      to.push(...points.subarray(3 * i + 3, 3 * i + 6));
      tints.push(...times(colour, 1 / 255));
    }
  });
  const geometry = segments(from, to, tints);
  // Nothing in a plane is behind anything, and no part of a line behind another of its own.
  const state = { depthTest: !flat, depthWrite: false };
  if (!numbers.length) return [wideLines(geometry, FIBER_WIDTH, { ...state, order: 2 })];
  const rim = wideLines(geometry, RIM_WIDTH, { ...state, order: 1 });
  rim.uniforms.painted.value = true;
  return [rim, wideLines(geometry, LINE_WIDTH, { ...state, order: 2 })];
}

/// Some of the points, an array for each coordinate, and their box.
function probes(points) {
  const step = 3 * Math.ceil(points.length / 3 / PROBES);
  const coordinates = [0, 1, 2].map((k) => {
    const list = [];
    for (let i = k; i < points.length; i += step) list.push(points[i]);
    return list;
  });
  return {
    points: coordinates,
    low: coordinates.map((list) => Math.min(...list)),
    high: coordinates.map((list) => Math.max(...list)),
  };
}

export class Pane {
  /// `element` is what is dragged; `onCamera` is called when that moves the camera.
  constructor(given, vByU, element, onCamera) {
    const pane = given.patches ? splitByPatch(given) : given;
    this.element = element;
    this.uniforms = {
      pattern: { value: 0 },
      squares: { value: 1 },
      vByU: { value: vByU },
      // Walls may run along a coordinate line; it should not be one where colours change.
      shift: { value: pane.patches ? 0.25 : 0 },
      bright: { value: [1, 1, 1] },
      dark: { value: [0, 0, 0] },
      up: { value: [0, 1, 0] },
      flatLook: { value: pane.flat },
      opacity: { value: 1 },
      scale: { value: SCALE.map((colour) => times(rgb(colour), 1 / 255)) },
    };
    this.first = (!pane.flat && standing(pane)) || FIRST_DIRECTION;
    this.lines = pane.lines.flatMap((lines) => polylines(lines, pane.flat));
    this.surface = surface(pane, this.uniforms);
    this.frame = probes(pane.points);
    this.cameras = new Cameras(element, onCamera);
    this.cameras.use(pane.flat ? 'horizontal' : 'space');
  }

  show({ pattern, squares, lines, inside }, theme) {
    this.surface.transparent = inside;
    this.surface.depthWrite = !inside;
    this.uniforms.opacity.value = inside ? GLASS : 1;
    this.uniforms.pattern.value = PATTERNS.indexOf(pattern);
    this.uniforms.squares.value = squares;
    this.uniforms.bright.value = times(rgb(theme.paper), 1 / 255);
    this.uniforms.dark.value = times(mix(rgb('#2f4858'), rgb(theme.paper), 0.12), 1 / 255);
    for (const line of this.lines) {
      line.visible = lines;
      line.uniforms.paint.value = times(rgb(theme.rim), 1 / 255);
    }
  }

  fit(settings = {}) {
    this.cameras.fit(this.frame, settings.direction ?? this.first);
    if (settings.zoom || settings.target) this.cameras.place(settings);
  }

  /// The camera's part of the settings: nothing where it stands as it was fitted.
  camera() {
    const direction = this.cameras.direction();
    const length = Math.hypot(...this.first);
    const moved = Math.hypot(...direction.map((x, i) => x - this.first[i] / length)) > 1e-3;
    return {
      direction: moved ? direction : NOT_SET,
      zoom: this.cameras.placed ? this.cameras.zoom() : NOT_SET,
      target: this.cameras.placed ? this.cameras.target() : NOT_SET,
    };
  }

  /// Draw into a rectangle of the canvas, in CSS pixels from its lower left corner.
  render(painter, area) {
    const { camera } = this.cameras;
    this.cameras.measure(area[3], 0);
    this.uniforms.up.value = camera.axes.map((axis) => axis[2]);
    painter.render([this.surface, ...this.lines], camera, area);
  }
}
