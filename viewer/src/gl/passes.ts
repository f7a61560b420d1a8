// Passes over a whole target: adding up samples, and bringing the sum to the display.

import { BufferAttribute, BufferGeometry, Camera, GLSL3, Mesh, RawShaderMaterial, Scene, type WebGLRenderTarget, type WebGLRenderer } from 'three';
import type { Uniforms } from './upload';
import { FILL_VERTEX } from './shade';
import { DISPLAY, SRGB, type Primaries } from './display';

/** One triangle over the whole target. */
export function wholeTarget(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  return geometry;
}

export function material(vertex: string, fragment: string, uniforms: Uniforms, depth = false): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: `precision highp float;\n${vertex}`,
    fragmentShader: fragment,
    uniforms,
    depthTest: depth,
    depthWrite: depth,
  });
}

/** Something that can be drawn into a target. */
export class Pass {
  readonly scene = new Scene();
  private readonly camera = new Camera();

  constructor(
    readonly material: RawShaderMaterial,
    geometry: BufferGeometry = wholeTarget(),
  ) {
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
    this.scene.matrixWorldAutoUpdate = false;
  }

  draw(renderer: WebGLRenderer, target: WebGLRenderTarget | null): void {
    renderer.setRenderTarget(target);
    renderer.render(this.scene, this.camera);
  }
}

const HEAD = 'precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n';

/** The mean of what was there and one sample more. */
export const meanPass = (): Pass =>
  new Pass(
    material(
      FILL_VERTEX,
      `${HEAD}
uniform sampler2D u_before;
uniform sampler2D u_sample;
uniform float u_share;
layout(location = 0) out highp vec4 out_value;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  out_value = mix(texelFetch(u_before, at, 0), texelFetch(u_sample, at, 0), u_share);
}`,
      { u_before: { value: null }, u_sample: { value: null }, u_share: { value: 1 } },
    ),
  );

/** XYZ to the display's colours. */
export const displayPass = (): Pass =>
  new Pass(
    material(FILL_VERTEX, `${HEAD}${DISPLAY}`, {
      u_xyz: { value: null },
      u_other: { value: null },
      u_exposure: { value: 1 },
      u_mode: { value: 0 },
      u_backdrop: { value: 0 },
      ...primaryUniforms(SRGB),
    }),
  );

/** A display's primaries as uniforms. */
export const primaryUniforms = (primaries: Primaries): Uniforms =>
  Object.fromEntries(Object.entries(primaries).map(([name, value]) => [`u_${name}`, { value }]));
