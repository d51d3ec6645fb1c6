// SPDX-License-Identifier: GPL-2.0-or-later
// What stands around the bodies: the plane at infinity of the half space, the sphere at infinity of the
// balls, and the axis or circle at infinity behind planar bodies.
import {
  DoubleSide,
  GLSL3,
  Group,
  Mesh,
  PlaneGeometry,
  RawShaderMaterial,
  SphereGeometry,
  Vector2,
  Vector3,
} from 'three';
import { mix, rgb } from './palette.js';

const head = /* glsl */ `
precision highp float;
precision highp int;
`;

const solidVertex =
  head +
  /* glsl */ `
in vec3 position;
uniform mat4 modelMatrix;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
out vec3 place;
out vec3 seen;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  vec4 eye = viewMatrix * world;
  place = world.xyz;
  seen = eye.xyz;
  gl_Position = projectionMatrix * eye;
}
`;

/// How much of a pixel a line covers whose distance is given in units of which the pixel's share is known.
const lines = /* glsl */ `
float covered(float distance, float width) { return clamp(0.5 + 0.5 * width - distance / fwidth(distance), 0.0, 1.0); }
float grid(vec2 p, float spacing) {
  vec2 cells = p / spacing;
  vec2 wide = fwidth(cells);
  vec2 near = abs(cells - round(cells)) / wide;
  // Where cells are smaller than pixels a grid would only shimmer.
  vec2 visible = 1.0 - smoothstep(0.15, 0.5, wide);
  vec2 line = clamp(1.0 - near, 0.0, 1.0) * visible;
  return max(line.x, line.y);
}
`;

const groundFragment =
  head +
  lines +
  /* glsl */ `
in vec3 place;
uniform vec3 colour;
uniform vec3 lineColour;
uniform vec2 middle;
uniform float radius;
uniform float spacing;
out vec4 shown;
void main() {
  float away = length(place.xy - middle) / radius;
  float fade = 1.0 - smoothstep(0.35, 1.0, away);
  float line = 0.55 * grid(place.xy, spacing);
  shown = vec4(mix(colour, lineColour, line), fade * (0.55 + 0.45 * line));
}
`;

const shellFragment =
  head +
  /* glsl */ `
in vec3 place;
in vec3 seen;
uniform mat4 viewMatrix;
uniform vec3 lineColour;
uniform float strength;
out vec4 shown;
void main() {
  vec3 n = normalize(mat3(viewMatrix) * place);
  float grazing = 1.0 - abs(dot(n, normalize(seen)));
  shown = vec4(lineColour, strength * (0.06 + 0.5 * pow(grazing, 5.0)));
}
`;

const backdropVertex =
  head +
  /* glsl */ `
in vec3 position;
uniform vec2 middle;
uniform vec2 extent;
out vec2 place;
void main() {
  place = middle + extent * 2.0 * position.xy;
  gl_Position = vec4(2.0 * position.xy, 0.99999, 1.0);
}
`;

/// kind: 0 the upper half plane, 1 a disk, 2 a horosphere.
const backdropFragment =
  head +
  lines +
  /* glsl */ `
in vec2 place;
uniform int kind;
uniform vec3 colour;
uniform vec3 beyond;
uniform vec3 lineColour;
uniform float spacing;
uniform float width;
out vec4 shown;
void main() {
  if (kind == 2) {
    shown = vec4(mix(colour, lineColour, 0.3 * grid(place, spacing)), 1.0);
    return;
  }
  float inside = kind == 0 ? place.y : 1.0 - length(place);
  float pixel = fwidth(inside);
  vec3 area = mix(beyond, colour, clamp(0.5 + inside / pixel, 0.0, 1.0));
  shown = vec4(mix(area, lineColour, clamp(0.5 + 0.5 * width - abs(inside) / pixel, 0.0, 1.0)), 1.0);
}
`;

function mesh(geometry, vertexShader, fragmentShader, uniforms, options) {
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms,
    side: DoubleSide,
    ...options,
  });
  const made = new Mesh(geometry, material);
  made.frustumCulled = false;
  return made;
}

const colourUniform = () => ({ value: new Vector3() });
const setColour = (uniform, colour) => uniform.value.fromArray(colour).divideScalar(255);

/// The largest of 1, 2, 5, 10, ... times a power of ten that is at most x.
export function roundStep(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * [5, 2, 1].find((factor) => factor * power <= x * 1.0001);
}

export class Scenery {
  constructor() {
    const glass = { transparent: true, depthWrite: false };
    this.ground = mesh(
      new PlaneGeometry(2, 2),
      solidVertex,
      groundFragment,
      {
        colour: colourUniform(),
        lineColour: colourUniform(),
        middle: { value: new Vector2() },
        radius: { value: 1 },
        spacing: { value: 1 },
      },
      glass,
    );
    this.shell = mesh(
      new SphereGeometry(1, 96, 64),
      solidVertex,
      shellFragment,
      { lineColour: colourUniform(), strength: { value: 1 } },
      { ...glass, side: 0 },
    );
    this.backdrop = mesh(
      new PlaneGeometry(1, 1),
      backdropVertex,
      backdropFragment,
      {
        middle: { value: new Vector2() },
        extent: { value: new Vector2() },
        kind: { value: 0 },
        colour: colourUniform(),
        beyond: colourUniform(),
        lineColour: colourUniform(),
        spacing: { value: 1 },
        width: { value: 1.5 },
      },
      { depthTest: false, depthWrite: false },
    );
    this.ground.renderOrder = -1;
    this.shell.renderOrder = 3;
    this.backdrop.renderOrder = -2;
    this.object = new Group();
    this.object.add(this.ground, this.shell, this.backdrop);
  }

  /// Show what belongs to the view and model; `bounds` says where the ground's middle is and how wide it must
  /// be.
  update(view, settings, theme, { low, high }) {
    const planar = view !== 'space';
    this.ground.visible = !planar && settings.model === 'half';
    this.shell.visible = !planar && settings.model !== 'half';
    this.backdrop.visible = planar;
    const radius = 1.6 * Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    const middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
    const ground = this.ground.material.uniforms;
    this.radius = radius;
    this.ground.scale.set(radius, radius, 1);
    this.ground.position.set(...middle, 0);
    ground.radius.value = radius;
    ground.middle.value.fromArray(middle);
    ground.spacing.value = roundStep(radius / 6);
    this.shell.material.uniforms.strength.value = 1 - 0.7 * settings.explode;
    const backdrop = this.backdrop.material.uniforms;
    backdrop.kind.value = view === 'horizontal' ? 2 : settings.model === 'half' ? 0 : 1;
    setColour(ground.colour, rgb(theme.ground));
    setColour(backdrop.colour, rgb(theme.planar));
    setColour(backdrop.beyond, mix(rgb(theme.background), rgb(theme.ground), 0.75));
    for (const { material } of [this.ground, this.shell, this.backdrop])
      setColour(material.uniforms.lineColour, rgb(theme.line));
  }

  /// Before each picture of a planar body: what part of the plane it shows, and device pixels per CSS pixel.
  look(view, camera, density) {
    const backdrop = this.backdrop.material.uniforms;
    const { x, y, z } = camera.position;
    backdrop.middle.value.set(x, view === 'vertical' ? z : y);
    backdrop.extent.value.set(camera.right, camera.top).divideScalar(camera.zoom);
    backdrop.spacing.value = roundStep((2 * camera.top) / camera.zoom / 8);
    backdrop.width.value = 2 * density;
  }
}
