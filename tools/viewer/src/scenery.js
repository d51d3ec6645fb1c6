// SPDX-License-Identifier: GPL-2.0-or-later
// What stands around the bodies: the plane at infinity of the half space, the sphere at infinity of the
// balls, and the axis or circle at infinity behind planar bodies.
import { stretched, times } from './linear.js';
import { attribute, thing } from './painter.js';
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
  place = middle + extent * position.xy;
  gl_Position = vec4(position.xy, 0.99999, 1.0);
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

/// The square from (-1, -1) to (1, 1).
function square() {
  const corners = [-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0];
  return {
    attributes: { position: attribute(Float32Array.from(corners), 3) },
    triangles: Uint16Array.of(0, 1, 2, 2, 1, 3),
  };
}

/// The unit sphere by rows of points from pole to pole, `round` pieces in each.
function sphere(rows, round) {
  const points = [];
  const triangles = [];
  for (let i = 0; i <= rows; ++i)
    for (let j = 0; j <= round; ++j) {
      const [down, along] = [(Math.PI * i) / rows, (2 * Math.PI * j) / round];
      points.push(Math.sin(down) * Math.cos(along), Math.sin(down) * Math.sin(along), Math.cos(down));
      const [above, here] = [(i - 1) * (round + 1) + j, i * (round + 1) + j];
      if (i > 0 && j > 0) triangles.push(above - 1, here - 1, here, above - 1, here, above);
    }
  return {
    attributes: { position: attribute(Float32Array.from(points), 3) },
    triangles: Uint16Array.from(triangles),
  };
}

const colourUniform = () => ({ value: [0, 0, 0] });
const setColour = (uniform, colour) => (uniform.value = times(colour, 1 / 255));

/// The largest of 1, 2, 5, 10, ... times a power of ten that is at most x.
export function roundStep(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * [5, 2, 1].find((factor) => factor * power <= x * 1.0001);
}

export class Scenery {
  constructor() {
    const glass = { transparent: true, depthWrite: false };
    this.ground = thing({
      ...square(),
      ...glass,
      vertex: solidVertex,
      fragment: groundFragment,
      order: -1,
      uniforms: {
        colour: colourUniform(),
        lineColour: colourUniform(),
        middle: { value: [0, 0] },
        radius: { value: 1 },
        spacing: { value: 1 },
      },
    });
    this.shell = thing({
      ...sphere(64, 96),
      ...glass,
      vertex: solidVertex,
      fragment: shellFragment,
      order: 3,
      outside: true,
      uniforms: { lineColour: colourUniform(), strength: { value: 1 } },
    });
    this.backdrop = thing({
      ...square(),
      vertex: backdropVertex,
      fragment: backdropFragment,
      order: -2,
      depthTest: false,
      depthWrite: false,
      uniforms: {
        middle: { value: [0, 0] },
        extent: { value: [1, 1] },
        kind: { value: 0 },
        colour: colourUniform(),
        beyond: colourUniform(),
        lineColour: colourUniform(),
        spacing: { value: 1 },
        width: { value: 1.5 },
      },
    });
    this.things = [this.ground, this.shell, this.backdrop];
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
    const ground = this.ground.uniforms;
    this.radius = radius;
    this.ground.matrix = stretched([radius, radius, 1], [...middle, 0]);
    ground.radius.value = radius;
    ground.middle.value = middle;
    ground.spacing.value = roundStep(radius / 6);
    this.shell.uniforms.strength.value = 1 - 0.7 * settings.explode;
    const backdrop = this.backdrop.uniforms;
    backdrop.kind.value = view === 'horizontal' ? 2 : settings.model === 'half' ? 0 : 1;
    setColour(ground.colour, rgb(theme.ground));
    setColour(backdrop.colour, rgb(theme.planar));
    setColour(backdrop.beyond, mix(rgb(theme.background), rgb(theme.ground), 0.75));
    for (const { uniforms } of this.things) setColour(uniforms.lineColour, rgb(theme.line));
  }

  /// Before each picture of a planar body: what part of the plane it shows, and device pixels per CSS pixel.
  look(view, camera, density) {
    const backdrop = this.backdrop.uniforms;
    const [x, y, z] = camera.target;
    backdrop.middle.value = [x, view === 'vertical' ? z : y];
    backdrop.extent.value = camera.halves;
    backdrop.spacing.value = roundStep((2 * camera.halves[1]) / 8);
    backdrop.width.value = 2 * density;
  }
}
