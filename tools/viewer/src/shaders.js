// SPDX-License-Identifier: GPL-2.0-or-later
// What the graphics card computes: each vertex is moved by its copy's Lorentz matrix, projected to the model,
// and lit by the normal that the plane's covector gives there.
//
// Precision. The card has 24 bits. A copy at distance d has matrix entries of size e^d, and so have the
// coordinates of its points: their relative error stays near 1e-7, which is far below a pixel in every model.
// What would lose digits is t - z for a point high up in the half space; there t - z = (1 + xx + yy) / (t +
// z). The equation of the hyperboloid also restores t, so that a point's four coordinates agree with each
// other. Squares overflow only beyond d = 40.

/// The hyperboloid and its models. `model` counts as MODELS does in models.js.
const hyperbolic = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
uniform int model;
uniform mat4 frame; // turns a body before it is seen in the half space

vec4 onHyperboloid(vec4 X) { return vec4(X.xyz, sqrt(1.0 + dot(X.xyz, X.xyz))); }

float below(vec4 X) { return X.z > 0.0 ? (1.0 + dot(X.xy, X.xy)) / (X.w + X.z) : X.w - X.z; }

vec3 projected(vec4 X) {
  if (model == 0) return vec3(X.xy, 1.0) / below(X);
  return X.xyz / (model == 1 ? 1.0 + X.w : X.w);
}

// Length in the model per hyperbolic length; in Klein's model, which is not conformal, that across the
// radius.
float scaleAt(vec4 X) { return 1.0 / (model == 0 ? below(X) : model == 1 ? 1.0 + X.w : X.w); }

// The outward normal at p = projected(X) of the plane with covector n; or of the horosphere -<X, n> = 1.
vec3 outward(vec4 n, vec4 X, vec3 p, bool horosphere) {
  if (model == 0) {
    float slope = n.z - n.w;
    return vec3(n.xy + slope * p.xy, slope * p.z + (horosphere ? 1.0 : 0.0));
  }
  if (model == 1) return n.xyz - n.w * p - (horosphere ? p : vec3(0.0));
  return n.xyz - (horosphere ? p * X.w : vec3(0.0));
}
`;

/// What surfaces and tubes share: a vertex of a copy, with its tetrahedron's move when the tetrahedra are
/// moved apart.
const copies = /* glsl */ `
in vec4 point;
in float tetrahedron;
in float label;
in mat4 motion;
in vec2 traits; // the length of the copy's word, and 1 for a mirror
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform float apart;
uniform vec3 anchor;
uniform sampler2D centres;
uniform sampler2D tints;
uniform int source;
out vec3 seen;
out vec3 normal;
flat out vec3 tint;
flat out float mirrored;

vec3 displacement() {
  if (apart == 0.0) return vec3(0.0);
  vec4 centre = texelFetch(centres, ivec2(int(tetrahedron) % 1024, int(tetrahedron) / 1024), 0);
  return apart * (projected(onHyperboloid(frame * (motion * centre))) - anchor);
}

// The last tint is that of what has no class.
vec3 ownTint() {
  int i = int(source == 0 ? tetrahedron : source == 1 ? label : source == 2 ? traits.x : -1.0);
  int last = textureSize(tints, 0).x - 1;
  return texelFetch(tints, ivec2(i < 0 ? last : i % last, 0), 0).rgb;
}

// "nearer" moves the depth alone, towards the viewer.
void place(vec3 p, vec3 n, float nearer) {
  vec4 eye = viewMatrix * vec4(p + displacement(), 1.0);
  seen = eye.xyz;
  normal = mat3(viewMatrix) * n;
  tint = ownTint();
  mirrored = traits.y;
  gl_Position = projectionMatrix * vec4(eye.xyz * (1.0 - nearer / length(eye.xyz)), 1.0);
}
`;

export const surfaceVertex =
  hyperbolic +
  copies +
  /* glsl */ `
in vec4 covector;
uniform bool horosphere;
uniform float recede;

