// SPDX-License-Identifier: MIT
// Views of one space: one renderer, one camera, one set of controls, so they can never part.
import {
  DirectionalLight,
  PerspectiveCamera,
  Plane,
  Sphere,
  Vector3,
  WebGLRenderer,
  type BufferGeometry,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Mesh, PolygonMeshInput } from 'kdmanifold';
import { CreaseFinder } from './crease-finder';
import type { Finding, Kind } from './findings';
import { Gizmo } from './gizmo';
import { turnByKey } from './keyboard';
import type { Heat } from './measure';
import type { Ball } from './second-model';
import { sides, type Side } from './sides';
import { View, type Common, type Lines } from './view';

/** The 3D part of the page. */
export class Stage {
  readonly #renderer: WebGLRenderer;
  readonly #camera = new PerspectiveCamera(35, 1, 0.01, 100);
  readonly #controls: OrbitControls;
  readonly #views: { input: View; output: View };
  // Further meshes, beside the result.
  #beside: View[] = [];
  readonly #light = new DirectionalLight(0xffffff, 2.2);
  readonly #common: Common = {
    cut: new Plane(new Vector3(0, 1, 0), 1),
    lines: { wireframe: false, creases: true },
    creases: new CreaseFinder(),
    draw: () => this.draw(),
  };
  readonly #host: HTMLElement;
  #sphere = new Sphere(new Vector3(), 1);
  #centre = new Vector3();
  // How far away the camera must be for the model to be seen whole.
  #distance = 1;
  #scheduled = false;

  constructor(
    host: HTMLElement,
    canvas: HTMLCanvasElement,
    input: HTMLElement,
    output: HTMLElement,
  ) {
    this.#host = host;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#renderer.localClippingEnabled = true;
    this.#renderer.setScissorTest(true);
    this.#views = { input: new View(input, this.#common), output: new View(output, this.#common) };
    this.#camera.add(this.#light);
    this.#light.position.set(0.6, 1, 0.8);
    this.#camera.up.set(0, 0, 1);
    this.#controls = new OrbitControls(this.#camera, host);
    this.#controls.addEventListener('change', () => this.draw());
    host.addEventListener('keydown', (event) => {
      if (event.target !== host) return;
      if (!turnByKey(event, this.#camera, this.#controls.target)) return;
      this.#controls.update();
      this.draw();
    });
    new ResizeObserver(() => this.#fit()).observe(host);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#restyle());
    this.lookFrom('corner');
  }

  /** Shows a mesh, or nothing; input decides where the camera looks. */
  show(which: 'input' | 'output', mesh: PolygonMeshInput | null): void {
    const geometry = this.#views[which].show(mesh);
    if (which === 'input' && geometry !== null) this.#frame(geometry);
  }

  /** Handles on the input for a second model; `onMove` as of `Gizmo`. */
  makeGizmo(onMove: (dragging: boolean) => void): Gizmo {
    const { cut } = this.#common;
    return new Gizmo(this.#views.input, this.#camera, this.#controls, cut, onMove);
  }

  /** A ball round the input, in its own coordinates. */
  get ball(): Ball {
    return { centre: this.#sphere.center, radius: this.#sphere.radius };
  }

  /** Shows a further mesh in an element of its own, which lies on the stage. */
  addView(element: HTMLElement, mesh: PolygonMeshInput): void {
    const view = new View(element, this.#common);
    view.root.rotation.copy(this.#views.input.root.rotation);
    view.show(mesh);
    this.#beside.push(view);
    this.#fit();
  }

  /** Takes the further mesh in this element away. */
  removeView(element: HTMLElement): void {
    this.#beside.find((view) => view.element === element)?.show(null);
    this.#beside = this.#beside.filter((view) => view.element !== element);
    this.#fit();
  }

  /** The meshes that are shown beside the input. */
  results(): Mesh[] {
    return this.#all().flatMap(({ mesh }) =>
      mesh && mesh !== this.#views.input.mesh ? [mesh as Mesh] : [],
    );
  }

  /** Shows distances as colours on those meshes that have some, `largest` as the last colour. */
  setHeat(heats: Map<Mesh, Heat>, largest: number): void {
    for (const view of this.#all()) {
      view.setHeat(heats.get(view.mesh as Mesh) ?? null, largest);
    }
  }

  /** Paints findings over a mesh, in addition to those that are there. */
  paint(which: 'input' | 'output', findings: Finding[]): void {
    this.#views[which].paint(findings);
    this.draw();
  }

  /** Takes one kind of finding away. */
  unpaint(which: 'input' | 'output', kind: Kind): void {
    this.#views[which].unpaint(kind);
    this.draw();
  }

  /** Shows or hides one kind of finding. */
  showPaint(kind: Kind, visible: boolean): void {
    for (const view of this.#all()) view.showPaint(kind, visible);
    this.draw();
  }

  /** Switches lines on and off. */
  setLines(lines: Lines): void {
    Object.assign(this.#common.lines, lines);
    this.#restyle();
  }

  /** Which of the model's axes points up. */
  setUp(axis: 'y' | 'z'): void {
    for (const { root } of this.#all()) {
      root.rotation.x = axis === 'y' ? Math.PI / 2 : 0;
    }
    this.#lookAgain();
  }

  /** Cuts away a share (0 to 1) of the model from the front. */
  setCut(share: number): void {
    this.#common.cut.constant = this.#sphere.radius * (1.001 - 2 * share) - this.#centre.y;
    this.draw();
  }

  /** Looks at all of the model from one side. */
  lookFrom(side: Side): void {
    const away = sides[side].clone().normalize();
    const distance = (this.#distance = this.#fittingDistance());
    this.#camera.position.copy(this.#centre).addScaledVector(away, distance);
    this.#camera.near = distance / 100;
    this.#camera.far = distance * 20;
    this.#controls.target.copy(this.#centre);
    this.#controls.update();
    this.draw();
  }

  /** Draws with the next frame. */
  draw(): void {
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => {
      this.#scheduled = false;
      this.#render();
    });
  }

  #all(): View[] {
    return [this.#views.input, this.#views.output, ...this.#beside];
  }

  #restyle(): void {
    for (const view of this.#all()) view.restyle();
  }

  #frame(geometry: BufferGeometry): void {
    geometry.computeBoundingSphere();
    const sphere = geometry.boundingSphere;
    if (sphere === null || !(sphere.radius > 0)) return;
    this.#sphere = sphere;
    this.#lookAgain();
  }

  #lookAgain(): void {
    const { root } = this.#views.input;
    this.#centre = this.#sphere.center.clone().applyEuler(root.rotation);
    this.lookFrom('corner');
  }

  // Views have become wider or narrower: the model is to fill as much of them as before.
  #fit(): void {
    const before = this.#distance;
    this.#distance = this.#fittingDistance();
    const { target } = this.#controls;
    this.#camera.position
      .sub(target)
      .multiplyScalar(this.#distance / before)
      .add(target);
    this.#controls.update();
    this.draw();
  }

  // From where all of the model is seen.
  #fittingDistance(): number {
    // The narrower of the two angles of view counts.
    const { clientWidth, clientHeight } = this.#views.input.element;
    const aspect = Math.min(1, clientWidth / Math.max(clientHeight, 1)) || 1;
    const angle = Math.atan(aspect * Math.tan((this.#camera.fov * Math.PI) / 360));
    return (this.#sphere.radius * 1.06) / Math.sin(angle);
  }

  #render(): void {
    const host = this.#host.getBoundingClientRect();
    this.#renderer.setSize(host.width, host.height, false);
    for (const { element, scene } of this.#all()) {
      const box = element.getBoundingClientRect();
      const [left, bottom] = [box.left - host.left, host.bottom - box.bottom];
      this.#renderer.setViewport(left, bottom, box.width, box.height);
      this.#renderer.setScissor(left, bottom, box.width, box.height);
      this.#camera.aspect = box.width / Math.max(box.height, 1);
      this.#camera.updateProjectionMatrix();
      // The light travels with the camera, which belongs to no scene for longer than one frame.
      scene.add(this.#camera);
      this.#renderer.render(scene, this.#camera);
    }
  }
}
