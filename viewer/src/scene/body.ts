// A shape made of triangles: the snake, or one dropped on the page.

import type { BufferGeometry, WebGLRenderer } from 'three';
import type { Uniforms } from '../gl/upload';
import type { View } from './frames';

export interface Body {
  geometry: BufferGeometry;
  view: View;
  vertex: string;
  /** Follows evaluation and shading: defines `lit` and `main`. */
  fragment: string;
  uniforms: Uniforms;
  /** What light of the surroundings meets on its way. */
  occlusion(): Uniforms;
  /** Has what lights see drawn anew. */
  forgetShadows(): void;
  /** Draws what each light sees; `lights` are the picture's own uniforms. */
  drawShadows(renderer: WebGLRenderer, lights: Uniforms): void;
}
