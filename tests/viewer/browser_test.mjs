// SPDX-License-Identifier: GPL-2.0-or-later
// Tests pages that `tetrarch view` wrote, in Chromium without a window:
//   node tests/viewer/browser_test.mjs [--modules FOLDER] PAGE.html...
// FOLDER is the node_modules of a build. Prints what was checked; ends with 1 when something is wrong.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { openBrowser, takeModules } from '../../tools/viewer/browser.mjs';
import { openEyes } from './eyes.mjs';
import { check, checkAnotherSize, conclude, failures, said, Visit } from './visit.mjs';

const PHONE = { width: 375, height: 667 };
/// A body must change at least this share of the picture's pixels, or it is not seen.
const SEEN = 0.01;
/// Faces, boundary or edges that are taken away change at least this share.
const PART = 0.01;
/// A change of another control must change at least this share.
const CHANGED = 0.0005;
const MODELS = ['half', 'ball', 'klein'];
const CONTROLS = [
  'body',
  'model',
  'colour',
  'copies',
  'copies-number',
  'explode',
  'opacity',
  'faces',
  'boundary',
  'edges',
  'reset',
  'save',
];

const args = process.argv.slice(2);
const modules = takeModules(args);

async function checkViews(visit, eyes, name) {
  const bodies = await visit.tab.locator('#body option').allTextContents();
  for (const [i, body] of bodies.entries()) {
    if (i > 0) await visit.after(() => visit.tab.selectOption('#body', String(i)));
    const models = await visit.tab
      .locator('#model option')
      .evaluateAll((options) => options.map((option) => option.value));
    check(
      models.every((model) => MODELS.includes(model)),
      `${name}, ${body}: models ${models}`,
    );
    for (const model of models) {
      if (models.length > 1) await visit.after(() => visit.tab.selectOption('#model', model));
      const full = await visit.picture();
      await visit.after(() =>
        visit.tab.evaluate(() => window.tetrarch.set({ faces: false, boundary: false, edges: false })),
      );
      const empty = await visit.picture();
      await visit.after(() =>
        visit.tab.evaluate(() => window.tetrarch.set({ faces: true, boundary: true, edges: true })),
      );
      const share = await eyes.difference(full, empty);
      const { colours } = await eyes.look(full);
      check(
        share > SEEN,
        `${name}, ${body}, ${model}: only ${(100 * share).toFixed(2)} % of the picture differ from the background`,
      );
      check(colours > 10, `${name}, ${body}, ${model}: the picture has ${colours} colours`);
      said(`${body}, ${model}: ${(100 * share).toFixed(0)} % covered, ${colours} colours`);
    }
  }
  await visit.after(() => visit.tab.selectOption('#body', '0'));
  await visit.after(() => visit.tab.selectOption('#model', 'half'));
}

async function checkControls(visit, eyes, name) {
  await visit.after(() => visit.tab.click('#reset'));
  const reset = await visit.picture();
  // A camera that someone placed stays there, so that what changes is the body, not how it is framed.
  await visit.tab.hover('#canvas');
  await visit.after(() => visit.tab.mouse.wheel(0, 60));
  let before = await visit.picture();
  const first = before;
  const expectChange = async (what, act, least = CHANGED) => {
    const drew = await visit.after(act);
    const now = await visit.picture();
    const share = await eyes.difference(before, now);
    check(drew && share > least, `${name}: ${what} changed ${(100 * share).toFixed(3)} % of the picture`);
    before = now;
  };
  const most = Number(await visit.tab.getAttribute('#copies-number', 'max'));
  const colourings = await visit.tab
    .locator('#colour option')
    .evaluateAll((options) => options.map((option) => option.value));
  for (const colouring of [...colourings.slice(1), colourings[0]])
    await expectChange(`colour by ${colouring}`, () => visit.tab.selectOption('#colour', colouring));
  for (const part of ['faces', 'boundary', 'edges']) {
    if (await visit.tab.isDisabled(`#${part}`)) continue;
    await expectChange(`${part} off`, () => visit.tab.uncheck(`#${part}`), PART);
    await expectChange(`${part} on`, () => visit.tab.check(`#${part}`), PART);
  }
  await expectChange('opacity 0.4', () => visit.slide('opacity', 0.4), SEEN);
  await expectChange('opacity 1', () => visit.slide('opacity', 1));
  await expectChange('apart', () => visit.slide('explode', 0.7), 3 * SEEN);
  await expectChange('together', () => visit.slide('explode', 0), 3 * SEEN);
  check((await eyes.difference(first, before)) === 0, `${name}: undoing every change gives another picture`);
  if (most > 1) {
    await expectChange('copies by number', () => visit.type(Math.min(4, most)));
    check(
      (await visit.settings()).copies === Math.min(4, most),
      `${name}: the number of copies typed is not the number shown`,
    );
    const several = Math.min(9, most);
    await expectChange('copies by slider', () =>
      visit.slide('copies', (1000 * Math.log(several)) / Math.log(most)),
    );
    check(
      Number(await visit.tab.inputValue('#copies-number')) === several,
      `${name}: the slider and the number of copies disagree`,
    );
    await expectChange('one copy', () => visit.type(1));
  }
  said('colours, parts, opacity, apart, copies change the picture and can be undone');
  await checkMotion(visit, eyes, name, expectChange, reset);
}

