// SPDX-License-Identifier: GPL-2.0-or-later
// Drawing by WebGL 2. What is drawn is a thing: arrays of numbers for each vertex or copy, shaders, their
// uniforms, and how it meets what is on the canvas already.
import { IDENTITY } from './linear.js';

/// Numbers for each vertex, `size` of them, or `instanced` for each copy. Bytes may be `normalised`: 255 is 1.
/// Who changes the array adds one to `version`; only the first `used` numbers go to the card then.
export function attribute(array, size, { instanced = false, normalised = false } = {}) {
  return { array, size, instanced, normalised, used: array.length, version: 0 };
}

/// Bytes or floats, four for each of width x height places. `version` as above.
export function texture(data, width, height) {
  return { data, width, height, version: 0 };
}

/// `attributes` and `uniforms` go by their names in the shaders; a uniform is { value }, which things may share.
/// The painter itself gives modelMatrix, viewMatrix, projectionMatrix, and the `resolution`, the picture's size in
/// CSS pixels. `instances` says how many copies of the triangles are drawn. Things are drawn by increasing `order`, those
/// that are `transparent` after all others.
export function thing(given) {
  return {
    visible: true,
    order: 0,
    transparent: false,
    premultiplied: false, // whether the shader's colours are
    depthTest: true,
    depthWrite: true,
    outside: false, // only triangles that are counter-clockwise on the canvas
    behind: false, // gives way to lines that lie on it
    matrix: IDENTITY,
    ...given,
  };
}

/// A number, a list, or a texture for each type of uniform; what a list's members are, lists of numbers too.
function setUniform(gl, { type, location }, value, unit) {
  const list = () => [value].flat(2);
  const setters = {
    [gl.FLOAT]: () => gl.uniform1fv(location, list()),
    [gl.FLOAT_VEC2]: () => gl.uniform2fv(location, list()),
    [gl.FLOAT_VEC3]: () => gl.uniform3fv(location, list()),
    [gl.FLOAT_MAT4]: () => gl.uniformMatrix4fv(location, false, value),
    [gl.INT]: () => gl.uniform1i(location, value),
    [gl.BOOL]: () => gl.uniform1i(location, value),
    [gl.SAMPLER_2D]: () => gl.uniform1i(location, unit()),
  };
  setters[type]();
}

export class Painter {
  constructor(context, onRestored) {
    this.gl = context;
    this.background = [0, 0, 0, 0];
    this.forgetAll();
    // The card may forget everything; the arrays are still here.
    context.canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    context.canvas.addEventListener('webglcontextrestored', () => {
      this.forgetAll();
      onRestored();
    });
  }

  forgetAll() {
    this.programs = new Map();
    this.buffers = new Map();
    this.textures = new Map();
    this.layouts = new Map();
  }

  /// Give back what the card holds of these things.
  forget(things) {
    const { gl } = this;
    const drop = (map, key, remove) => {
      if (map.has(key)) remove(map.get(key));
      map.delete(key);
    };
    for (const one of things) {
      drop(this.layouts, one, (layout) => gl.deleteVertexArray(layout));
      for (const key of [one.triangles, ...Object.values(one.attributes)])
        drop(this.buffers, key, ({ buffer }) => gl.deleteBuffer(buffer));
      for (const { value } of Object.values(one.uniforms))
        drop(this.textures, value, ({ held }) => gl.deleteTexture(held));
    }
  }

  /// The canvas in CSS pixels, and device pixels for each of them.
  setSize(width, height, density) {
    this.size = [width, height];
    this.density = density;
    this.gl.canvas.width = Math.floor(width * density);
    this.gl.canvas.height = Math.floor(height * density);
  }

  shader(type, source) {
    const { gl } = this;
    const shader = gl.createShader(type);
    gl.shaderSource(shader, `#version 300 es\n${source}`);
    gl.compileShader(shader);
    return shader;
  }

