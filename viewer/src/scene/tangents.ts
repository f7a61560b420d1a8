// How the structure lies on triangles: its x axis along the texture coordinate u, y at a right angle to it, on the side to which v grows.

import { Vector3, type BufferAttribute, type BufferGeometry } from 'three';

/** Directions along +u at the vertices, and 1 or -1 where v grows to the left or the right of it. */
export function tangents(geometry: BufferGeometry, vDown: boolean): Float32Array {
  const [position, normal, uv] = ['position', 'normal', 'uv'].map((key) => geometry.getAttribute(key));
  const index = geometry.index;
  if (!index) throw new Error('a geometry with indices is needed');
  const out = new Float32Array(4 * position.count);
  const at = (vertex: number) => new Vector3().fromBufferAttribute(position as BufferAttribute, vertex);
  for (let i = 0; i < index.count; i += 3) {
    const corners = [index.getX(i), index.getX(i + 1), index.getX(i + 2)];
    const [a, b, c] = corners.map(at);
    const [ab, ac] = [b.sub(a), c.sub(a)];
    const coordinate = (k: number) => [uv.getX(corners[k]), (vDown ? -1 : 1) * uv.getY(corners[k])];
    const [p, q, r] = [0, 1, 2].map(coordinate);
    const [pq, pr] = [[q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]]];
    const area = pq[0] * pr[1] - pq[1] * pr[0];
    if (area === 0) continue;
    const along = ab.clone().multiplyScalar(pr[1]).addScaledVector(ac, -pq[1]).multiplyScalar(Math.sign(area)).normalize();
    const across = ac.clone().multiplyScalar(pq[0]).addScaledVector(ab, -pr[0]).multiplyScalar(Math.sign(area));
    const facet = ab.clone().cross(ac);
    for (const vertex of corners) {
      const n = new Vector3().fromBufferAttribute(normal as BufferAttribute, vertex);
      if (facet.dot(n) < 0) facet.negate();
      const t = along.clone().addScaledVector(n, -along.dot(n)).normalize();
      for (const [k, component] of [t.x, t.y, t.z].entries()) out[4 * vertex + k] += component;
      out[4 * vertex + 3] = along.clone().cross(across).dot(facet) < 0 ? -1 : 1;
    }
  }
  return out;
}
