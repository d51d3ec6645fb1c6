// SPDX-License-Identifier: GPL-2.0-or-later
// Patterns drawn by the graphics card in texture coordinates. Each is averaged over the pixel, so that squares
// too small to be seen become an even tone and do not shimmer.
import { lighting } from '../shaders.js';

/// The patterns by their name in the page's address, in the order of the shader's numbers.
export const PATTERNS = ['squares', 'coloured', 'circles', 'field', 'patches'];

export const patternVertex = /* glsl */ `
precision highp float;
in vec3 position;
in vec3 normal;
in vec2 uv;
in float value;
in vec3 patchColour;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
out vec3 seen;
out vec3 across;
out vec2 place;
out float level;
out vec3 patchTint;
void main() {
  vec4 eye = viewMatrix * vec4(position, 1.0);
  seen = eye.xyz;
  across = mat3(viewMatrix) * normal;
  place = uv;
  level = value;
  patchTint = patchColour;
  gl_Position = projectionMatrix * eye;
}
`;

export const patternFragment =
  /* glsl */ `
precision highp float;
precision highp int;
in vec3 seen;
in vec3 across;
in vec2 place;
in float level; // of the field, from 0 to 1
in vec3 patchTint;
uniform int pattern;
uniform float squares; // for a unit of u
uniform float shift; // in squares
uniform float vByU;
uniform vec3 bright;
uniform vec3 dark;
uniform vec3 up;
uniform bool flatLook;
uniform float opacity;
uniform vec3 scale[5]; // the field's colours
out vec4 colour;
` +
  lighting +
  /* glsl */ `
// The integral of a wave that is 1 and -1 on unit intervals by turns.
vec2 summed(vec2 x) { return 1.0 - abs(mod(x, 2.0) - 1.0); }

// How much of the pixel at p is bright. Over a box a chessboard's mean is the product of the means of two
// waves.
float chessboard(vec2 p) {
  // Along a wall one coordinate may not change at all; the box must still be wide for the card's 24 bits.
  vec2 size = max(fwidth(p), 1e-3);
  vec2 mean = (summed(p + 0.5 * size) - summed(p - 0.5 * size)) / size;
  return 0.5 + 0.5 * mean.x * mean.y;
}

// A disk of radius r in every square; "slope" is how fast one leaves it from pixel to pixel.
float disks(vec2 p, float r) {
  vec2 inCell = fract(p) - 0.5;
  float away = length(inCell);
  vec2 outward = inCell / max(away, 1e-6);
  float slope = max(length(vec2(dot(outward, dFdx(p)), dot(outward, dFdy(p)))), 1e-6);
  vec2 size = fwidth(p);
  float disk = clamp(0.5 + (away - r) / slope, 0.0, 1.0);
  return mix(disk, 1.0 - 3.14159 * r * r, smoothstep(0.3, 0.9, max(size.x, size.y)));
}

// Hues go round with u, as an angle may be its meaning, and become paler with v.
vec3 placeColour(vec2 p) {
  vec3 hue = 0.5 + 0.42 * cos(6.28319 * (p.x + vec3(0.02, 0.36, 0.68)));
  return mix(hue, vec3(1.0), 0.1 + 0.45 * clamp(p.y, 0.0, 1.0));
}

// The field's colour at its level, darker on level lines, of which there are half as many as squares: none at
// the lowest and the highest level, which whole patches may have. They are of equal width however steep the
// field is; where they would run together they fade.
vec3 levelColour() {
  float at = 4.0 * clamp(level, 0.0, 1.0);
  int below = min(int(at), 3);
  vec3 tint = mix(linear(scale[below]), linear(scale[below + 1]), at - float(below));
  float counted = 0.5 * squares * level;
  float pixel = max(fwidth(counted), 1e-6);
  float away = abs(fract(counted) - 0.5) / pixel;
  float line = (1.0 - smoothstep(0.5, 1.5, away)) * (1.0 - smoothstep(0.2, 0.6, pixel));
  return mix(tint, 0.25 * tint, line);
}

void main() {
  vec2 p = squares * vec2(place.x, vByU * place.y) + shift;
  vec3 high = bright;
  vec3 low = dark;
  if (pattern == 1) {
    high = mix(placeColour(place), vec3(1.0), 0.5);
    low = 0.8 * placeColour(place);
  }
  float share = pattern == 2 ? disks(p, 0.4) : chessboard(p);
  vec3 base = mix(linear(low), linear(high), share);
  if (pattern == 3) base = levelColour();
  if (pattern == 4) base = linear(patchTint);
  // The inner side is in the shade.
  if (flatLook) colour = vec4(display(base), opacity);
  else colour = vec4(lit(gl_FrontFacing ? base : 0.45 * base, normalize(across), normalize(-seen), up), opacity);
  colour.rgb *= colour.a; // as the canvas wants it
}
`;
