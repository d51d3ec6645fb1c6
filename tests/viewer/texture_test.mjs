// SPDX-License-Identifier: GPL-2.0-or-later
// Tests pages that `tetrarch slit` and `tetrarch product` wrote, in Chromium without a window:
//   node tests/viewer/texture_test.mjs [--modules FOLDER] PAGE.html...
// FOLDER is the node_modules of a build. Prints what was checked; ends with 1 when something is wrong.
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { openBrowser, takeModules } from '../../tools/viewer/browser.mjs';
import { openEyes } from './eyes.mjs';
import { check, checkAnotherSize, conclude, failures, said, Visit } from './visit.mjs';

/// A control must change at least this share of each half of the picture.
const CHANGED = 0.003;
/// The outline of the pane that has the focus covers less.
const FOCUS = 0.05;
const PHONE = { width: 375, height: 667 };
const CONTROLS = ['pattern', 'squares', 'lines', 'reset', 'save'];

/// A screenshot of each pane, without what stands around it.
const panes = async (visit) => {
  const pictures = [];
  for (const pane of await visit.tab.locator('.pane').all()) pictures.push(await pane.screenshot());
  return pictures;
};

/// Do something and say which share of each pane it changed.
async function changes(visit, eyes, act) {
  const before = await panes(visit);
  await visit.after(act);
  const after = await panes(visit);
  return Promise.all(before.map((picture, i) => eyes.difference(picture, after[i])));
}

const percent = (shares) => shares.map((share) => `${(100 * share).toFixed(1)} %`).join(' and ');

/// What only pages of solids have: a field, patches, and an inside.
const SOLID_ACTS = (visit) => ({
  'a field': () => visit.tab.selectOption('#pattern', 'field'),
  'fewer levels': () => visit.slide('squares', 12),
  'levels as before': () => visit.slide('squares', 40),
  'seeing inside': () => visit.tab.check('#inside'),
  'fibres inside': () => visit.tab.uncheck('#lines'),
  'fibres inside again': () => visit.tab.check('#lines'),
  'seeing the outside': () => visit.tab.uncheck('#inside'),
  patches: () => visit.tab.selectOption('#pattern', 'patches'),
  'squares again': () => visit.tab.selectOption('#pattern', 'squares'),
});

async function isSolid(visit) {
  return (await visit.tab.locator('#pattern option[value=patches]').count()) > 0;
}

async function checkControls(visit, eyes, name) {
  const first = await panes(visit);
  const acts = {
    'coloured squares': () => visit.tab.selectOption('#pattern', 'coloured'),
    circles: () => visit.tab.selectOption('#pattern', 'circles'),
    squares: () => visit.tab.selectOption('#pattern', 'squares'),
    'fewer squares': () => visit.slide('squares', 12),
    'as many as before': () => visit.slide('squares', 40),
    'no loops': () => visit.tab.uncheck('#lines'),
    loops: () => visit.tab.check('#lines'),
    ...((await isSolid(visit)) && SOLID_ACTS(visit)),
  };
  for (const [what, act] of Object.entries(acts)) {
    const shares = await changes(visit, eyes, act);
    check(
      shares.length === 2 && shares.every((share) => share > CHANGED),
      `${name}: ${what} changed ${percent(shares)} of the panes`,
    );
  }
  const last = await panes(visit);
  for (const i of [0, 1])
    check(
      (await eyes.difference(first[i], last[i])) === 0,
      `${name}: undoing every change gives another pane ${i}`,
    );
  said('pattern, squares and loops change both panes and can be undone');
}