async function checkMotion(visit, eyes, name, expectChange, reset) {
  const { x, y, width, height } = await visit.tab.locator('#canvas').boundingBox();
  const [middle, level] = [x + width / 2, y + height / 2];
  await visit.tab.mouse.move(middle, level);
  await expectChange('dragging', async () => {
    await visit.tab.mouse.down();
    await visit.tab.mouse.move(middle + 60, level + 20, { steps: 3 });
    await visit.tab.mouse.up();
  });
  await expectChange('the wheel', () => visit.tab.mouse.wheel(0, -300));
  await visit.tab.focus('#canvas');
  await expectChange('an arrow key', () => visit.tab.keyboard.press('ArrowLeft'));
  await expectChange('the plus key', () => visit.tab.keyboard.press('+'));
  await visit.tab.waitForTimeout(600);
  check(/direction=/.test(visit.tab.url()), `${name}: the address does not follow the camera`);
  await expectChange('the reset button', () => visit.tab.click('#reset'));
  await visit.tab.mouse.move(0, 0);
  check(
    (await eyes.difference(reset, await visit.picture())) === 0,
    `${name}: the reset view is not the first view`,
  );
  const idle = await visit.drawn();
  await visit.tab.waitForTimeout(300);
  check((await visit.drawn()) === idle, `${name}: draws although nothing changes`);
  const [download] = await Promise.all([visit.tab.waitForEvent('download'), visit.tab.click('#save')]);
  const saved = readFileSync(await download.path());
  const size = await eyes.look(saved);
  check(
    size.width === 2 * Math.round(width) && size.colours > 10,
    `${name}: the saved picture is ${size.width} wide and has ${size.colours} colours`,
  );
  check(
    /^[\w.()-]+\.png$/.test(download.suggestedFilename()),
    `${name}: the picture is saved as ${download.suggestedFilename()}`,
  );
  said('dragging, wheel, keys, reset and saving work; nothing is drawn at rest');
}

/// The graphics card may forget everything it was told, as it does when a machine sleeps.
async function checkLoss(visit, eyes, name) {
  const before = await visit.picture();
  await visit.after(() =>
    visit.tab.evaluate(async () => {
      const card = document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
      card.loseContext();
      await new Promise((resolve) => setTimeout(resolve, 100));
      card.restoreContext();
    }),
  );
  check(
    (await eyes.difference(before, await visit.picture())) === 0,
    `${name}: the picture is another one after the graphics card lost it`,
  );
  said('the picture comes back after the graphics card lost it');
}

/// Two fingers that part to twice their distance show everything twice as large.
async function checkPinch(browser, file, name) {
  const visit = await Visit.open(browser, file, { hash: '#zoom=1' });
  const { x, y, width, height } = await visit.tab.locator('#canvas').boundingBox();
  const before = await visit.settings();
  await visit.after(() =>
    visit.tab.evaluate(
      ([left, right, level]) => {
        const canvas = document.getElementById('canvas');
        canvas.setPointerCapture = () => {}; // no such finger
        const touch = (type, pointerId, clientX) =>
          canvas.dispatchEvent(
            new PointerEvent(type, { pointerId, clientX, clientY: level, pointerType: 'touch' }),
          );
        touch('pointerdown', 71, left);
        touch('pointerdown', 72, right);
        touch('pointermove', 71, left - 20);
        touch('pointermove', 72, right + 20);
        touch('pointerup', 71, left - 20);
        touch('pointerup', 72, right + 20);
      },
      [x + width / 2 - 20, x + width / 2 + 20, y + height / 2],
    ),
  );
  const after = await visit.settings();
  check(
    Math.abs(after.zoom / before.zoom - 2) < 1e-6,
    `${name}: fingers that part to twice their distance zoom from ${before.zoom} to ${after.zoom}`,
  );
  await visit.close();
  said('two fingers come nearer');
}

