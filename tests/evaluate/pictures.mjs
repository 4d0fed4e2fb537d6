// SPDX-License-Identifier: MIT
/* global document -- of the page */
// `npm run pictures -- MODEL... [--tolerance R] [--set CONTROL=VALUE]... [--out DIR]`
// Input beside result from all sides and cut open, one contact sheet a model, as the demo page shows
// them: what no figure tells (lost parts, filled insides, fins, wrinkles) is to be looked at.
// Controls of the page are named by their ids: `--set creases=false --set up=y`.
import { mkdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { builders } from '../../scripts/build.mjs';
import { root, setup } from '../../scripts/run.mjs';
import { serve } from '../js/support/server.js';
import { commandLine, modelFiles, nameOf } from '../bench/shared.mjs';

const sides = ['corner', 'front', 'right', 'back', 'left', 'above', 'below'];
const viewport = { width: 1280, height: 800 };

const options = commandLine({
  out: { type: 'string', default: 'build/pictures' },
  set: { type: 'string', multiple: true, default: [] },
  tolerance: { type: 'string', default: '0.002' },
});
if (options.models.length === 0) {
  console.error('pictures: name models, or folders of them');
  process.exit(2);
}
const files = modelFiles(options.models, []);
const folder = resolve(process.env.INIT_CWD ?? process.cwd(), options.out);
mkdirSync(folder, { recursive: true });
setup('test');
builders.package();
// Here, not at the top: both need what set-up installs.
const { build } = await import('vite');
const { launch, openPage } = await import('../js/support/browser.js');
await build({ configFile: join(root, 'web/demo/vite.config.ts'), logLevel: 'warn' });

const server = await serve(join(root, 'build/demo'));
const browser = await launch();
try {
  const { page, errors } = await openPage(browser, `${server.address}/`, { viewport });
  await settle(page);
  await page.evaluate(() => document.querySelectorAll('details').forEach((it) => (it.open = true)));
  // The slider's steps are tenths of a power of ten.
  const tolerance = Math.log10(Number(options.tolerance)).toFixed(1);
  for (const setting of [`tolerance=${tolerance}`, ...options.set]) {
    await set(page, ...setting.split('='));
  }
  for (const file of files) {
    const path = join(folder, `${nameOf(file)}.png`);
    await photograph(page, file, path);
    console.log(path, await page.locator('#verdict').innerText());
  }
  if (errors.length > 0) throw new Error(errors.join('\n'));
} finally {
  await browser.close();
  await server.close();
}

async function settle(page) {
  await page.waitForFunction(
    () => {
      const { state, inspection } = document.body.dataset;
      return ['done', 'error'].includes(state) && inspection === 'done';
    },
    null,
    { timeout: 600_000 },
  );
}

async function set(page, id, value) {
  const control = page.locator(`#${id}`);
  const kind = await control.evaluate((it) => `${it.localName} ${it.type}`);
  if (kind.startsWith('select')) await control.selectOption(value);
  else if (kind === 'input checkbox') await control.setChecked(value !== 'false');
  else await control.fill(value);
}

async function photograph(page, file, path) {
  await page.evaluate(() => (document.body.dataset.state = 'waiting'));
  await page.locator('#file').setInputFiles(file);
  await settle(page);
  // What was set counts for all models, but for the upward axis, which goes by the file's type.
  for (const setting of options.set.filter((it) => it.startsWith('up='))) {
    await set(page, ...setting.split('='));
  }
  const shots = [];
  const shoot = async (title) => {
    await page.waitForTimeout(400);
    const picture = await page.locator('#stage').screenshot();
    shots.push({ title, picture: picture.toString('base64') });
  };
  for (const side of sides) {
    await page.locator(`[data-side="${side}"]`).click();
    await shoot(side);
  }
  await page.locator('[data-side="corner"]').click();
  await page.locator('#cut').fill('50');
  await shoot('cut open');
  await page.locator('#cut').fill('0');
  const words = (await page.locator('.status > p:visible').allInnerTexts()).join('\n');
  const sheet = await browser.newPage({ viewport: { width: 1600, height: 1000 } });
  await sheet.evaluate(layOut, { shots, title: nameOf(file), words });
  await sheet.waitForTimeout(300);
  await sheet.screenshot({ path, fullPage: true });
  await sheet.close();
}

// Runs in the browser.
function layOut({ shots, title, words }) {
  const add = (parent, tag, style, text = '') => {
    const made = document.createElement(tag);
    made.style.cssText = style;
    made.textContent = text;
    parent.append(made);
    return made;
  };
  document.body.style.cssText = 'margin: 8px; font: 15px sans-serif';
  add(document.body, 'b', '', title);
  add(document.body, 'p', 'margin: 4px 0; white-space: pre-line', words);
  const grid = add(document.body, 'div', 'display: grid; grid-template-columns: 1fr 1fr; gap: 4px');
  for (const { title: side, picture } of shots) {
    const cell = add(grid, 'div', 'position: relative');
    add(cell, 'img', 'width: 100%').src = `data:image/png;base64,${picture}`;
    add(cell, 'span', 'position: absolute; left: 8px; bottom: 10px', side);
  }
}
