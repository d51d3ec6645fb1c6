// SPDX-License-Identifier: GPL-2.0-or-later
// Makes the pages' templates, viewer.html and texture.html, in the folder that holds src and node_modules.
import { build } from 'esbuild';
import { readFileSync, renameSync, writeFileSync } from 'node:fs';

/// Where each page's controls and code lie.
const PAGES = { 'viewer.html': 'src', 'texture.html': 'src/texture' };

/// Old browsers show no WebGL 2 anyway; ASCII alone survives every wrong guess of an encoding on the way to
/// the reader.
async function bundled(entry) {
  const result = await build({
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2021',
    charset: 'ascii',
    legalComments: 'inline',
    logLevel: 'warning',
  });
  return result.outputFiles[0].text.trim();
}

/// The licence asks that its whole text goes with copies of the program.
function licences() {
  const { version } = JSON.parse(readFileSync('node_modules/three/package.json', 'utf8'));
  const text = readFileSync('node_modules/three/LICENSE', 'utf8').trim().replaceAll('\u00a9', '(c)');
  return `This page contains three.js ${version}, which is free software:\n\n${text}\n`;
}

async function template(folder) {
  const parts = {
    '<!-- TETRARCH_LICENCES -->': `<!--\n${licences()}-->`,
    TETRARCH_STYLE: await bundled('src/page.css'),
    TETRARCH_CONTROLS: readFileSync(`${folder}/controls.html`, 'utf8').trim(),
    TETRARCH_CODE: await bundled(`${folder}/main.js`),
  };
  let page = readFileSync('src/page.html', 'utf8');
  for (const [token, text] of Object.entries(parts)) {
    if (page.split(token).length !== 2) throw new Error(`${token} must stand in the page once`);
    page = page.replace(token, () => text);
  }
  if (page.split('TETRARCH_SCENE').length !== 2)
    throw new Error('TETRARCH_SCENE must stand in the page once');
  if (/[^\x00-\x7f]/.test(page)) throw new Error('the page must be ASCII');
  return page;
}

for (const [name, folder] of Object.entries(PAGES)) {
  writeFileSync(`${name}.part`, await template(folder));
  renameSync(`${name}.part`, name);
}
