// SPDX-License-Identifier: MIT
// The worker that reads a file and looks for what is wrong with it, so that the page stays awake.
import { formatFromPath, load, type MeshInput, type Warning } from 'kdmanifold';
import { describeError } from './describe-error';
import {
  crossingsOf,
  findingsOf,
  summaryOf,
  type DefectKind,
  type Finding,
  type Summary,
} from './findings';

/** To the worker: a file, or a mesh that the page has made itself. */
export type Source = { name: string; file: File } | { name: string; mesh: MeshInput };

/** From the worker, in this order, the mesh only of a file; after `failed` nothing more comes. */
export type Reply =
  | { type: 'mesh'; mesh: MeshInput; warnings: Warning[] }
  | { type: 'defects'; findings: Finding<DefectKind>[]; summary: Summary }
  | { type: 'crossings'; findings: Finding<DefectKind>[]; pairs: number }
  | { type: 'failed'; message: string };

// TypeScript has the types of a page or of a worker, never both.
const scope = globalThis as unknown as {
  onmessage: (event: MessageEvent<Source>) => void;
  postMessage(reply: Reply, transfer?: ArrayBuffer[]): void;
};

async function inspect(source: Source): Promise<void> {
  const library = await load();
  let mesh: MeshInput;
  if ('mesh' in source) {
    mesh = source.mesh;
  } else {
    const { name, file } = source;
    const format = formatFromPath(name);
    const { warnings, ...read } = library.parseMesh(await file.arrayBuffer(), format, name);
    mesh = read;
    scope.postMessage({ type: 'mesh', mesh, warnings });
  }

  const defects = library.analyze(mesh);
  const findings = findingsOf(mesh, defects);
  scope.postMessage(
    { type: 'defects', findings, summary: summaryOf(defects) },
    findings.map(({ positions }) => positions.buffer),
  );

  // Again, since this may take long, and the rest is not to wait for it.
  const crossing = library.analyze(mesh, { selfIntersections: true });
  const crossings = crossingsOf(mesh, crossing.selfIntersectingFaces);
  scope.postMessage(
    { type: 'crossings', findings: crossings, pairs: crossing.selfIntersections },
    crossings.map(({ positions }) => positions.buffer),
  );
}

scope.onmessage = ({ data }) => {
  inspect(data).catch((error: unknown) => {
    scope.postMessage({ type: 'failed', message: describeError(error) });
  });
};
