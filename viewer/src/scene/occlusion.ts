// What stands between a point of a body and its surroundings: rays through the body's own triangles, in the shader.

import type { BufferGeometry } from 'three';
import { BVHShaderGLSL, CENTER, MeshBVH, MeshBVHUniformStruct } from 'three-mesh-bvh';
import type { Uniforms } from '../gl/upload';

/** Defines `open_towards`, for the point that `shadow_place` named. */
export const OCCLUSION = `
#ifdef SURROUNDED
precision highp isampler2D;
precision highp usampler2D;
${BVHShaderGLSL.common_functions}
${BVHShaderGLSL.bvh_struct_definitions}
${BVHShaderGLSL.bvh_ray_functions}
uniform BVH u_bvh;
float open_towards(vec3 direction) {
  // Off the triangles, which lie within the smooth surface.
  vec3 origin = shaded_place + shaded_normal * (2.6 * u_texel) + direction * u_texel;
  uvec4 face;
  vec3 face_normal, corners;
  float side, distance;
  return bvhIntersectFirstHit(u_bvh, origin, direction, face, face_normal, corners, side, distance) ? 0.0 : 1.0;
}
#endif
`;

/** The triangles of a geometry, sorted for rays; made when they are first asked for. The geometry stays as it is. */
export function occlusion(geometry: BufferGeometry): () => Uniforms {
  let uniforms: Uniforms | null = null;
  return () => {
    if (!uniforms) {
      const value = new MeshBVHUniformStruct();
      value.updateFrom(new MeshBVH(geometry, { strategy: CENTER, indirect: true }));
      uniforms = { u_bvh: { value } };
    }
    return uniforms;
  };
}
