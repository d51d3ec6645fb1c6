// SPDX-License-Identifier: GPL-2.0-or-later
// One half of the picture: a surface with a pattern on it, its loops, and a camera of its own.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  GLSL3,
  Mesh,
  RawShaderMaterial,
  Scene,
  SRGBColorSpace,
  Vector3,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { NOT_SET } from '../address.js';
import { Cameras, FIRST_DIRECTION } from '../cameras.js';
import { mix, rgb, SCALE } from '../palette.js';
import { patternFragment, PATTERNS, patternVertex } from './shaders.js';
import { normals, range, splitByPatch, standing } from './shape.js';

const LINE_WIDTH = 3; // CSS pixels
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
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(pane.points, 3));
  if (!pane.flat) geometry.setAttribute('normal', new BufferAttribute(normals(pane), 3));
  geometry.setAttribute('uv', new BufferAttribute(pane.textures, 2));
  if (pane.field) geometry.setAttribute('value', new BufferAttribute(levels(pane.field), 1));
  if (pane.patches) geometry.setAttribute('patchColour', new BufferAttribute(patchColours(pane), 3, true));
  geometry.setIndex(new BufferAttribute(pane.triangles, 1));
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: patternVertex,
    fragmentShader: patternFragment,
    uniforms,
    side: DoubleSide,
    premultipliedAlpha: true,
    // The loops lie on it and are to be seen whole.
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 4,
  });
  return new Mesh(geometry, material);
}

/// Polylines as segments of the polylines' colours, above a rim that sets them off from any pattern.
function segments({ points, starts, colours, numbers }, flat) {
  const positions = [];
  const tints = [];
  colours.forEach((colour, line) => {
    const { r, g, b } = new Color().setRGB(...colour.map((x) => x / 255), SRGBColorSpace);
    for (let i = starts[line]; i + 1 < starts[line + 1]; ++i) {
      positions.push(...points.subarray(3 * i, 3 * i + 6));
      tints.push(r, g, b, r, g, b);
    }
  });
  const geometry = new LineSegmentsGeometry().setPositions(positions).setColors(tints);
  // Nothing in a plane is behind anything, and no part of a line behind another of its own.
  const shared = { depthTest: !flat, depthWrite: false };
  const core = new LineMaterial({
    ...shared,
    linewidth: numbers.length ? LINE_WIDTH : FIBER_WIDTH,
    vertexColors: true,
  });
  const rim = new LineMaterial({ ...shared, linewidth: LINE_WIDTH + 1.5 });
  return (numbers.length ? [rim, core] : [core]).map((material, i) => {
    const lines = new LineSegments2(geometry, material);
    lines.renderOrder = 1 + i;
    return lines;
  });
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
      bright: { value: new Vector3() },
      dark: { value: new Vector3() },
      up: { value: new Vector3() },
      flatLook: { value: pane.flat },
      opacity: { value: 1 },
      scale: { value: SCALE.map((colour) => new Vector3(...rgb(colour)).divideScalar(255)) },
    };
    this.first = (!pane.flat && standing(pane)) || FIRST_DIRECTION;
    this.lines = pane.lines.flatMap((lines) => segments(lines, pane.flat));
    this.scene = new Scene();
    this.surface = surface(pane, this.uniforms);
    this.scene.add(this.surface, ...this.lines);
    this.frame = probes(pane.points);
    this.cameras = new Cameras(element, onCamera);
    this.cameras.use(pane.flat ? 'horizontal' : 'space');
  }

  show({ pattern, squares, lines, inside }, theme) {
    const { material } = this.surface;
    material.transparent = inside;
    material.depthWrite = !inside;
    this.uniforms.opacity.value = inside ? GLASS : 1;
    this.uniforms.pattern.value = PATTERNS.indexOf(pattern);
    this.uniforms.squares.value = squares;
    this.uniforms.bright.value.fromArray(rgb(theme.paper)).divideScalar(255);
    this.uniforms.dark.value.fromArray(mix(rgb('#2f4858'), rgb(theme.paper), 0.12)).divideScalar(255);
    for (const line of this.lines) {
      line.visible = lines;
      if (!line.material.vertexColors) line.material.color.set(theme.rim);
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
  render(renderer, [x, y, width, height]) {
    const { camera } = this.cameras;
    this.cameras.measure(height, 0);
    camera.updateMatrixWorld();
    this.uniforms.up.value.set(0, 0, 1).transformDirection(camera.matrixWorldInverse);
    renderer.setViewport(x, y, width, height);
    renderer.setScissor(x, y, width, height);
    renderer.render(this.scene, camera);
  }
}
