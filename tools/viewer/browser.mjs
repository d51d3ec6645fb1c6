// SPDX-License-Identifier: GPL-2.0-or-later
// Debian's Chromium without a window, for pictures and for the test of the page. WebGL is drawn by the
// processor.
import { existsSync, readdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');

/// The folder that the build put playwright-core into: the one given, that of the environment, or one of the
/// usual builds'.
function modulesFolder(given) {
  const build = join(root, 'build');
  const usual = existsSync(build)
    ? readdirSync(build).map((preset) => join(build, preset, 'viewer', 'node_modules'))
    : [];
  const places = [given ?? process.env.TETRARCH_NODE_MODULES ?? [], usual].flat();
  const found = places.find((place) => existsSync(join(place, 'playwright-core')));
  if (!found)
    throw new Error('playwright-core was not found: give --modules FOLDER, the node_modules of a build');
  return found;
}

/// A running browser. `webgl: false` is one that cannot draw.
export async function openBrowser({ modules, webgl = true } = {}) {
  const { chromium } = await import(
    pathToFileURL(join(resolve(modulesFolder(modules)), 'playwright-core', 'index.mjs'))
  );
  const drawing = webgl
    ? ['--use-angle=swiftshader', '--enable-unsafe-swiftshader']
    : ['--disable-gpu', '--disable-software-rasterizer'];
  // Chromium's own sandbox refuses to run as root, as continuous integration does.
  const asRoot = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
  return chromium.launch({
    executablePath: process.env.TETRARCH_CHROMIUM ?? '/usr/bin/chromium',
    args: [...drawing, ...asRoot, '--disable-dev-shm-usage'],
  });
}

/// The value of --modules FOLDER, taken out of the arguments.
export function takeModules(args) {
  const at = args.indexOf('--modules');
  return at < 0 ? undefined : args.splice(at, 2)[1];
}

export const address = (file, hash = '') => pathToFileURL(resolve(file)).href + hash;
