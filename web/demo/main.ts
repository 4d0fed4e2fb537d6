// SPDX-License-Identifier: MIT
// Wires the page together: where models come from, when to inspect and convert, where results go.
import type { Mesh, MeshFormat, MeshInput, Warning } from 'kdmanifold';
import { Beside } from './beside';
import { showChanges, type Account } from './changes';
import {
  changeUnit,
  chooseMake,
  explainControls,
  forgetError,
  learnOfError,
  learnOfGaps,
  measure,
  readLines,
  readOptions,
  setGaps,
  type Make,
} from './controls';
import { describeError } from './describe-error';
import { download } from './download';
import { element } from './element';
import type { Summary } from './findings';
import { HeatPanel } from './heat-panel';
import type { Reply, Source } from './inspect.worker';
import { Inspector } from './inspector';
import { CoarseJoin, convertBoth, together } from './join';
import { Latest } from './latest';
import type { Level } from './levels';
import { LevelsPanel } from './levels-panel';
import { Measurer } from './measurer';
import { samples } from './models';
import { Painted } from './painted';
import {
  showBusy,
  showError,
  showInput,
  showProgress,
  showReduced,
  showResult,
  showRough,
  tell,
} from './panel';
import { Stage } from './scene';
import { SecondModel } from './second-model';
import type { Side } from './sides';
import { storyOf } from './story';

// Changes of a slider come in bursts.
const settleMilliseconds = 250;

let input: { name: string; mesh: MeshInput; warnings: Warning[] } | null = null;
let summary: Summary | null = null;
let result: Mesh | null = null;
// What the result consists of, once that is known.
let outcome: Account | null = null;
// Tells again of the result itself, after a level of it.
let showFull = (): void => undefined;
// What names of files say of it.
let operation = '';
let running: AbortController | null = null;
let settling = 0;

const inspector = new Inspector();
const measurer = new Measurer();
const stage = new Stage(
  element('stage'),
  element<HTMLCanvasElement>('canvas'),
  element('input-view'),
  element('output-view'),
);
const painted = new Painted(stage);
const levels = new LevelsPanel(
  measurer,
  (level, isFull) => void showLevel(level, isFull).catch(complain),
  (level) => {
    beside.tell(level);
    if (level.mesh === result) tellOfLevel(level).catch(complain);
  },
);

const beside = new Beside(stage, () => heat.refresh());
const heat = new HeatPanel(stage, measurer, complain);

const second = new SecondModel(
  stage.makeGizmo((dragging) => {
    second.update();
    if (dragging) live.go();
    else void convert();
  }),
  (file) => measurer.read(file),
  () => stage.ball,
  convertSoon,
  complain,
);
// Rough results while the second model is dragged.
const live = new Latest(convertRoughly);
const coarse = new CoarseJoin();

async function convert(): Promise<void> {
  live.stop();
  running?.abort();
  if (input === null) return;
  const mine = (running = new AbortController());
  result = null;
  forgetLevels();
  tellChanges(null);
  forgetError();
  showBusy();
  try {
    const options = readOptions();
    const { mesh } = input;
    const { joined } = second;
    if (joined === null) coarse.forget();
    const conversion = await convertBoth(mesh, joined, {
      ...options,
      onProgress: showProgress,
      signal: mine.signal,
    });
    if (running !== mine) return;
    measurer.keep('input', joined ? together(mesh, joined) : mesh);
    operation = joined ? `-${joined.operation}` : '';
    const warnings = [...input.warnings, ...(joined?.warnings ?? [])];
    const { report } = conversion;
    result = conversion.mesh;
    painted.showResult(result, { input: mesh, report });
    heat.forget();
    showFull = () => showResult(conversion, { thickness: options.thicken, warnings });
    showFull();
    learnOfGaps(report);
    learnOfError(report, options.thicken);
    explainControls();
    countResult(result).catch(complain);
    levels.take({ mesh: result, extent: report.input.extent, closed: report.output.twoManifold });
  } catch (error) {
    if (running !== mine) return;
    painted.showResult(null);
    heat.refresh();
    showError(describeError(error));
  }
}

function forgetLevels(): void {
  levels.take(null);
  beside.clear();
}

// What was stopped on purpose is no news.
function complain(error: unknown): void {
  if (!(error instanceof DOMException)) showError(describeError(error));
}

async function convertRoughly(): Promise<void> {
  const { joined } = second;
  if (input === null || joined === null) return;
  running?.abort();
  const mine = (running = new AbortController());
  // All else stays until it is let go: what comes and goes would move the stage.
  result = null;
  let mesh: Mesh | null = null;
  let words = 'Rough, until you let go.';
  try {
    ({ mesh } = await coarse.convert(input.mesh, joined, readOptions()));
  } catch (error) {
    // The whole conversion says why.
    words = `No result here (${describeError(error).replace(/:.*/s, '')}).`;
  }
  if (running !== mine) return;
  showRough(words);
  painted.showResult(mesh);
  heat.refresh();
}

// A level of detail in place of the result.
async function showLevel(level: Level, isFull: boolean): Promise<void> {
  result = level.mesh;
  painted.showInstead(result);
  heat.refresh();
  if (!isFull) return tellOfLevel(level);
  showFull();
  await countResult(result);
}

async function tellOfLevel(level: Level): Promise<void> {
  const counts = await measurer.count(level.mesh);
  if (result !== level.mesh) return;
  showReduced(counts.report, level.apart);
  tellChanges({ summary: counts.summary, triangles: counts.report.triangles });
}

async function countResult(mesh: Mesh): Promise<void> {
  const { report, summary } = await measurer.count(mesh);
  if (result === mesh) tellChanges({ summary, triangles: report.triangles });
}

