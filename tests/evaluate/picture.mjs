// SPDX-License-Identifier: MIT
/* global document -- of the page */
// Pictures of meshes as they are, side by side in rows, all seen by the same camera.
import { root } from '../../scripts/run.mjs';
import { serve } from '../js/support/server.js';

const columns = 5;
const page = { '/picture.html': '<!doctype html><title>Picture</title>', '/favicon.ico': '' };

/**
 * Draws meshes, each { title, mesh }, into a PNG file. `from` is the direction to the camera, `up` the upward axis. With
 * `lines` the edges are drawn. `cut` is a direction: what lies that way from the first mesh's middle is left out, and the
 * insides of surfaces, which are seen then, are brown. The first mesh says how large all are drawn.
 */
export async function drawBeside(path, meshes, { from, up = 'z', lines = false, cut }) {
  // Here, not at the top: it needs what set-up installs.
  const { launch, openPage } = await import('../js/support/browser.js');
  const server = await serve(root, {}, page);
  const browser = await launch();
  try {
    const viewport = { width: 16 + 520 * Math.min(meshes.length, columns), height: 600 };
    const address = `${server.address}/picture.html`;
    const { page: drawn, errors } = await openPage(browser, address, { viewport });
    const given = meshes.map(({ title, mesh }) => ({
      title,
      positions: base64(Float32Array.from(mesh.positions)),
      indices: base64(Uint32Array.from(mesh.indices)),
    }));
    await drawn.evaluate(draw, { meshes: given, from, up, lines, cut });
    if (errors.length > 0) throw new Error(errors.join('\n'));
    await drawn.screenshot({ path, fullPage: true });
  } finally {
    await browser.close();
    await server.close();
  }
}

const base64 = ({ buffer, byteOffset, byteLength }) =>
  Buffer.from(buffer, byteOffset, byteLength).toString('base64');

// Runs in the browser.
async function draw({ meshes, from, up, lines, cut }) {
  const three = await import('/node_modules/three/build/three.module.js');
  const side = 512;
  const numbers = (text, kind) =>
    new kind(Uint8Array.from(globalThis.atob(text), (char) => char.charCodeAt(0)).buffer);
  const geometries = meshes.map(({ positions, indices }) => {
    const geometry = new three.BufferGeometry();
    const points = new three.BufferAttribute(numbers(positions, Float32Array), 3);
    geometry.setAttribute('position', points);
    geometry.setIndex(new three.BufferAttribute(numbers(indices, Uint32Array), 1));
    return geometry;
  });
  geometries[0].computeBoundingSphere();
  const { center, radius } = geometries[0].boundingSphere;
  const direction = new three.Vector3(...from).normalize();
  const camera = new three.OrthographicCamera(-radius, radius, radius, -radius, 0, 20 * radius);
  camera.up.set(0, up === 'y' ? 1 : 0, up === 'z' ? 1 : 0);
  camera.position.copy(center).addScaledVector(direction, 10 * radius);
  camera.lookAt(center);
  const renderer = new three.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(side, side);
  renderer.setClearColor(0xffffff);
  if (cut) {
    const inwards = new three.Vector3(...cut).normalize().negate();
    renderer.clippingPlanes = [new three.Plane().setFromNormalAndCoplanarPoint(inwards, center)];
  }
  const outside = new three.MeshStandardMaterial({
    ...{ color: 0x9db8cf, flatShading: true, roughness: 0.8 },
    ...{ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 },
  });
  const inside = outside.clone();
  inside.setValues({ color: 0x7a5c48, side: three.BackSide });
  const edges = new three.LineBasicMaterial({ color: 0x22303c, transparent: true, opacity: 0.7 });
  document.body.style.cssText =
    'margin: 8px; display: flex; flex-wrap: wrap; gap: 8px; font: 15px sans-serif';
  geometries.forEach((geometry, i) => {
    const scene = new three.Scene();
    const light = new three.DirectionalLight(0xffffff, 2);
    light.position.copy(camera.position).add(new three.Vector3(-4, 6, 8).multiplyScalar(radius));
    light.target.position.copy(center);
    scene.add(new three.HemisphereLight(0xffffff, 0x8090a4, 1.2), light, light.target);
    scene.add(new three.Mesh(geometry, outside));
    if (cut) scene.add(new three.Mesh(geometry, inside));
    if (lines) scene.add(new three.LineSegments(new three.WireframeGeometry(geometry), edges));
    renderer.render(scene, camera);
    const figure = document.createElement('figure');
    figure.style.cssText = `margin: 0; width: ${side}px`;
    const image = document.createElement('img');
    image.src = renderer.domElement.toDataURL();
    const words = document.createElement('figcaption');
    words.textContent = meshes[i].title;
    figure.append(image, words);
    document.body.append(figure);
  });
  await Promise.all([...document.images].map((image) => image.decode()));
}
