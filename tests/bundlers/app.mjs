// SPDX-License-Identifier: MIT
// The application that every bundler is given: it converts a tetrahedron and says how that went.

const shape = `
const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
const indices = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);`;

/** Uses both ways into the package, the worker's and the calling thread's. */
export const check = `${shape}

export async function check() {
  const { mesh, report } = await makeManifold({ positions, indices });
  const kdm = await load();
  const again = kdm.parseMesh(kdm.formatMesh(mesh, 'stl'), 'stl');
  await close();
  const { twoManifold } = report.output;
  return { thread: report.thread, threads: report.threads, twoManifold, same: again.indices.length === mesh.indices.length };
}`;

/** A page's script; the title tells the outcome. */
export const script = `import { close, load, makeManifold } from 'kdmanifold';
${check.replace('export ', '')}

check().then(
  (outcome) => (document.title = JSON.stringify(outcome)),
  (error) => (document.title = JSON.stringify({ error: String(error) })),
);
`;

/** The same in a module worker of the application's own. */
export const ownWorker = `import { close, load, makeManifold } from 'kdmanifold';
${check.replace('export ', '')}

check().then(postMessage, (error) => postMessage({ error: String(error) }));
`;

/** The page of \`ownWorker\`. */
export const ownWorkerScript = `
const worker = new Worker(new URL('./own-worker.js', import.meta.url), { type: 'module' });
worker.onmessage = ({ data }) => (document.title = JSON.stringify(data));
`;

/** A page that loads a script. */
export const html = (source, head = '') => `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <link rel="icon" href="data:," />
    ${head}
    <script type="module" src="${source}"></script>
  </head>
</html>
`;
