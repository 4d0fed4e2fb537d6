// SPDX-License-Identifier: MIT
// Levels of detail on the demo page: sliders, numbers, downloads.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { differentPixels } from '../support/browser.js';
import { few, openDemo, screenshots } from '../support/demo.js';
import { faults, torus } from '../support/meshes.js';

let demo;
let page;
let text;

beforeAll(async () => {
  demo = await openDemo('levels');
  ({ page, text } = demo);
  await demo.choose('ring.obj', torus(64, 32));
}, 180_000);

afterAll(() => demo?.close());

afterEach(() => expect(demo.errors).toEqual([]));

const triangles = () => page.getByRole('slider', { name: 'Triangles' });
const error = () => page.getByRole('slider', { name: 'Error' });
const count = (words) => Number(/([\d,]+) triangles/.exec(words)[1].replace(',', ''));
const shown = async () => count(await text('#output-name'));
const until = (words) =>
  page.waitForFunction((name) => document.querySelector('#output-name').innerText === name, words);
// Where the slider of triangles is, once that is what is shown.
const chosen = async () => {
  const words = await triangles().getAttribute('aria-valuetext');
  await until(words);
  return count(words);
};
const allMeasured = () => demo.waitFor(() => !document.querySelector('#level-error').disabled);

test('nothing is reduced before somebody asks for it', async () => {
  expect(await page.locator('#level-sliders').isVisible()).toBe(false);
  expect(await page.locator('#level-again').isVisible()).toBe(false);
});

test('fewer triangles come by keyboard, without another conversion', async () => {
  const full = await shown();
  const before = await demo.picture('#output-view');
  // A conversion would leave its mark.
  await page.evaluate(() => (document.body.dataset.state = 'untouched'));
  await page.locator('#levels summary').focus();
  await page.keyboard.press('Enter');
  await triangles().waitFor();
  expect(await chosen()).toBe(full);
  await triangles().focus();
  for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowLeft');
  const quarter = await chosen();
  expect(quarter).toBeLessThan(0.3 * full);
  expect(quarter).toBeGreaterThan(0.2 * full);
  expect(await text('#level-triangles-value')).toBe(quarter.toLocaleString('en'));
  expect(await differentPixels(page, await demo.picture('#output-view'), before)).toBeGreaterThan(
    few,
  );
  expect(await page.getAttribute('body', 'data-state')).toBe('untouched');
});

test('the numbers follow what is shown', async () => {
  await allMeasured();
  await page.locator('.numbers summary').click();
  expect(await demo.fact('output-facts', 'Triangles')).toBe((await shown()).toLocaleString('en'));
  expect(await demo.fact('output-facts', '2-manifold')).toBe('yes');
  expect(await text('#verdict')).toBe('Closed · 2-manifold · 1 part · 1 tunnel');
  const apart = Number(await demo.fact('output-facts', 'Furthest from the full result'));
  // Of a tube of radius 1.
  expect(apart).toBeGreaterThan(0.01);
  expect(apart).toBeLessThan(0.3);
  expect(await text('#level-story')).toMatch(
    /^At most [\d.]+ units \([\d.]+ % of the diagonal\) from the full result\.$/,
  );
  await page.screenshot({ path: join(screenshots, 'levels.png'), fullPage: true });
});

test('so does the download', async () => {
  const expected = await shown();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('#save-ply').click(),
  ]);
  expect(download.suggestedFilename()).toBe(`ring-manifold-${expected}.ply`);
  const mesh = demo.kdm.parseMesh(readFileSync(await download.path()), 'ply');
  expect(mesh.indices.length / 3).toBe(expected);
  expect(faults(mesh)).toEqual([]);
});

test('the error says how few triangles will do', async () => {
  await error().fill('0');
  const full = await chosen();
  await until(`${full.toLocaleString('en')} triangles`);
  expect(await text('#level-story')).toBe('This is the full result.');
  expect(await demo.fact('output-facts', 'Inserted vertices')).toBe('0');
  let before = [full, 0];
  for (const place of [40, 70, 100]) {
    await error().fill(String(place));
    const now = [await chosen(), Number(await text('#level-error-value'))];
    expect(now[0]).toBeLessThan(before[0]);
    expect(now[1]).toBeGreaterThan(before[1]);
    before = now;
  }
  // The tunnel stays whatever is allowed.
  await demo.waitFor(() => /1 tunnel/.test(document.querySelector('#verdict').innerText));
  // The sliders go together, and the one of the error does not stick between two levels.
  await triangles().press('End');
  expect(await error().inputValue()).toBe('0');
  await error().focus();
  for (let i = 0; i < 40; ++i) await page.keyboard.press('ArrowRight');
  expect(await error().inputValue()).toBe('40');
});

test('a new result has levels of its own', async () => {
  await demo.busyThenSettled(() => page.locator('#tolerance').fill('-2'));
  const full = await shown();
  await triangles().waitFor();
  expect(await chosen()).toBe(full);
});

test('the making of levels can be stopped, and taken up again', async () => {
  const panel = page.locator('#levels summary');
  await panel.click();
  await demo.choose('ring.obj', torus(64, 32));
  // As soon as there is a button to be pressed.
  await page.evaluate(() => {
    const stop = document.querySelector('#level-stop');
    const press = () => {
      if (!stop.parentElement.hidden) stop.click();
    };
    new window.MutationObserver(press).observe(stop.parentElement, { attributes: true });
    document.querySelector('#levels').open = true;
    document.querySelector('#levels').addEventListener('toggle', press, { once: true });
  });
  await demo.waitFor(() => document.querySelector('#level-message').innerText === 'Stopped.');
  expect(await triangles().isVisible()).toBe(false);
  expect(await page.locator('#level-again').isVisible()).toBe(true);
});

test('where there can be no levels it is said why', async () => {
  const { positions, indices } = torus();
  await demo.busyThenSettled(() => page.selectOption('#make', 'sheet'));
  await demo.choose('open.obj', { positions, indices: indices.slice(30) });
  expect(await text('#verdict')).toMatch(/^Open/);
  expect(await text('#level-message')).toBe('Levels are made of closed results without quads.');
  expect(await page.locator('#level-again').isVisible()).toBe(false);
});
