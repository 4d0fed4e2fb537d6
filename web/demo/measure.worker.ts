// SPDX-License-Identifier: MIT
// The worker that measures: how far what is shown is from the input, and levels from the result, and
// what can be counted of them. It reads second models too.
import { formatFromPath, load, type FileMesh, type MeshReport } from 'kdmanifold';
import { describeError } from './describe-error';
import { summaryOf, type Summary } from './findings';
import { Reference, type Heat, type Surface } from './measure';

/** What others are measured against. */
export type ReferenceName = 'input' | 'result';

/** To the worker; `keep` has no reply. */
export type Request =
  | { type: 'keep'; name: ReferenceName; surface: Surface }
  | { type: 'heat'; id: number; to: ReferenceName; surface: Surface }
  | { type: 'apart'; id: number; to: ReferenceName; surface: Surface }
  | { type: 'count'; id: number; surface: Surface }
  | { type: 'read'; id: number; file: File };

/** What can be counted of a mesh. */
export interface Counts {
  report: MeshReport;
  summary: Summary;
}

/** From the worker, one for each request. */
export type Reply =
  { id: number; value: Heat | number | Counts | FileMesh } | { id: number; error: string };

// TypeScript has the types of a page or of a worker, never both.
const scope = globalThis as unknown as {
  onmessage: (event: MessageEvent<Request>) => void;
  postMessage(reply: Reply, transfer?: ArrayBuffer[]): void;
};

const surfaces = new Map<ReferenceName, Surface>();
const references = new Map<ReferenceName, Reference>();

function referenceOf(name: ReferenceName): Reference {
  const known = references.get(name);
  if (known !== undefined) return known;
  const surface = surfaces.get(name);
  if (surface === undefined) throw new Error(`nothing is known of the ${name}`);
  const made = new Reference(surface);
  references.set(name, made);
  return made;
}

async function answer(request: Request): Promise<void> {
  if (request.type === 'keep') {
    surfaces.set(request.name, request.surface);
    references.delete(request.name);
    return;
  }
  if (request.type === 'read') {
    const { id, file } = request;
    const content = await file.arrayBuffer();
    const value = (await load()).parseMesh(content, formatFromPath(file.name), file.name);
    scope.postMessage({ id, value });
    return;
  }
  const { id, surface } = request;
  if (request.type === 'count') {
    const { positions, indices } = surface;
    const defects = (await load()).analyze({ positions, indices });
    scope.postMessage({ id, value: { report: defects.report, summary: summaryOf(defects) } });
  } else if (request.type === 'heat') {
    const value = referenceOf(request.to).heat(surface);
    const buffers = [value.positions, value.indices, value.distances].map(({ buffer }) => buffer);
    scope.postMessage({ id, value }, buffers);
  } else {
    scope.postMessage({ id, value: referenceOf(request.to).apart(surface) });
  }
}

scope.onmessage = ({ data }) => {
  answer(data).catch((error: unknown) => {
    if (data.type !== 'keep') scope.postMessage({ id: data.id, error: describeError(error) });
  });
};
