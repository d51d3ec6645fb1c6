// SPDX-License-Identifier: GPL-2.0-or-later
// A body as objects of three.js: its surfaces and tubes once, its copies as instances.
import {
  BufferAttribute,
  DataTexture,
  DoubleSide,
  FloatType,
  GLSL3,
  Group,
  InstancedBufferGeometry,
  Matrix4,
  Mesh,
  RawShaderMaterial,
  RGBAFormat,
  Sphere,
  UnsignedByteType,
  Vector2,
  Vector3,
} from 'three';
import { Copies } from './copies.js';
import { anchor, MODELS } from './models.js';
import { classColour, lengthColour, rgb } from './palette.js';
import { litFragment, surfaceVertex, tubeVertex } from './shaders.js';
import { meanLength, PRISM, RIBBON, ROUND, tubeArrays } from './tubes.js';

/// Tetrahedra per row of the texture that holds their centres (shaders.js).
const CENTRES_PER_ROW = 1024;
/// More colours than this are repeated.
const MOST_TINTS = 2048;
/// Glued faces coincide up to the chords they are made of. Outer sides give way by this hyperbolic length, so
/// that who looks into a tetrahedron sees its own inner sides.
const RECEDE = 0.02;
/// Where a vertex' colour comes from, as the shader counts.
const BY = { tetrahedron: 0, class: 1, word: 2, nothing: 3 };

/// What each way of colouring means for faces, truncation triangles (boundary) and tubes; what is not named
/// stays plain.
export const COLOURINGS = {
  tetrahedron: { face: 'tetrahedron', boundary: 'tetrahedron' },
  face: { face: 'class' },
  boundary: { boundary: 'class' },
  edge: { tube: 'class' },
  word: { face: 'word', boundary: 'word' },
};

function colourTexture(colours) {
  const data = new Uint8Array(4 * colours.length);
  colours.forEach((colour, i) => data.set([...colour.map(Math.round), 255], 4 * i));
  const texture = new DataTexture(data, colours.length, 1, RGBAFormat, UnsignedByteType);
  texture.needsUpdate = true;
  return texture;
}