/// Each pane is moved by itself, with the mouse and with keys.
async function checkMotion(visit, eyes, name) {
  const first = await panes(visit);
  for (const i of [0, 1]) {
    const pane = visit.tab.locator('.pane').nth(i);
    const { x, y, width, height } = await pane.boundingBox();
    const acts = {
      dragging: async () => {
        await visit.tab.mouse.move(x + width / 2, y + height / 2);
        await visit.tab.mouse.down();
        await visit.tab.mouse.move(x + width / 2 + 50, y + height / 2 + 20, { steps: 3 });
        await visit.tab.mouse.up();
      },
      'the wheel': () => visit.tab.mouse.wheel(0, -300),
      'an arrow key': async () => {
        await pane.focus();
        await visit.tab.keyboard.press('ArrowLeft');
      },
    };
    for (const [what, act] of Object.entries(acts)) {
      const shares = await changes(visit, eyes, act);
      check(
        shares[i] > CHANGED && shares[1 - i] < FOCUS,
        `${name}: ${what} in pane ${i} changed ${percent(shares)} of the panes`,
      );
    }
  }
  await visit.tab.waitForTimeout(600);
  check(/direction=/.test(visit.tab.url()), `${name}: the address does not follow the camera`);
  await visit.after(() => visit.tab.click('#reset'));
  await visit.tab.evaluate(() => document.activeElement.blur());
  const last = await panes(visit);
  for (const i of [0, 1])
    check((await eyes.difference(first[i], last[i])) === 0, `${name}: pane ${i} is not reset`);
  const idle = await visit.drawn();
  await visit.tab.waitForTimeout(300);
  check((await visit.drawn()) === idle, `${name}: draws although nothing changes`);
  const [download] = await Promise.all([visit.tab.waitForEvent('download'), visit.tab.click('#save')]);
  const saved = await eyes.look(readFileSync(await download.path()));
  check(saved.colours > 10, `${name}: the saved picture has ${saved.colours} colours`);
  said('dragging, wheel and keys move one pane; reset and saving work; nothing is drawn at rest');
}

async function checkLook(browser, eyes, file, name) {
  const light = {};
  for (const scheme of ['light', 'dark']) {
    const visit = await Visit.open(browser, file, { scheme });
    light[scheme] = (await eyes.look(await visit.tab.locator('#panel').screenshot())).light;
    for (const picture of await panes(visit))
      check((await eyes.look(picture)).colours > 10, `${name}, ${scheme}: a pane is empty`);
    check(visit.troubles.length === 0, `${name}, ${scheme}: ${visit.troubles.join('; ')}`);
    await visit.close();
  }
  check(light.light > 150 && light.dark < 105, `${name}: the panel does not follow the preference for dark`);
  const visit = await Visit.open(browser, file, { viewport: PHONE, hash: '#pattern=circles&squares=1e9' });
  const [wide, inner] = await visit.tab.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  check(wide <= inner, `${name}: ${wide} pixels wide on a phone of ${inner}`);
  const [first, second] = await Promise.all([0, 1].map((i) => visit.tab.locator('.pane').nth(i).boundingBox()));
  check(second.y >= first.y + first.height - 1, `${name}: on a phone the panes are not above one another`);
  const { pattern, squares } = await visit.settings();
  check(pattern === 'circles' && squares === 40, `${name}: the address gave ${squares} ${pattern}`);
  await visit.close();
  said('fits dark pages and phones, and follows its address');
}

async function checkPage(browser, eyes, file) {
  const name = basename(file);
  console.log(name);
  const visit = await Visit.open(browser, file);
  check((await visit.tab.locator('#tables table').count()) > 0, `${name}: there are no tables`);
  if (await isSolid(visit)) {
    await visit.tab.selectOption('#pattern', 'patches');
    const named = await visit.tab.locator('#legend li').allTextContents();
    check(/^floor ceiling wall 0\b/.test(named.join(' ')), `${name}: the patches are ${named}`);
    await visit.after(() => visit.tab.selectOption('#pattern', 'squares'));
  } else {
    check((await visit.tab.locator('#legend li').count()) > 0, `${name}: no loop has a name`);
    check(!(await visit.tab.locator('#inside').isVisible()), `${name}: a surface has no inside`);
  }
  for (const id of CONTROLS) {
    const named = await visit.tab
      .locator(`#${id}`)
      .evaluate((e) => e.labels?.length > 0 || e.ariaLabel || e.textContent.trim());
    check(named, `${name}: ${id} has no name for screen readers`);
  }
  await checkControls(visit, eyes, name);
  await checkMotion(visit, eyes, name);
  check(visit.troubles.length === 0, `${name}: ${visit.troubles.join('; ')}`);
  await visit.close();
  await checkLook(browser, eyes, file, name);
  await checkAnotherSize(browser, eyes, file, name, PHONE);
}

const args = process.argv.slice(2);
const modules = takeModules(args);
if (args.length === 0) {
  console.error('usage: texture_test.mjs [--modules FOLDER] PAGE.html...');
  process.exit(2);
}
const browser = await openBrowser({ modules });
try {
  const eyes = await openEyes(browser);
  for (const file of args) await checkPage(browser, eyes, file);
} catch (error) {
  failures.push(error.message);
  console.log(`FAILED: ${error.stack}`);
} finally {
  await browser.close();
}
conclude();
