// SPDX-License-Identifier: MIT
// Wires the page together: where models come from, when to convert, where results go.
import {
  formatFromPath,
  load,
  makeManifold,
  type Mesh,
  type MeshFormat,
  type MeshInput,
} from 'kdmanifold';
import { samples } from './models';
import {
  element,
  explainSize,
  readLines,
  readOptions,
  showBusy,
  showError,
  showInput,
  showProgress,
  showResult,
} from './panel';
import { Stage } from './scene';

// Changes of a slider come in bursts.
const settleMilliseconds = 250;

let input: { name: string; mesh: MeshInput } | null = null;
let result: Mesh | null = null;
let running: AbortController | null = null;
let settling = 0;

const stage = new Stage(
  element('stage'),
  element<HTMLCanvasElement>('canvas'),
  element('input-view'),
  element('output-view'),
);

function describeError(error: unknown): string {
  if (!(error instanceof Error)) return String(error);
  const { code } = error as { code?: string };
  return code === undefined ? error.message : `${code}: ${error.message}`;
}

async function convert(): Promise<void> {
  running?.abort();
  if (input === null) return;
  const mine = (running = new AbortController());
  result = null;
  showBusy();
  try {
    const conversion = await makeManifold(input.mesh, {
      ...readOptions(),
      onProgress: showProgress,
      signal: mine.signal,
    });
    if (running !== mine) return;
    result = conversion.mesh;
    stage.show('output', result);
    showResult(conversion);
  } catch (error) {
    if (running !== mine) return;
    stage.show('output', null);
    showError(describeError(error));
  }
}

function take(name: string, mesh: MeshInput): Promise<void> {
  input = { name, mesh };
  showInput(name, (mesh.indices ?? mesh.positions).length / (mesh.indices ? 3 : 9));
  stage.show('output', null);
  stage.show('input', mesh);
  updateCut();
  return convert();
}

async function open(file: File): Promise<void> {
  running?.abort();
  running = null;
  showBusy();
  element('verdict').textContent = `Reading ${file.name}…`;
  try {
    const library = await load();
    const bytes = await file.arrayBuffer();
    await take(file.name, library.parseMesh(bytes, formatFromPath(file.name), file.name));
  } catch (error) {
    input = null;
    showInput(file.name, 0);
    stage.show('input', null);
    stage.show('output', null);
    showError(describeError(error));
  }
}

async function save(format: MeshFormat): Promise<void> {
  if (result === null || input === null) return;
  try {
    const library = await load();
    const url = URL.createObjectURL(new Blob([library.formatMesh(result, format)]));
    const link = document.createElement('a');
    link.href = url;
    link.download = `${input.name.replace(/\.[^.]*$/, '')}-manifold.${format}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
  } catch (error) {
    showError(describeError(error));
  }
}

function convertSoon(): void {
  explainSize();
  clearTimeout(settling);
  settling = window.setTimeout(() => void convert(), settleMilliseconds);
}

function updateCut(): void {
  stage.setCut(element<HTMLInputElement>('cut').valueAsNumber / 100);
}

function takeSample(): void {
  const sample = samples[element<HTMLSelectElement>('sample').selectedIndex];
  if (sample !== undefined) void take(sample.name, sample.make());
}

function connect(): void {
  const sampleMenu = element<HTMLSelectElement>('sample');
  sampleMenu.append(...samples.map(({ name }) => new Option(name)));
  sampleMenu.addEventListener('change', takeSample);

  const file = element<HTMLInputElement>('file');
  file.addEventListener('change', () => {
    const [chosen] = file.files ?? [];
    if (chosen !== undefined) void open(chosen);
  });
  element('panel').addEventListener('submit', (event) => event.preventDefault());

  for (const id of ['depth', 'tolerance']) element(id).addEventListener('input', convertSoon);
  for (const id of ['strategy', 'inside', 'pairing', 'quads']) {
    element(id).addEventListener('change', convertSoon);
  }
  for (const id of ['wireframe', 'creases']) {
    element(id).addEventListener('change', () => stage.setLines(readLines()));
  }
  element('cut').addEventListener('input', updateCut);
  element('reset-view').addEventListener('click', () => stage.resetView());
  element('cancel').addEventListener('click', () => running?.abort());
  for (const format of ['obj', 'stl', 'ply'] as const) {
    element(`save-${format}`).addEventListener('click', () => void save(format));
  }

  addEventListener('dragover', (event) => {
    event.preventDefault();
    document.body.classList.add('dropping');
  });
  addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) document.body.classList.remove('dropping');
  });
  addEventListener('drop', (event) => {
    event.preventDefault();
    document.body.classList.remove('dropping');
    const [dropped] = event.dataTransfer?.files ?? [];
    if (dropped !== undefined) void open(dropped);
  });
}

connect();
explainSize();
takeSample();
