// SPDX-License-Identifier: GPL-2.0-or-later
// Lines of a width in pixels, with round ends. Each segment is a rectangle on the canvas with a half square at
// either end, which is as far off as that end and has the round end in it.
import { attribute, thing } from '../painter.js';

const vertex = /* glsl */ `
precision highp float;
in vec2 corner; // along the segment -1 or 1, and -2 or 2 at the ends' ends; across it -1 or 1
in vec3 start;
in vec3 end;
in vec3 tint;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec2 resolution;
uniform float width;
uniform bool painted; // all in one colour
uniform vec3 paint;
out vec2 place; // from the segment's start, along and across, in half widths
flat out float reach; // the segment's length, in half widths
flat out vec3 colour;

// What lies behind the camera has no place on the canvas: the segment ends at the near plane.
vec4 seen(vec4 p, vec4 other) {
  float depth = p.z + p.w;
  return depth < 0.0 ? mix(p, other, depth / (depth - other.z - other.w)) : p;
}

void main() {
  vec4 first = projectionMatrix * (viewMatrix * vec4(start, 1.0));
  vec4 last = projectionMatrix * (viewMatrix * vec4(end, 1.0));
  colour = painted ? paint : tint;
  if (first.z < -first.w && last.z < -last.w) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside
    return;
  }
  vec4 a = seen(first, last);
  vec4 b = seen(last, first);
  vec2 half_width = width / resolution;
  // On the canvas, in half widths.
  vec2 from = a.xy / a.w / half_width;
  vec2 to = b.xy / b.w / half_width;
  reach = length(to - from);
  vec2 along = reach > 1e-6 ? (to - from) / reach : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  bool ends = corner.x > 0.0;
  place = vec2((ends ? reach - 1.0 : 1.0) + corner.x, corner.y);
  vec2 at = from + along * place.x + across * place.y;
  gl_Position = vec4(at * half_width, ends ? b.z / b.w : a.z / a.w, 1.0);
}
`;

const fragment = /* glsl */ `
precision highp float;
in vec2 place;
flat in float reach;
flat in vec3 colour;
out vec4 shown;
void main() {
  vec2 away = vec2(place.x - clamp(place.x, 0.0, reach), place.y);
  if (dot(away, away) > 1.0) discard;
  shown = vec4(colour, 1.0);
}
`;

/// Segments as the card's arrays: three coordinates for each start and end, and a colour from 0 to 1 for each.
export function segments(starts, ends, tints) {
  const each = (list) => attribute(Float32Array.from(list), 3, { instanced: true });
  return {
    attributes: {
      corner: attribute(Float32Array.of(-2, -1, -2, 1, -1, -1, -1, 1, 1, -1, 1, 1, 2, -1, 2, 1), 2),
      start: each(starts),
      end: each(ends),
      tint: each(tints),
    },
    triangles: Uint16Array.of(0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5, 4, 5, 6, 6, 5, 7),
    instances: starts.length / 3,
  };
}

/// The segments drawn so many CSS pixels wide; where `painted` is set, in the colour `paint`.
export function wideLines(geometry, width, state) {
  const uniforms = { width: { value: width }, painted: { value: false }, paint: { value: [0, 0, 0] } };
  return thing({ ...geometry, vertex, fragment, uniforms, ...state });
}