  program({ vertex, fragment }) {
    const key = vertex + fragment;
    if (this.programs.has(key)) return this.programs.get(key);
    const { gl } = this;
    const program = gl.createProgram();
    const shaders = [this.shader(gl.VERTEX_SHADER, vertex), this.shader(gl.FRAGMENT_SHADER, fragment)];
    for (const shader of shaders) gl.attachShader(program, shader);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error([...shaders.map((s) => gl.getShaderInfoLog(s)), gl.getProgramInfoLog(program)].join('\n'));
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) ?? 0;
    const uniforms = Array.from({ length: count }, (_, i) => {
      const { name, type } = gl.getActiveUniform(program, i);
      return { name: name.replace('[0]', ''), type, location: gl.getUniformLocation(program, name) };
    });
    this.programs.set(key, { program, uniforms });
    return this.programs.get(key);
  }

  /// The attribute's numbers on the card, as new as its array.
  buffer(given) {
    const { gl } = this;
    const { array, used, version } = given;
    const held = this.buffers.get(given) ?? { buffer: gl.createBuffer() };
    if (held.version === version) return held.buffer;
    gl.bindBuffer(gl.ARRAY_BUFFER, held.buffer);
    if (held.version === undefined)
      gl.bufferData(gl.ARRAY_BUFFER, array, given.instanced ? gl.DYNAMIC_DRAW : gl.STATIC_DRAW);
    else gl.bufferSubData(gl.ARRAY_BUFFER, 0, array, 0, used);
    this.buffers.set(given, { ...held, version });
    return held.buffer;
  }

  /// Matrices take as many places as they have columns. An attribute that the thing lacks is 0 everywhere.
  setAttribute(program, name, given) {
    const { gl } = this;
    const first = gl.getAttribLocation(program, name);
    if (first < 0) return;
    const columns = Math.ceil(given.size / 4);
    const type = given.array instanceof Uint8Array ? gl.UNSIGNED_BYTE : gl.FLOAT;
    const bytes = given.array.BYTES_PER_ELEMENT * given.size;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer(given));
    for (let i = 0; i < columns; ++i) {
      gl.enableVertexAttribArray(first + i);
      gl.vertexAttribPointer(
        first + i,
        given.size / columns,
        type,
        given.normalised,
        bytes,
        (i * bytes) / columns,
      );
      gl.vertexAttribDivisor(first + i, given.instanced ? 1 : 0);
    }
  }

  /// Which of the card's arrays the thing's vertices come from.
  layout(one, program) {
    const { gl } = this;
    for (const given of Object.values(one.attributes)) this.buffer(given);
    if (this.layouts.has(one)) return this.layouts.get(one);
    const layout = gl.createVertexArray();
    gl.bindVertexArray(layout);
    for (const [name, given] of Object.entries(one.attributes)) this.setAttribute(program, name, given);
    const held = this.buffers.get(one.triangles) ?? { buffer: gl.createBuffer() };
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, held.buffer);
    if (!this.buffers.has(one.triangles)) gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, one.triangles, gl.STATIC_DRAW);
    this.buffers.set(one.triangles, held);
    this.layouts.set(one, layout);
    return layout;
  }

  /// Puts the texture, as new as its data, where shaders find it as number `unit`.
  bindTexture(given, unit) {
    const { gl } = this;
    const held = this.textures.get(given) ?? { held: gl.createTexture() };
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, held.held);
    if (held.version === given.version) return;
    const [inside, type] =
      given.data instanceof Uint8Array ? [gl.RGBA8, gl.UNSIGNED_BYTE] : [gl.RGBA32F, gl.FLOAT];
    gl.texImage2D(gl.TEXTURE_2D, 0, inside, given.width, given.height, 0, gl.RGBA, type, given.data);
    // Shaders fetch single places; without these the card would wait for smaller versions of it.
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    this.textures.set(given, { ...held, version: given.version });
  }

  setState(one) {
    const { gl } = this;
    const set = (what, on) => (on ? gl.enable(what) : gl.disable(what));
    set(gl.BLEND, one.transparent);
    const source = one.premultiplied ? gl.ONE : gl.SRC_ALPHA;
    gl.blendFuncSeparate(source, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    set(gl.DEPTH_TEST, one.depthTest);
    gl.depthFunc(gl.LEQUAL);
    gl.depthMask(one.depthWrite);
    set(gl.CULL_FACE, one.outside);
    set(gl.POLYGON_OFFSET_FILL, one.behind);
    gl.polygonOffset(2, 4);
  }

  draw(one, shared) {
    const { gl } = this;
    const { program, uniforms } = this.program(one);
    gl.useProgram(program);
    let units = 0;
    for (const uniform of uniforms) {
      const { value } = one.uniforms[uniform.name] ?? shared[uniform.name];
      setUniform(gl, uniform, value, () => {
        this.bindTexture(value, units);
        return units++;
      });
    }
    gl.bindVertexArray(this.layout(one, program));
    this.setState(one);
    const type = one.triangles instanceof Uint16Array ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT;
    gl.drawElementsInstanced(gl.TRIANGLES, one.triangles.length, type, 0, one.instances ?? 1);
  }

  /// Clear an area of the canvas, in CSS pixels from its lower left corner, and draw things there as the camera
  /// sees them.
  render(things, camera, area = [0, 0, ...this.size]) {
    const { gl } = this;
    const box = area.map((x) => Math.round(x * this.density));
    gl.viewport(...box);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(...box);
    gl.clearColor(...this.background);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const shared = {
      viewMatrix: { value: camera.view },
      projectionMatrix: { value: camera.projection },
      resolution: { value: area.slice(2) },
    };
    const shown = things.filter(({ visible, instances }) => visible && instances !== 0);
    shown.sort((a, b) => a.transparent - b.transparent || a.order - b.order);
    for (const one of shown) this.draw(one, { ...shared, modelMatrix: { value: one.matrix } });
    gl.bindVertexArray(null);
  }
}
