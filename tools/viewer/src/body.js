// SPDX-License-Identifier: GPL-2.0-or-later
// A body as things to draw: its surfaces and tubes once, its copies as instances.
import { Copies } from './copies.js';
import { IDENTITY, times } from './linear.js';
import { anchor, MODELS } from './models.js';
import { attribute, texture, thing } from './painter.js';
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

function setColours(tints, colours) {
  tints.data = Uint8Array.from(colours.flatMap((colour) => [...colour.map(Math.round), 255]));
  tints.width = colours.length;
  ++tints.version;
}

function centreTexture(tetrahedra) {
  const rows = Math.ceil(tetrahedra.length / CENTRES_PER_ROW);
  const data = new Float32Array(4 * CENTRES_PER_ROW * rows);
  tetrahedra.forEach((tetrahedron, i) => data.set(tetrahedron.centre, 4 * i));
  return texture(data, CENTRES_PER_ROW, rows);
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
    this.planar = body.view !== 'space';
    this.copies = new Copies(body);
    this.shared = {
      model: { value: 0 },
      frame: { value: IDENTITY },
      apart: { value: 0 },
      anchor: { value: [0, 0, 0] },
      perspective: { value: !this.planar },
      centres: { value: centreTexture(body.tetrahedra) },
      background: { value: [0, 0, 0] },
      haze: { value: [0, 1] },
      up: { value: [0, 1, 0] },
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

  get things() {
    return this.layers.map((layer) => layer.thing);
  }

  geometry(arrays, triangles, instances) {
    const attributes = { motion: instances.motion, traits: instances.traits };
    for (const [name, [array, size]] of Object.entries(arrays)) attributes[name] = attribute(array, size);
    return { attributes, triangles };
  }

  addLayer(layer, vertex, uniforms) {
    const { part, side, geometry } = layer;
    const made = thing({
      ...geometry,
      vertex,
      fragment: litFragment,
      uniforms: {
        ...this.shared,
        ...uniforms,
        side: { value: side },
        opacity: { value: 1 },
        wash: { value: 0 },
        paper: { value: [0, 0, 0] },
        source: { value: 0 },
        tints: { value: texture(new Uint8Array(4), 1, 1) },
      },
      // Ribbons lie in their tiles and are drawn over them.
      depthTest: !this.planar,
      order: part === 'tube' ? 3 : side > 0 ? 2 : 1,
    });
    this.layers.push({ ...layer, thing: made });
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
      this.addLayer({ part, side, geometry, instances }, surfaceVertex, {
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
    const radii = this.planar ? [0, 2 * radius] : [radius, 3 * radius];
    this.addLayer({ part: 'tube', side: 0, geometry, instances }, tubeVertex, {
      radii: { value: radii },
      wanted: { value: this.planar ? 1.1 : 0.6 },
    });
  }

  /// Show what the settings say in the theme's colours.
  update(settings, theme) {
    this.shared.model.value = MODELS.indexOf(settings.model);
    this.shared.frame.value = settings.model === 'half' ? this.body.frame : IDENTITY;
    this.shared.apart.value = settings.explode;
    this.shared.anchor.value = anchor(this.body, settings.model);
    this.shared.background.value = times(rgb(theme.background), 1 / 255);
    this.copies.choose(settings.model, settings.copies);
    const closed = settings.faces && settings.boundary && settings.opacity === 1;
    for (const layer of this.layers) {
      layer.thing.visible =
        { face: settings.faces, boundary: settings.boundary, tube: settings.edges }[layer.part] &&
        !(closed && layer.side < 0);
      if (layer.side > 0) layer.thing.uniforms.recede.value = closed ? 0 : RECEDE;
      this.colour(layer, settings, theme);
    }
  }

  colour({ part, thing: own }, settings, theme) {
    const colouring = COLOURINGS[settings.colour];
    const { uniforms } = own;
    const by = colouring[part] ?? 'nothing';
    const count = Math.min(classCount(this.body, settings.colour), MOST_TINTS);
    const plain = part === 'tube' ? theme.ink : theme.paper;
    const tints = Array.from({ length: count }, (_, i) => tintOf(settings.colour, i, count));
    setColours(uniforms.tints.value, [...tints, rgb(plain)]);
    uniforms.source.value = BY[by];
    uniforms.wash.value = washOf(part, colouring, this.planar);
    uniforms.paper.value = times(rgb(theme.paper), 1 / 255);
    const opacity = part === 'face' ? settings.opacity : 1;
    uniforms.opacity.value = opacity;
    own.transparent = opacity < 1;
    own.depthWrite = opacity === 1;
  }

  /// Before each picture: the camera's upward direction and depths, how far it sees around its target, and
  /// the size of a pixel (at distance 1 in perspective).
  look(camera, { near, far, reach, pixel }) {
    this.shared.up.value = camera.axes.map((axis) => axis[2]);
    this.shared.haze.value = [near, far];
    this.shared.pixel.value = pixel;
    if (!this.copies.distribute(reach)) return;
    for (const { part, thing: own, instances } of this.layers)
      own.instances =
        part === 'tube' && instances === this.copies.far
          ? Math.max(0, this.copies.farEdges)
          : instances.count;
  }
}
