// What each light sees of a body: depths in a map for every light, from afar.

import { DepthTexture, FloatType, Matrix4, NearestFilter, Vector3, Vector4, WebGLRenderTarget, type BufferGeometry, type WebGLRenderer } from 'three';
import { material, Pass } from '../gl/passes';
import { LIGHTS_MAX } from '../gl/shade';
import type { Uniforms } from '../gl/upload';
import type { Vec3 } from '../light/samples';

const SIDE = 2048;

/** Defines `lit`; `shadow_place` says where the point is. Four texels beside each other soften the maps' steps. */
export const SHADOWS = `
in vec3 v_place;
uniform highp sampler2D u_shadow0;
uniform highp sampler2D u_shadow1;
uniform highp sampler2D u_shadow2;
uniform highp sampler2D u_shadow3;
uniform mat4 u_to_light[${LIGHTS_MAX}];
uniform float u_texel;
vec3 shaded_place;
vec3 shaded_normal;

void shadow_place(vec3 place, vec3 normal) {
  shaded_place = place;
  shaded_normal = normal;
}

float open_at(highp sampler2D depths, vec3 at) {
  vec2 place = at.xy * float(textureSize(depths, 0).x) - 0.5;
  vec2 first = floor(place);
  vec2 share = place - first;
  float sum = 0.0;
  for (int dy = 0; dy < 2; dy++) {
    for (int dx = 0; dx < 2; dx++) {
      float depth = texelFetch(depths, ivec2(first) + ivec2(dx, dy), 0).r;
      float weight = (dx == 1 ? share.x : 1.0 - share.x) * (dy == 1 ? share.y : 1.0 - share.y);
      sum += weight * (at.z <= depth ? 1.0 : 0.0);
    }
  }
  return sum;
}

float lit(int light) {
  vec3 direction = u_light[light].xyz;
  float cosine = dot(shaded_normal, direction);
  // Off the surface by a texel of the map, more where the light grazes it.
  float side = sqrt(max(0.0, 1.0 - cosine * cosine));
  vec3 lifted = shaded_place + shaded_normal * (u_texel * (0.6 + 2.0 * side)) + direction * u_texel;
  vec4 clip = u_to_light[light] * vec4(lifted, 1.0);
  vec3 at = 0.5 * clip.xyz + 0.5;
  if (light == 0) return open_at(u_shadow0, at);
  if (light == 1) return open_at(u_shadow1, at);
  if (light == 2) return open_at(u_shadow2, at);
  return open_at(u_shadow3, at);
}
`;

export class ShadowMaps {
  readonly uniforms: Uniforms;
  private readonly targets: WebGLRenderTarget[] = [];
  private readonly drawn: string[] = [];
  private readonly pass: Pass;
  private readonly clip: { value: Matrix4 } = { value: new Matrix4() };

  constructor(
    geometry: BufferGeometry,
    private readonly bounds: { centre: Vec3; radius: number },
  ) {
    const vertex = 'in vec3 position;\nuniform mat4 u_to_light;\nvoid main() { gl_Position = u_to_light * vec4(position, 1.0); }';
    this.pass = new Pass(material(vertex, 'precision highp float;\nlayout(location = 0) out vec4 out_value;\nvoid main() { out_value = vec4(1.0); }', { u_to_light: this.clip }, true), geometry);
    this.uniforms = {
      u_to_light: { value: Array.from({ length: LIGHTS_MAX }, () => new Matrix4()) },
      u_texel: { value: (2 * bounds.radius) / SIDE },
    };
    for (let i = 0; i < LIGHTS_MAX; i++) this.uniforms[`u_shadow${i}`] = { value: null };
  }

  /** Has every map made and drawn anew. */
  forget(): void {
    this.drawn.length = 0;
    for (const target of this.targets) target?.dispose();
    this.targets.length = 0;
    for (let i = 0; i < LIGHTS_MAX; i++) this.uniforms[`u_shadow${i}`].value = null;
  }

  /** Draws the maps of lights that moved. */
  draw(renderer: WebGLRenderer, lights: Uniforms): void {
    const directions: Vector4[] = lights.u_light.value;
    for (let i = 0; i < lights.u_lights.value; i++) {
      const { x, y, z } = directions[i];
      const key = `${x} ${y} ${z}`;
      if (this.drawn[i] === key) continue;
      this.drawn[i] = key;
      const clip = this.lightClip(new Vector3(x, y, z));
      this.uniforms.u_to_light.value[i] = clip;
      this.clip.value = clip;
      this.pass.draw(renderer, this.target(i));
    }
    for (let i = 0; i < LIGHTS_MAX; i++) this.uniforms[`u_shadow${i}`].value ??= this.targets[0].depthTexture;
  }

  private target(i: number): WebGLRenderTarget {
    if (!this.targets[i]) {
      const depth = new DepthTexture(SIDE, SIDE, FloatType);
      depth.minFilter = depth.magFilter = NearestFilter;
      this.targets[i] = new WebGLRenderTarget(SIDE, SIDE, { depthTexture: depth });
      this.uniforms[`u_shadow${i}`].value = depth;
    }
    return this.targets[i];
  }

  private lightClip(direction: Vector3): Matrix4 {
    const { centre, radius } = this.bounds;
    const target = new Vector3(...centre);
    const place = target.clone().addScaledVector(direction, 2 * radius);
    const up = Math.abs(direction.y) < 0.9 ? new Vector3(0, 1, 0) : new Vector3(1, 0, 0);
    const pose = new Matrix4().lookAt(place, target, up).setPosition(place);
    return new Matrix4().makeOrthographic(-radius, radius, radius, -radius, radius, 3 * radius).multiply(pose.invert());
  }
}