function centreTexture(tetrahedra) {
  const rows = Math.ceil(tetrahedra.length / CENTRES_PER_ROW);
  const data = new Float32Array(4 * CENTRES_PER_ROW * rows);
  tetrahedra.forEach((tetrahedron, i) => data.set(tetrahedron.centre, 4 * i));
  const texture = new DataTexture(data, CENTRES_PER_ROW, rows, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}

/// How much of the colour of paper is mixed in: truncation triangles are paler than the faces beside them
/// that have the same colour, and tilings, whose large areas have no light and shadow, are softer than
/// solids.
function washOf(part, colouring, planar) {
  if (part === 'tube' || !colouring[part]) return 0;
  if (planar) return 0.25;
  return part === 'boundary' && colouring.face ? 0.6 : 0;
}

const largest = (list) => list.reduce((a, b) => Math.max(a, b), 0);

/// The sides of truncation triangles have no edge class.
const edgeClasses = (tubes) => tubes.class.map((edge, i) => (tubes.kind[i] === 'edge' ? edge : -1));

/// How many classes there are of what a colouring tells apart, to draw a legend and to fill a texture.
export function classCount(body, colouring) {
  if (colouring === 'tetrahedron') return body.tetrahedra.length;
  if (colouring === 'word') return largest(body.copies.length) + 1;
  if (colouring === 'edge') return largest(edgeClasses(body.tubes)) + 1;
  const layer = body.surfaces.filter((surface) => (surface.kind === 'face') === (colouring === 'face'));
  return largest(layer.map((surface) => largest(surface.class))) + 1;
}

export function tintOf(colouring, i, count) {
  return colouring === 'word' ? lengthColour(i, count - 1) : classColour(i);
}

/// The normal at X of the plane or horosphere that a tiling lies in.
const NORMALS = { vertical: () => [0, 1, 0, 0], horizontal: (X) => [-X[0], -X[1], 1 - X[2], 1 - X[3]] };

export class BodyView {
  constructor(body) {
    this.body = body;
    this.object = new Group();
    this.planar = body.view !== 'space';
    this.copies = new Copies(body);
    this.shared = {
      model: { value: 0 },
      frame: { value: new Matrix4() },
      apart: { value: 0 },
      anchor: { value: new Vector3() },
      perspective: { value: !this.planar },
      centres: { value: centreTexture(body.tetrahedra) },
      background: { value: new Vector3() },
      haze: { value: new Vector2() },
      up: { value: new Vector3(0, 1, 0) },
      flatLook: { value: this.planar },
      pixel: { value: 0 },
    };
    this.layers = [];
    const coarse = body.coarse ?? body;
    body.surfaces.forEach((surface) => this.addSurface(surface, this.copies.near));
    coarse.surfaces.forEach((surface) => this.addSurface(surface, this.copies.far));
    this.addTubes(body.tubes, this.copies.near, this.planar ? RIBBON : ROUND);
    const afar = this.planar ? RIBBON : PRISM;
    this.addTubes(coarse.tubes, this.copies.far, body.coarse ? afar : { ...afar, step: 2 });
  }

  geometry(arrays, triangles, instances) {
    const geometry = new InstancedBufferGeometry();
    for (const [name, [array, size]] of Object.entries(arrays))
      geometry.setAttribute(name, new BufferAttribute(array, size));
    geometry.setAttribute('motion', instances.motion);
    geometry.setAttribute('traits', instances.traits);
    geometry.setIndex(new BufferAttribute(triangles, 1));
    // The card places the vertices, so three.js must not look for a sphere around them.
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    return geometry;
  }

  addMesh(layer, vertexShader, uniforms) {
    const { part, side, geometry } = layer;
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader: litFragment,
      side: DoubleSide,
      uniforms: {
        ...this.shared,
        ...uniforms,
        side: { value: side },
        opacity: { value: 1 },
        wash: { value: 0 },
        paper: { value: new Vector3() },
        source: { value: 0 },
        tints: { value: null },
      },
      // Ribbons lie in their tiles and are drawn over them.
      depthTest: !this.planar,
    });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.renderOrder = part === 'tube' ? 3 : side > 0 ? 2 : 1;
    this.object.add(mesh);
    this.layers.push({ ...layer, mesh, material });
  }

  addSurface(surface, instances) {
    const geometry = this.geometry(
      {
        point: [surface.points, 4],
        covector: [surface.normals, 4],
        tetrahedron: [Float32Array.from(surface.tetrahedron), 1],
        label: [Float32Array.from(surface.class), 1],
      },
      surface.triangles,
      instances,
    );
    const part = surface.kind === 'face' ? 'face' : 'boundary';
    for (const side of this.planar ? [0] : [-1, 1])
      this.addMesh({ part, side, geometry, instances }, surfaceVertex, {
        horosphere: { value: surface.kind === 'cusp' },
        recede: { value: 0 },
      });
  }

  addTubes(tubes, instances, shape) {
    if (tubes.starts.length < 2) return;
    const arrays = tubeArrays({ ...tubes, class: edgeClasses(tubes) }, shape, NORMALS[this.body.view]);
    const geometry = this.geometry(
      {
        point: [Float32Array.from(arrays.point), 4],
        across: [Float32Array.from(arrays.across), 4],
        tetrahedron: [Float32Array.from(arrays.tetrahedron), 1],
        label: [Float32Array.from(arrays.label), 1],
        thickness: [Float32Array.from(arrays.thickness), 1],
      },
      Uint32Array.from(arrays.triangles),
      instances,
    );
    const radius = Math.min(0.016, 0.008 * meanLength(tubes));
    const radii = this.planar ? new Vector2(0, 2 * radius) : new Vector2(radius, 3 * radius);
    this.addMesh({ part: 'tube', side: 0, geometry, instances }, tubeVertex, {
      radii: { value: radii },
      wanted: { value: this.planar ? 1.1 : 0.6 },
    });
  }

  /// Show what the settings say in the theme's colours.
  update(settings, theme) {
    this.shared.model.value = MODELS.indexOf(settings.model);
    if (settings.model === 'half') this.shared.frame.value.fromArray(this.body.frame);
    else this.shared.frame.value.identity();
    this.shared.apart.value = settings.explode;
    this.shared.anchor.value.fromArray(anchor(this.body, settings.model));
    this.shared.background.value.fromArray(rgb(theme.background)).divideScalar(255);
    this.copies.choose(settings.model, settings.copies);
    const closed = settings.faces && settings.boundary && settings.opacity === 1;
    for (const layer of this.layers) {
      layer.mesh.visible =
        { face: settings.faces, boundary: settings.boundary, tube: settings.edges }[layer.part] &&
        !(closed && layer.side < 0);
      if (layer.side > 0) layer.material.uniforms.recede.value = closed ? 0 : RECEDE;
      this.colour(layer, settings, theme);
    }
  }

  colour({ part, material }, settings, theme) {
    const colouring = COLOURINGS[settings.colour];
    const uniforms = material.uniforms;
    const by = colouring[part] ?? 'nothing';
    const count = Math.min(classCount(this.body, settings.colour), MOST_TINTS);
    const plain = part === 'tube' ? theme.ink : theme.paper;
    uniforms.tints.value?.dispose();
    const tints = Array.from({ length: count }, (_, i) => tintOf(settings.colour, i, count));
    uniforms.tints.value = colourTexture([...tints, rgb(plain)]);
    uniforms.source.value = BY[by];
    uniforms.wash.value = washOf(part, colouring, this.planar);
    uniforms.paper.value.fromArray(rgb(theme.paper)).divideScalar(255);
    const opacity = part === 'face' ? settings.opacity : 1;
    uniforms.opacity.value = opacity;
    material.transparent = opacity < 1;
    material.depthWrite = opacity === 1;
  }

  /// Before each picture: the camera's upward direction and depths, how far it sees around its target, and
  /// the size of a pixel (at distance 1 in perspective).
  look(camera, { near, far, reach, pixel }) {
    this.shared.up.value.set(0, 0, 1).transformDirection(camera.matrixWorldInverse);
    this.shared.haze.value.set(near, far);
    this.shared.pixel.value = pixel;
    if (!this.copies.distribute(reach)) return;
    for (const { part, geometry, instances } of this.layers)
      geometry.instanceCount =
        part === 'tube' && instances === this.copies.far
          ? Math.max(0, this.copies.farEdges)
          : instances.count;
  }

  dispose() {
    for (const { geometry, material } of this.layers) {
      material.uniforms.tints.value?.dispose();
      material.dispose();
      geometry.dispose();
    }
    this.shared.centres.value.dispose();
  }
}
