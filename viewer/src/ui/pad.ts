// A disc on which lights are dragged: the hemisphere in front of the picture, seen from the camera.

import type { Vec3 } from '../light/samples';
import { normalise } from '../light/samples';
import type { State } from '../state';
import type { Change, Control } from './controls';
import { svg, h } from './dom';
import { nudged, withLight } from './stage';

/** Place on the disc, equal areas being equal solid angles; the rim is at 90 degrees. */
function toDisc(direction: Vec3): [number, number] {
  const [x, y, z] = normalise(direction);
  const side = Math.hypot(x, y);
  const radius = Math.SQRT2 * Math.sin(0.5 * Math.atan2(side, z));
  return side > 1e-9 ? [(radius * x) / side, (radius * y) / side] : [0, 0];
}

function fromDisc(x: number, y: number): Vec3 {
  const radius = Math.min(1, Math.hypot(x, y));
  const theta = 2 * Math.asin(radius / Math.SQRT2);
  const azimuth = Math.atan2(y, x);
  return [Math.sin(theta) * Math.cos(azimuth), Math.sin(theta) * Math.sin(azimuth), Math.cos(theta)];
}

export function lightPad(current: () => State, change: Change): Control {
  const marks = svg('g');
  const rings = [30, 60].map((theta) => svg('circle', { r: Math.SQRT2 * Math.sin((theta * Math.PI) / 360), className: 'ring' }));
  const disc = svg(
    'svg',
    { viewBox: '-1.08 -1.08 2.16 2.16', 'aria-hidden': 'true' },
    svg('circle', { r: 1, className: 'rim' }),
    ...rings,
    svg('path', { d: 'M-1 0H1M0 -1V1', className: 'ring' }),
    marks,
  );
  const element = h(
    'div',
    {
      className: 'pad', tabIndex: 0, role: 'application', title: 'Where the lights stand, seen from the camera. Drag, or use the arrow keys.',
      'aria-label': 'Light. Arrow keys move it.',
    },
    disc,
  );
  const place = (event: PointerEvent): [number, number] => {
    const box = disc.getBoundingClientRect();
    const side = box.width / 2.16;
    return [(event.clientX - box.left - box.width / 2) / side, (box.top + box.height / 2 - event.clientY) / side];
  };
  const drag = (event: PointerEvent) => change(withLight(current(), { direction: fromDisc(...place(event)) }));
  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    const [x, y] = place(event);
    const apart = current().lights.map(({ direction }) => {
      const [a, b] = toDisc(direction);
      return Math.hypot(a - x, b - y);
    });
    const nearest = apart.indexOf(Math.min(...apart));
    if (apart[nearest] < 0.15) change({ active: nearest });
    drag(event);
  });
  element.addEventListener('pointermove', (event) => element.hasPointerCapture(event.pointerId) && drag(event));
  element.addEventListener('keydown', (event) => {
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-3, 0], ArrowRight: [3, 0], ArrowUp: [0, 3], ArrowDown: [0, -3] };
    const arrow = arrows[event.key];
    if (!arrow) return;
    const state = current();
    change(withLight(state, { direction: nudged(state.lights[state.active].direction, ...arrow) }));
    event.preventDefault();
  });
  return {
    element,
    update: (state) => {
      // The screen's beam comes along the line of sight.
      element.hidden = state.shape === 'screen';
      marks.replaceChildren(
        ...state.lights.map((light, i) => {
          const [x, y] = toDisc(light.direction);
          return svg('circle', { cx: x, cy: -y, r: i === state.active ? 0.085 : 0.06, className: i === state.active ? 'lamp active' : 'lamp' });
        }),
      );
    },
  };
}
