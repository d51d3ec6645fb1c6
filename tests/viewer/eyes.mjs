// SPDX-License-Identifier: GPL-2.0-or-later
// Looks at screenshots: a blank tab of the browser decodes and compares them, so that no image library is
// needed.

/// A tab that keeps pictures under names.
export async function openEyes(browser) {
  const tab = await browser.newPage();
  await tab.evaluate(() => {
    const pixels = async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const pen = new OffscreenCanvas(image.width, image.height).getContext('2d', {
        willReadFrequently: true,
      });
      pen.drawImage(image, 0, 0);
      return pen.getImageData(0, 0, image.width, image.height);
    };
    window.difference = async (first, second) => {
      const [a, b] = [await pixels(first), await pixels(second)];
      if (a.width !== b.width || a.height !== b.height) return 1;
      let changed = 0;
      for (let i = 0; i < a.data.length; i += 4)
        changed += Math.max(...[0, 1, 2].map((k) => Math.abs(a.data[i + k] - b.data[i + k]))) > 8;
      return changed / (a.width * a.height);
    };
    window.lookAt = async (picture) => {
      const { data, width, height } = await pixels(picture);
      const colours = new Set();
      let light = 0;
      for (let i = 0; i < data.length; i += 4) {
        colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
        light += (data[i] + data[i + 1] + data[i + 2]) / 3;
      }
      return { colours: colours.size, light: light / (width * height), width, height };
    };
  });
  const text = (picture) => picture.toString('base64');
  return {
    /// The share of pixels in which two pictures differ visibly.
    difference: (a, b) => tab.evaluate(([x, y]) => window.difference(x, y), [text(a), text(b)]),
    /// The number of colours, the mean brightness from 0 to 255, and the size.
    look: (a) => tab.evaluate((x) => window.lookAt(x), text(a)),
  };
}
