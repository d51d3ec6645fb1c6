// SPDX-License-Identifier: GPL-2.0-or-later
// A picture of a page's canvas: see `picture`.
import { existsSync, writeFileSync } from 'node:fs';
import { address, openBrowser, takeModules } from './browser.mjs';

const args = process.argv.slice(2);
const modules = takeModules(args);
const [page, out, size, hash = ''] = args;
const [, width, height] = /^(\d+)x(\d+)$/.exec(size ?? '') ?? [];
if (!width || !existsSync(page)) {
  console.error(
    page && !existsSync(page)
      ? `picture: there is no file ${page}`
      : 'usage: picture PAGE.html OUT.png WIDTHxHEIGHT [#hash] [--modules FOLDER]',
  );
  process.exit(2);
}

const browser = await openBrowser({ modules });
try {
  const tab = await browser.newPage({ viewport: { width: Number(width), height: Number(height) } });
  const troubles = [];
  tab.on('pageerror', (error) => troubles.push(error.message));
  await tab.goto(address(page, `#panel=0&${hash.replace(/^#/, '')}`));
  await tab.waitForSelector('html[data-ready]', { state: 'attached', timeout: 30000 });
  if ((await tab.getAttribute('html', 'data-ready')) !== '1')
    throw new Error(await tab.textContent('#message'));
  const data = await tab.evaluate(([w, h]) => window.tetrarch.picture(w, h), [Number(width), Number(height)]);
  if (troubles.length) throw new Error(troubles.join('; '));
  writeFileSync(out, Buffer.from(data.slice(data.indexOf(',') + 1), 'base64'));
} catch (error) {
  console.error(`picture: ${error.message}`);
  process.exitCode = 1;
} finally {
  await browser.close();
}
