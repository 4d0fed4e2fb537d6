// SPDX-License-Identifier: MIT
// Hands a mesh to the visitor as a file.
import { load, type Mesh, type MeshFormat } from 'kdmanifold';

// Browsers take a while to read what a link leads to.
const keptMilliseconds = 60_000;

/** Downloads a mesh; `name` goes without the extension. */
export async function download(mesh: Mesh, name: string, format: MeshFormat): Promise<void> {
  const library = await load();
  const url = URL.createObjectURL(new Blob([library.formatMesh(mesh, format)]));
  const link = document.createElement('a');
  link.href = url;
  link.download = `${name}.${format}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), keptMilliseconds);
}
