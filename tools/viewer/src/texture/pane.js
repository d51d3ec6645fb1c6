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
import { mix, rgb } from '../palette.js';
import { patternFragment, PATTERNS, patternVertex } from './shaders.js';
import { normals, standing } from './shape.js';

const LINE_WIDTH = 3; // CSS pixels
/// Points that the camera is fitted to: enough for any surface's extent.
const PROBES = 5000;

function surface(pane, uniforms) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(pane.points, 3));
  if (!pane.flat) geometry.setAttribute('normal', new BufferAttribute(normals(pane), 3));
  geometry.setAttribute('uv', new BufferAttribute(pane.textures, 2));
  geometry.setIndex(new BufferAttribute(pane.triangles, 1));
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: patternVertex,
    fragmentShader: patternFragment,
    uniforms,
    side: DoubleSide,
    // The loops lie on it and are to be seen whole.
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 4,
  });
  return new Mesh(geometry, material);
}

/// Polylines as segments of the polylines' colours, above a rim that sets them off from any pattern.
function segments({ points, starts, colours }, flat) {
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
  const rim = new LineMaterial({ ...shared, linewidth: LINE_WIDTH + 1.5 });
  const core = new LineMaterial({ ...shared, linewidth: LINE_WIDTH, vertexColors: true });
  return [rim, core].map((material, i) => {
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
  constructor(pane, vByU, element, onCamera) {
    this.element = element;
    this.uniforms = {
      pattern: { value: 0 },
      squares: { value: 1 },
      vByU: { value: vByU },
      bright: { value: new Vector3() },
      dark: { value: new Vector3() },
      up: { value: new Vector3() },
      flatLook: { value: pane.flat },
    };
    this.first = (!pane.flat && standing(pane)) || FIRST_DIRECTION;
    this.lines = pane.lines.flatMap((lines) => segments(lines, pane.flat));
    this.scene = new Scene();
    this.scene.add(surface(pane, this.uniforms), ...this.lines);
    this.frame = probes(pane.points);
    this.cameras = new Cameras(element, onCamera);
    this.cameras.use(pane.flat ? 'horizontal' : 'space');
  }

  show({ pattern, squares, lines }, theme) {
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
