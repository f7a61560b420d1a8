// The BRDF over all viewing directions for the light at the spot, with a marker for the viewer.

import { toAngles } from '../angles';
import type { Vec3 } from '../light/samples';
import type { Engine } from '../engine';
import type { State } from '../state';
import { h, svg } from './dom';
import type { Answer, View } from './views';

const SIDE = 192;

export interface MapView extends View {
  /** Asks for a viewing direction of the map; null when the pointer leaves. */
  onAsk: (wo: Vec3 | null) => void;
}

export function mapView(): MapView {
  const canvas = h('canvas', { width: SIDE, height: SIDE, role: 'img' });
  const viewer = svg('circle', { r: 0.035, className: 'marker' });
  const mirror = svg('path', { d: 'M-.05 0H.05M0 -.05V.05', className: 'mirror' });
  const circle = (theta: number) => svg('circle', { r: Math.sin((theta * Math.PI) / 180), className: 'ring' });
  const over = svg(
    'svg',
    { viewBox: '-1 -1 2 2', 'aria-hidden': 'true' },
    circle(30),
    circle(60),
    circle(90),
    svg('path', { d: 'M-1 0H1M0 -1V1', className: 'ring' }),
    mirror,
    viewer,
  );
  const words = h('p', { className: 'caption' });
  const element = h('div', { className: 'map', title: 'The BRDF for the light at the spot: each point is a viewing direction, the middle looks straight down, the rim along the surface. The cross is the mirror direction, the ring the viewer.' }, h('div', { className: 'square' }, canvas, over), words);
  const context = canvas.getContext('2d');
  let image: ImageData | null = null;
  let shownKey = '';
  const view: MapView = { element, update, onAsk: () => undefined };

  const direction = (event: PointerEvent): Vec3 | null => {
    const box = over.getBoundingClientRect();
    const [x, y] = [(2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height];
    const cos2 = 1 - x * x - y * y;
    return cos2 > 0 ? [x, y, Math.sqrt(cos2)] : null;
  };
  over.addEventListener('pointermove', (event) => view.onAsk(direction(event)));
  over.addEventListener('pointerdown', (event) => view.onAsk(direction(event)));
  over.addEventListener('pointerleave', () => view.onAsk(null));

  function update(state: State, engine: Engine, answer: Answer | null): void {
    viewer.style.display = mirror.style.display = answer ? '' : 'none';
    const evaluated = engine.evaluated();
    if (!answer || !evaluated || !context) {
      words.textContent = 'The spot lies beside the surface, or no light reaches it.';
      return;
    }
    const { wi, wo } = answer;
    viewer.setAttribute('cx', String(wo[0]));
    viewer.setAttribute('cy', String(-wo[1]));
    mirror.setAttribute('transform', `translate(${-wi[0]} ${wi[1]})`);
    const [light, seen] = [toAngles(wi), toAngles(wo)];
    words.textContent = `light θ ${light.theta_deg.toFixed(0)}°, φ ${light.phi_deg.toFixed(0)}° · viewer θ ${seen.theta_deg.toFixed(0)}°, φ ${seen.phi_deg.toFixed(0)}°`;
    canvas.setAttribute('aria-label', `Map of the BRDF over viewing directions; ${words.textContent}`);
    const { diameter_deg } = state.lights[state.active];
    const key = JSON.stringify([wi, diameter_deg, evaluated.filtered, engine.loaded?.specimen.name, state.interpolation, state.illuminant, state.laser_nm, state.sun_deg, state.scale, state.tables, state.pigment, engine.loaded?.spectral !== null]);
    if (key === shownKey) return;
    shownKey = key;
    const { pixels } = engine.probe.map(evaluated, wi, (diameter_deg * Math.PI) / 360, SIDE, null);
    image ??= context.createImageData(SIDE, SIDE);
    image.data.set(pixels);
    context.putImageData(image, 0, 0);
  }
  return view;
}