async function checkKeyboard(visit, name) {
  await visit.tab.evaluate(() => document.activeElement.blur());
  const reached = new Set();
  for (let i = 0; i < 30; ++i) {
    await visit.tab.keyboard.press('Tab');
    reached.add(await visit.tab.evaluate(() => document.activeElement.id || document.activeElement.tagName));
  }
  for (const id of ['canvas', ...CONTROLS])
    check(
      reached.has(id) || (await visit.tab.isDisabled(`#${id}`)),
      `${name}: the Tab key does not reach ${id}`,
    );
  check(reached.has('SUMMARY'), `${name}: the Tab key does not reach the tables`);
  for (const id of CONTROLS) {
    const named = await visit.tab
      .locator(`#${id}`)
      .evaluate((e) => e.labels?.length > 0 || e.ariaLabel || e.textContent.trim());
    check(named, `${name}: ${id} has no name for screen readers`);
  }
  said('every control has a name and is reached by the Tab key');
}

async function checkTables(visit, name) {
  const row = visit.tab.locator('#tables tr', { has: visit.tab.locator('th', { hasText: /^volume$/ }) });
  check((await row.count()) === 1 && (await row.isVisible()), `${name}: no table shows the volume`);
  const volume = (await row.count()) ? await row.locator('td').first().textContent() : '';
  check(Number(volume) > 0, `${name}: the volume is "${volume}"`);
  const summary = visit.tab.locator('#tables summary').first();
  await summary.click();
  check(!(await row.isVisible()), `${name}: the table does not fold away`);
  await summary.click();
  said(`the tables show the volume ${volume}`);
}

async function checkPhone(browser, eyes, file, name) {
  const visit = await Visit.open(browser, file, { viewport: PHONE });
  const [wide, inner] = await visit.tab.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  check(wide <= inner, `${name}: ${wide} pixels wide on a phone of ${inner}`);
  for (const id of ['canvas', ...CONTROLS, 'tables']) {
    const place = await visit.tab.locator(`#${id}`).boundingBox();
    check(
      place && place.x >= 0 && place.x + place.width <= PHONE.width && place.height > 0,
      `${name}: ${id} does not fit a phone`,
    );
  }
  const canvas = await visit.tab.locator('#canvas').boundingBox();
  const panel = await visit.tab.locator('#panel').boundingBox();
  check(panel.y >= canvas.y + canvas.height, `${name}: on a phone the tables are not below the picture`);
  check((await eyes.look(await visit.picture())).colours > 10, `${name}: the picture is empty on a phone`);
  check(visit.troubles.length === 0, `${name}, phone: ${visit.troubles.join('; ')}`);
  await visit.close();
  said('fits the width of a phone');
}

async function checkDark(browser, eyes, file, name) {
  const light = {};
  for (const scheme of ['light', 'dark']) {
    const visit = await Visit.open(browser, file, { scheme, hash: '#model=ball' });
    light[scheme] = [
      (await eyes.look(await visit.picture())).light,
      (await eyes.look(await visit.tab.locator('#panel').screenshot())).light,
    ];
    check(visit.troubles.length === 0, `${name}, ${scheme}: ${visit.troubles.join('; ')}`);
    await visit.close();
  }
  for (const i of [0, 1])
    check(
      light.light[i] > 150 && light.dark[i] < 105,
      `${name}: the ${['picture', 'panel'][i]}'s brightness is ${light.light[i]} by day, ${light.dark[i]} by night`,
    );
  said('follows the preference for dark pages');
}

