// How the structure lies on a geometry.

import { BufferAttribute, type BufferGeometry } from 'three';
import { tangents } from '../../src/scene/tangents';

/**
 * Lays the structure on a geometry with texture coordinates, as the program's pictures do: x along u, y on the side to which v grows. Sets the
 * attribute `tangent`. Where a geometry lacks it, the material takes each triangle's own direction, which shows on coarse meshes.
 * `vDown` is for files whose v grows down the image, as in glTF.
 */
export function layStructure(geometry: BufferGeometry, { vDown = false } = {}): BufferGeometry {
  for (const name of ['position', 'normal', 'uv']) {
    if (!geometry.getAttribute(name)) throw new Error(`a structure needs a geometry with ${name === 'uv' ? 'texture coordinates' : `the attribute ${name}`}`);
  }
  if (!geometry.index) geometry.setIndex(Array.from({ length: geometry.getAttribute('position').count }, (_, i) => i));
  geometry.setAttribute('tangent', new BufferAttribute(tangents(geometry, vDown), 4));
  return geometry;
}
