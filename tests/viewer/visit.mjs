// SPDX-License-Identifier: GPL-2.0-or-later
// What the tests of pages share: pages opened in a browser's tabs, and a count of what was found there.
import { address } from '../../tools/viewer/browser.mjs';

const DESKTOP = { width: 820, height: 420 };

let checked = 0;
export const failures = [];

export function check(condition, what) {
  ++checked;
  if (!condition) {
    failures.push(what);
    console.log(`FAILED: ${what}`);
  }
}

export const said = (what) => console.log(`  ${what}`);

/// A page opened in a browser tab, with everything it complained about or asked the network for.
export class Visit {
  static async open(browser, file, { hash = '', viewport = DESKTOP, scheme = 'light', without = '' } = {}) {
    const visit = new Visit();
    visit.troubles = [];
    visit.tab = await browser.newPage({ viewport, colorScheme: scheme });
    visit.tab.on('console', (m) => {
      if (['error', 'warning'].includes(m.type())) visit.troubles.push(`${m.type()}: ${m.text()}`);
    });
    visit.tab.on('pageerror', (error) => visit.troubles.push(`uncaught: ${error.message}`));
    visit.tab.on('request', (request) => {
      if (!request.url().startsWith(address(file)) && !request.url().startsWith('data:'))
        visit.troubles.push(`request: ${request.url()}`);
    });
    visit.tab.on('requestfailed', (request) => visit.troubles.push(`failed: ${request.url()}`));
    if (without) await visit.tab.addInitScript(without);
    await visit.tab.goto(address(file, hash));
    await visit.tab.waitForSelector('html[data-ready]', { state: 'attached' });
    return visit;
  }

  close() {
    return this.tab.close();
  }
  drawn() {
    return this.tab.evaluate(() => window.tetrarch.drawn());
  }
  settings() {
    return this.tab.evaluate(() => window.tetrarch.settings());
  }
  picture() {
    return this.tab.locator('#canvas').screenshot();
  }

  /// Do something and wait until the page has drawn again. Says whether it did.
  async after(act) {
    const before = await this.drawn();
    await act();
    return this.tab
      .waitForFunction((n) => window.tetrarch.drawn() > n, before, { timeout: 8000 })
      .then(
        () => true,
        () => false,
      );
  }

  /// Move a slider as a hand does: the value, then the event.
  slide(id, value) {
    return this.tab.locator(`#${id}`).evaluate((slider, x) => {
      slider.value = x;
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    }, value);
  }

  type(value) {
    return this.tab
      .locator('#copies-number')
      .fill(String(value))
      .then(() => this.tab.locator('#copies-number').press('Enter'));
  }
}

/// A page that gets another size shows what a page of that size shows from the first.
export async function checkAnotherSize(browser, eyes, file, name, viewport) {
  const [grown, first] = [await Visit.open(browser, file), await Visit.open(browser, file, { viewport })];
  await grown.after(() => grown.tab.setViewportSize(viewport));
  await grown.tab.waitForTimeout(500);
  const share = await eyes.difference(await grown.picture(), await first.picture());
  check(share < 1e-3, `${name}: in another size ${share} of the pixels differ from those of a page of that size`);
  await Promise.all([grown.close(), first.close()]);
  said('sees everything in another size');
}

/// Says how the checks went, and ends with 1 when something is wrong.
export function conclude() {
  console.log(
    failures.length ? `${failures.length} of ${checked} checks FAILED` : `all ${checked} checks passed`,
  );
  process.exit(failures.length ? 1 : 0);
}
