// SPDX-License-Identifier: GPL-2.0-or-later
// The data that the program wrote into the page: parsed, unpacked and checked.

/// Its message can be shown to a person.
export class SceneError extends Error {}

export function demand(condition, message) {
  if (!condition) throw new SceneError(message);
}

/// Arrays come as base64 of little-endian numbers, which is how every graphics card's machine stores them
/// too.
export function unpack(text, Type, what) {
  let characters;
  try {
    characters = atob(text);
  } catch {
    throw new SceneError(`${what} is not base64.`);
  }
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  if (bytes.length % Type.BYTES_PER_ELEMENT) throw new SceneError(`${what} ends in the middle of a number.`);
  return new Type(bytes.buffer);
}

/// What `read` makes of the data in a text, which must be version 1 of a format that `command` writes.
export function readData(text, format, command, read) {
  let data;
  try {
    data = JSON.parse(text);
  } catch {
    throw new SceneError('This page holds no scene: it is the empty template.');
  }
  demand(data.format === format, 'The data in this page are not a scene of Tetrarch.');
  demand(
    data.version === 1,
    `The data in this page are of version ${data.version}; this page shows version 1. Write it again with \`${command}\`.`,
  );
  try {
    return { title: data.title, tables: data.tables ?? [], ...read(data) };
  } catch (error) {
    if (error instanceof SceneError) throw error;
    throw new SceneError(`The scene lacks something: ${error.message}.`);
  }
}
