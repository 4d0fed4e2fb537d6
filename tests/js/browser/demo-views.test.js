// SPDX-License-Identifier: MIT
// What the demo page's stage shows beside input and result: levels under one camera, and distances.
import { join } from 'node:path';
import { differentPixels, openPage } from '../support/browser.js';
import { few, openDemo, screenshots } from '../support/demo.js';
import { cube, torus } from '../support/meshes.js';

let demo;
let page;
let text;
let picture;

beforeAll(async () => {
  demo = await openDemo('views');
  ({ page, text, picture } = demo);
  await demo.choose('ring.obj', torus(64, 32));
  await page.locator('#levels summary').click();
  await triangles().waitFor();
}, 180_000);

afterAll(() => demo?.close());

afterEach(() => expect(demo.errors).toEqual([]));

const triangles = () => page.getByRole('slider', { name: 'Triangles' });
const level = (n) => page.getByRole('region', { name: /^Level of/ }).nth(n);
const keep = () => page.getByRole('button', { name: 'Keep this beside' });
const keepCoarser = async (steps) => {
  await triangles().focus();
  for (let i = 0; i < steps; ++i) await page.keyboard.press('ArrowLeft');
  const words = await triangles().getAttribute('aria-valuetext');
  await keep().press('Enter');
  return words;
};

test('levels stay beside original and result, by keyboard', async () => {
  const kept = [await keepCoarser(4), await keepCoarser(4)];
  expect(await page.locator('#stage .view h2').allInnerTexts()).toEqual(
    ['Input', 'Result', 'Level', 'Level'].map((word) => word.toUpperCase()),
  );
  for (const i of [0, 1]) expect(await level(i).innerText()).toContain(kept[i]);
  // All views are equally large, and show something of their own.
  const views = page.locator('#stage .view');
  const boxes = await Promise.all([0, 1, 2, 3].map((i) => views.nth(i).boundingBox()));
  for (const { width, height } of boxes) {
    expect(Math.abs(width - boxes[0].width)).toBeLessThan(2);
    expect(Math.abs(height - boxes[0].height)).toBeLessThan(2);
  }
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(screenshots, 'beside.png'), fullPage: true });
  expect((await level(0).screenshot()).length).toBeGreaterThan(4000);
  // The same one is not kept twice.
  await keep().press('Enter');
  expect(await page.locator('#stage .view').count()).toBe(4);
});

test('one camera looks at all of them', async () => {
  const all = ['#input-view', '#output-view', '#stage > .view:last-child'];
  const before = [];
  for (const view of all) before.push(await picture(view));
  await page.locator('#stage').focus();
  await page.keyboard.press('ArrowRight');
  for (const [i, view] of all.entries()) {
    expect(await differentPixels(page, await picture(view), before[i])).toBeGreaterThan(few);
  }
  await page.keyboard.press('ArrowLeft');
  for (const [i, view] of all.entries()) {
    expect(await differentPixels(page, await picture(view), before[i])).toBeLessThan(few);
  }
});

test('distances are colours with a legend in units, on all results alike', async () => {
  await triangles().press('End');
  const bare = await picture('#stage > .view:last-child');
  const input = await picture('#input-view');
  await page.getByRole('checkbox', { name: 'Distance from the input' }).press('Space');
  const legend = page.getByRole('figure', {
    name: /^Distance from the input, in the model's units/,
  });
  await legend.waitFor();
  const coarse = await picture('#stage > .view:last-child');
  expect(await differentPixels(page, coarse, bare)).toBeGreaterThan(1000);
  expect(await differentPixels(page, await picture('#input-view'), input)).toBeLessThan(few);
  const ticks = await Promise.all([0, 1, 2].map((i) => text(`#heat-${i}`)));
  expect(ticks[0]).toBe('0');
  expect(Number(ticks[1])).toBeCloseTo(Number(ticks[2]) / 2, 1);
  // What the levels were measured to be from the result is nearly the same.
  await demo.waitFor(() => !document.querySelector('#level-error').disabled);
  const [kept] = /[\d.]+$/.exec(await text('#stage > .view:last-child p'));
  expect(Number(ticks[2])).toBeGreaterThan(0.7 * Number(kept));
  expect(Number(ticks[2])).toBeLessThan(1.3 * Number(kept));
  await page.screenshot({ path: join(screenshots, 'heat.png'), fullPage: true });
});

test('views go one by one, and what was kept goes with its result', async () => {
  await level(1)
    .getByRole('button', { name: /^Remove/ })
    .press('Enter');
  expect(await page.locator('#stage .view').count()).toBe(3);
  expect(await keep().evaluate((button) => button === document.activeElement)).toBe(true);
  await demo.choose('other.obj', torus(32, 16));
  expect(await page.locator('#stage .view').count()).toBe(2);
});

test('the legend goes to the largest distance of any spot, also where holes were closed', async () => {
  // In the middle of the side that is closed, 1 away from all others.
  const { positions, indices } = cube();
  await demo.choose('open.obj', { positions, indices: indices.slice(6) });
  await demo.waitFor(() => !document.querySelector('#heat-legend').hidden);
  await demo.waitFor(() => document.querySelector('#heat-2').innerText === '1');
  expect(await text('#heat-1')).toBe('0.5');
  await page.locator('#heat').uncheck();
  expect(await page.locator('#heat-legend').isVisible()).toBe(false);
});

test('four views go on a narrow screen', async () => {
  const { page: narrow, errors } = await openPage(demo.browser, `${demo.address}/`, {
    viewport: { width: 390, height: 844 },
    colorScheme: 'dark',
  });
  await narrow.waitForFunction(() => document.body.dataset.state === 'done');
  await narrow.locator('#levels summary').click();
  await narrow.locator('#level-triangles').waitFor();
  for (const place of [3, 6]) {
    await narrow.locator('#level-triangles').fill(String(place));
    await narrow.locator('#level-keep').click();
  }
  await narrow.locator('#heat').check();
  await narrow.locator('#heat-legend').waitFor();
  const overflow = await narrow.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  expect(overflow).toBe(0);
  await narrow.waitForTimeout(300);
  await narrow.screenshot({ path: join(screenshots, 'narrow-views.png'), fullPage: true });
  expect(errors).toEqual([]);
  await narrow.close();
});