/// What an address asks for is shown, and nonsense in it does no harm.
async function checkAddress(browser, file, name) {
  const visit = await Visit.open(browser, file, {
    hash: '#model=klein&explode=0.25&colour=face&edges=0&direction=0,-1,1&zoom=2&copies=1e99&opacity=x&unknown=1',
  });
  const settings = await visit.settings();
  const expected = { model: 'klein', explode: 0.25, colour: 'face', edges: false, opacity: 1, faces: true };
  for (const [key, value] of Object.entries(expected))
    check(settings[key] === value, `${name}: the address gave ${key} ${settings[key]}, not ${value}`);
  check(Math.abs(settings.zoom - 2) < 1e-6, `${name}: the address gave zoom ${settings.zoom}, not 2`);
  check(
    settings.direction &&
      Math.hypot(
        settings.direction[0],
        settings.direction[1] + Math.SQRT1_2,
        settings.direction[2] - Math.SQRT1_2,
      ) < 1e-6,
    `${name}: the address gave direction ${settings.direction}`,
  );
  await visit.after(() =>
    visit.tab.evaluate(() => {
      location.hash = '#panel=0&model=ball';
    }),
  );
  check(
    (await visit.settings()).model === 'ball' && !(await visit.tab.isVisible('#panel')),
    `${name}: the page does not follow its address`,
  );
  check(visit.troubles.length === 0, `${name}, address: ${visit.troubles.join('; ')}`);
  await visit.close();
  said('does what its address says');
}

/// The page says what is wrong when it cannot show its scene, on the page and not on the console.
async function checkComplaints(browser, file, folder) {
  const text = readFileSync(file, 'utf8');
  const scene = /(<script type="application\/json" id="tetrarch-scene">)([^]*?)(<\/script>)/;
  const variants = {
    'another version': [
      text.replace(scene, (_, a, json, b) => a + json.replace(/"version": ?1/, '"version": 2') + b),
      /version 2/,
      '',
    ],
    'the empty template': [text.replace(scene, '$1TETRARCH_SCENE$3'), /empty template/, ''],
    'a broken array': [
      text.replace(scene, (_, a, json, b) => a + json.replace(/("triangles": ?")..../, '$1////') + b),
      /triangle|names a point/,
      '',
    ],
    'a missing member': [
      text.replace(scene, (_, a, json, b) => a + json.replace(/"copies"/, '"copied"') + b),
      /lacks something/,
      '',
    ],
    'no WebGL': [text, /WebGL/, 'HTMLCanvasElement.prototype.getContext = () => null;'],
  };
  for (const [name, [content, expected, without]] of Object.entries(variants)) {
    const path = join(folder, 'complaint.html');
    writeFileSync(path, content);
    const visit = await Visit.open(browser, path, { without });
    const message = await visit.tab.locator('#message').textContent();
    check(
      (await visit.tab.isVisible('#message')) && expected.test(message),
      `${name}: the page says "${message}"`,
    );
    check(visit.troubles.length === 0, `${name}: ${visit.troubles.join('; ')}`);
    if (without)
      check((await visit.tab.locator('#tables table').count()) > 0, `${name}: the tables are missing too`);
    await visit.close();
    said(`${name}: "${message}"`);
  }
}

async function checkPage(browser, eyes, file) {
  const name = basename(file);
  console.log(name);
  const visit = await Visit.open(browser, file);
  check(
    (await visit.tab.title()).endsWith('Tetrarch') && (await visit.tab.textContent('#title')).length > 0,
    `${name}: no title`,
  );
  await checkTables(visit, name);
  await checkViews(visit, eyes, name);
  await checkControls(visit, eyes, name);
  await checkLoss(visit, eyes, name);
  await checkKeyboard(visit, name);
  check(visit.troubles.length === 0, `${name}: ${visit.troubles.join('; ')}`);
  await visit.close();
  await checkPhone(browser, eyes, file, name);
  await checkAnotherSize(browser, eyes, file, name, PHONE);
}

if (args.length === 0) {
  console.error('usage: browser_test.mjs [--modules FOLDER] PAGE.html...');
  process.exit(2);
}
const folder = mkdtempSync(join(tmpdir(), 'tetrarch-viewer-'));
const browser = await openBrowser({ modules });
try {
  const eyes = await openEyes(browser);
  for (const file of args) await checkPage(browser, eyes, file);
  // What does not depend on the scene is checked with the first page alone.
  console.log('every page');
  await checkDark(browser, eyes, args[0], basename(args[0]));
  await checkAddress(browser, args[0], basename(args[0]));
  await checkPinch(browser, args[0], basename(args[0]));
  console.log('pages that cannot be shown');
  await checkComplaints(browser, args[0], folder);
} catch (error) {
  failures.push(error.message);
  console.log(`FAILED: ${error.stack}`);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
conclude();
