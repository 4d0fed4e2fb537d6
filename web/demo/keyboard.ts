// SPDX-License-Identifier: MIT
// Turning and zooming without a pointer.
import type { Camera, Vector3 } from 'three';

const turns: Record<string, [number, number]> = {
  ArrowLeft: [0.1, 0],
  ArrowRight: [-0.1, 0],
  ArrowUp: [0, -0.1],
  ArrowDown: [0, 0.1],
};
const zooms: Record<string, number> = { '+': 0.9, '=': 0.9, '-': 1.1 };

/** Moves the camera round the target if the key means that; did it? */
export function turnByKey(event: KeyboardEvent, camera: Camera, target: Vector3): boolean {
  const offset = camera.position.clone().sub(target);
  const [around, over] = turns[event.key] ?? [0, 0];
  const scale = zooms[event.key] ?? 1;
  if (around === 0 && over === 0 && scale === 1) return false;
  event.preventDefault();
  const flat = Math.hypot(offset.x, offset.y);
  const tilt = Math.min(1.5, Math.max(-1.5, Math.atan2(offset.z, flat) - over));
  const heading = Math.atan2(offset.y, offset.x) + around;
  const length = offset.length() * scale;
  offset.set(
    length * Math.cos(tilt) * Math.cos(heading),
    length * Math.cos(tilt) * Math.sin(heading),
    length * Math.sin(tilt),
  );
  camera.position.copy(target).add(offset);
  return true;
}