function tellChanges(after: Account | null): void {
  outcome = after;
  element('changes-input').textContent = second.joined ? 'First model' : 'Input';
  showChanges(summary && input && { summary, triangles: trianglesOf(input.mesh) }, outcome);
}

const trianglesOf = ({ positions, indices }: MeshInput): number =>
  indices ? indices.length / 3 : positions.length / 9;

// No format says which way is up; these are mostly scans and models for pictures, the others parts.
function upOf(name: string): 'y' | 'z' {
  return /\.(obj|ply)$/i.test(name) ? 'y' : 'z';
}

// A new input: the one before is no longer worked on.
function begin(source: Source): void {
  running?.abort();
  running = null;
  input = null;
  summary = null;
  forgetLevels();
  live.stop();
  second.forget();
  measurer.stop();
  tellChanges(null);
  stage.show('input', null);
  painted.forget();
  heat.refresh();
  showInput(source.name);
  showBusy();
  if ('mesh' in source) {
    take(source.name, source.mesh);
  } else {
    element('verdict').textContent = `Reading ${source.name}…`;
    // The menu names what is shown, and the sample that it named can be chosen again.
    element<HTMLSelectElement>('sample').selectedIndex = -1;
  }
  document.body.dataset.inspection = 'busy';
  inspector.inspect(source, (reply) => hear(source.name, reply));
}

function take(name: string, mesh: MeshInput, warnings: Warning[] = []): void {
  input = { name, mesh, warnings };
  showInput(name, trianglesOf(mesh));
  measure(mesh);
  explainControls();
  const up = upOf(name);
  element<HTMLSelectElement>('up').value = up;
  stage.setUp(up);
  stage.show('input', mesh);
  updateCut();
  void convert();
}

// Reading or converting, whichever is under way; the inspection of what has been read goes on.
function stop(): void {
  running?.abort();
  if (input !== null) return;
  inspector.stop();
  document.body.dataset.inspection = 'done';
  showError('ABORTED: the file has not been read to its end');
}

// What the inspection finds comes bit by bit.
function hear(name: string, reply: Reply): void {
  if (reply.type === 'mesh') return take(name, reply.mesh, reply.warnings);
  document.body.dataset.inspection = reply.type === 'defects' ? 'busy' : 'done';
  if (reply.type === 'failed') {
    // Without a mesh there is no conversion to say it.
    if (input === null) showError(reply.message);
    tell('');
    return;
  }
  if (reply.type === 'defects') {
    summary = reply.summary;
    tellChanges(outcome);
  }
  painted.add(reply.findings);
  if (summary !== null) tell(storyOf(summary, painted.defects, reply.type === 'crossings'));
}

function save(format: MeshFormat): void {
  if (result === null || input === null) return;
  const name = input.name.replace(/\.[^.]*$/, '');
  const made = `${operation || '-manifold'}${levels.suffix}`;
  download(result, `${name}${made}`, format).catch(complain);
}

function convertSoon(): void {
  explainControls();
  clearTimeout(settling);
  settling = window.setTimeout(() => void convert(), settleMilliseconds);
}

function updateCut(): void {
  stage.setCut(element<HTMLInputElement>('cut').valueAsNumber / 100);
}

function takeSample(): void {
  const sample = samples[element<HTMLSelectElement>('sample').selectedIndex];
  if (sample !== undefined) begin({ name: sample.name, mesh: sample.make() });
}

function connect(): void {
  const sampleMenu = element<HTMLSelectElement>('sample');
  sampleMenu.append(...samples.map(({ name }) => new Option(name)));
  sampleMenu.addEventListener('change', takeSample);

  const file = element<HTMLInputElement>('file');
  file.addEventListener('change', () => {
    const [chosen] = file.files ?? [];
    if (chosen !== undefined) begin({ name: chosen.name, file: chosen });
  });
  element('panel').addEventListener('submit', (event) => event.preventDefault());

  element('gaps').addEventListener('input', setGaps);
  for (const id of ['depth', 'tolerance', 'thickness', 'gaps']) {
    element(id).addEventListener('input', convertSoon);
  }
  for (const id of ['make', 'parts', 'strategy', 'inside', 'pairing', 'quads']) {
    element(id).addEventListener('change', convertSoon);
  }
  element('thickness-unit').addEventListener('change', () => {
    changeUnit();
    explainControls();
  });
  for (const id of ['wireframe', 'creases']) {
    element(id).addEventListener('change', () => stage.setLines(readLines()));
  }
  const up = element<HTMLSelectElement>('up');
  up.addEventListener('change', () => {
    stage.setUp(up.value as 'y' | 'z');
    updateCut();
  });
  for (const button of document.querySelectorAll<HTMLElement>('[data-make]')) {
    button.addEventListener('click', () => {
      chooseMake(button.dataset.make as Make);
      explainControls();
      void convert();
    });
  }
  element('repair').addEventListener('click', () => {
    element<HTMLSelectElement>('inside').value = 'repair';
    explainControls();
    void convert();
  });
  element('cut').addEventListener('input', updateCut);
  for (const button of document.querySelectorAll<HTMLElement>('[data-side]')) {
    button.addEventListener('click', () => stage.lookFrom(button.dataset.side as Side));
  }
  element('level-keep').addEventListener('click', () => {
    const level = levels.shown;
    if (level !== undefined) beside.keep(level);
  });
  element('cancel').addEventListener('click', stop);
  for (const format of ['obj', 'stl', 'ply'] as const) {
    element(`save-${format}`).addEventListener('click', () => save(format));
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
    if (dropped !== undefined) begin({ name: dropped.name, file: dropped });
  });
}

connect();
explainControls();
takeSample();