void main() {
  vec4 X = onHyperboloid(frame * (motion * point));
  vec3 p = projected(X);
  place(p, normalize(outward(frame * (motion * covector), X, p, horosphere)), -recede * scaleAt(X));
}
`;

/// A tube of hyperbolic radius r about a curve: its points are cosh(r) X + sinh(r) W, with W the unit vectors
/// at X across the curve. r is what makes it `wanted` pixels wide, lest far edges break into dots, within
/// bounds: a solid's edges shall look like part of it, and far copies shall not be covered by theirs.
export const tubeVertex =
  hyperbolic +
  copies +
  /* glsl */ `
in vec4 across;
in float thickness;
uniform vec2 radii;
uniform float wanted;
uniform float pixel;
uniform bool perspective;

void main() {
  vec4 X = onHyperboloid(frame * (motion * point));
  vec4 W = frame * (motion * across);
  float depth = perspective ? -(viewMatrix * vec4(projected(X), 1.0)).z : 1.0;
  float r = clamp(wanted * pixel * depth / scaleAt(X), radii.x * thickness, radii.y * thickness);
  // r is small: sinh(r) is r and cosh(r) is 1 + rr / 2 to the card's precision.
  float c = 1.0 + 0.5 * r * r;
  vec4 Y = onHyperboloid(c * X + r * W);
  vec3 p = projected(Y);
  // Surfaces are made of flat triangles, whose chords lie up to a tube's radius off: their edges shall not
  // drown in them.
  place(p, normalize(outward(r * X + c * W, Y, p, false)), perspective ? r * scaleAt(X) : 0.0);
}
`;

/// Light: a sky above and a ground below, a key light over the viewer's left shoulder, a little gloss, and a
/// rim that sets silhouettes off. `lit` is the colour to display of a linear one.
export const lighting = /* glsl */ `
vec3 linear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
vec3 display(vec3 c) { return mix(c * 12.92, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }

vec3 lit(vec3 base, vec3 n, vec3 toEye, vec3 up) {
  if (dot(n, toEye) < 0.0) n = -n;
  vec3 key = normalize(vec3(-0.45, 0.65, 0.75));
  float direct = max(dot(n, key), 0.0);
  vec3 ambient = mix(vec3(0.40, 0.39, 0.39), vec3(0.58, 0.60, 0.62), 0.5 + 0.5 * dot(n, up));
  float gloss = pow(max(dot(n, normalize(key + toEye)), 0.0), 42.0);
  float rim = pow(1.0 - max(dot(n, toEye), 0.0), 3.0);
  return display(base * (ambient + 0.56 * direct) + 0.07 * gloss + 0.10 * rim * mix(base, vec3(1.0), 0.5));
}
`;

/// Far things fade slightly towards the background. `side` keeps one side of a surface (1 the outer, -1 the
/// inner, 0 both); culling by the card would keep the wrong one for copies that are mirrored.
export const litFragment =
  /* glsl */ `
precision highp float;
in vec3 seen;
in vec3 normal;
flat in vec3 tint;
flat in float mirrored;
uniform int side;
uniform float opacity;
uniform float wash;
uniform vec3 paper;
uniform vec3 background;
uniform vec2 haze;
uniform vec3 up;
uniform bool flatLook;
uniform bool perspective;
out vec4 colour;
` +
  lighting +
  /* glsl */ `
void main() {
  bool outer = gl_FrontFacing != (mirrored > 0.5);
  if (side != 0 && outer != (side > 0)) discard;
  vec3 base = linear(mix(tint, paper, wash));
  if (flatLook) {
    colour = vec4(display(base), opacity);
    return;
  }
  vec3 toEye = perspective ? normalize(-seen) : vec3(0.0, 0.0, 1.0);
  vec3 shown = lit(base, normalize(normal), toEye, up);
  float far = clamp((-seen.z - haze.x) / (haze.y - haze.x), 0.0, 1.0);
  colour = vec4(mix(shown, background, 0.4 * far), opacity);
}
`;
