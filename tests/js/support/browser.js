// SPDX-License-Identifier: MIT
// Chromium without a window, its pages watched for errors.
import { chromium } from 'playwright-core';

const flags = [
  '--no-sandbox',
  // WebGL without a graphics card.
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  // Nothing in the background, nothing over the network.
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

export const launch = () =>
  chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: flags });

/** A page; what goes wrong in it is put into `errors`, what it warns of into `warnings`. */
export async function openPage(browser, address, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 860 }, ...options });
  const errors = [];
  const warnings = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') errors.push(message.text());
    if (message.type() === 'warning') warnings.push(message.text());
  });
  await page.goto(address);
  return { page, errors, warnings };
}

/** How many pixels of two screenshots differ visibly; edges may be smoothed a little differently. */
export const differentPixels = (page, first, second) =>
  page.evaluate(
    async (pictures) => {
      const [a, b] = await Promise.all(
        pictures.map(async (base64) => {
          const bytes = Uint8Array.from(window.atob(base64), (char) => char.charCodeAt(0));
          const image = await window.createImageBitmap(new window.Blob([bytes]));
          const context = new window.OffscreenCanvas(image.width, image.height).getContext('2d');
          context.drawImage(image, 0, 0);
          return context.getImageData(0, 0, image.width, image.height);
        }),
      );
      if (a.width !== b.width || a.height !== b.height) return Infinity;
      let count = 0;
      for (let i = 0; i < a.data.length; i += 4) {
        const far = [0, 1, 2].some((c) => Math.abs(a.data[i + c] - b.data[i + c]) > 16);
        count += far ? 1 : 0;
      }
      return count;
    },
    [first, second].map((picture) => picture.toString('base64')),
  );
