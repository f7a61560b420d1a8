// The picture under the hand: pointer, wheel and keys become changes of the state.

import type { Light, State } from '../state';
import { normalise, type Vec3 } from '../light/samples';
import { aboutVertical, extent } from '../gl/camera';
import { h } from './dom';

export type Grip = 'light' | 'view' | 'spot';

const LIGHT_STEP_DEG = 3;
const SPOT_STEP = 0.02;

export interface Stage {
  element: HTMLElement;
  canvas: HTMLCanvasElement;
  overlay: HTMLElement;
  grip: Grip;
  update(state: State): void;
  /** Shows the picture in a square of this side in the middle; null fills the stage. */
  square(side: number | null): void;
}

/** A direction turned to the right and upwards as the picture is seen, in degrees. */
export function nudged([x, y, z]: Vec3, right_deg: number, up_deg: number): Vec3 {
  const turned = aboutVertical(normalise([x, y, z]), right_deg);
  const angle = (up_deg * Math.PI) / 180;
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  return normalise([turned[0], turned[1] * cos + turned[2] * sin, turned[2] * cos - turned[1] * sin]);
}

/** The active light moved. */
export function withLight(state: State, change: Partial<Light>): Partial<State> {
  return { lights: state.lights.map((light, i) => (i === state.active ? { ...light, ...change } : light)) };
}

export function stage(current: () => State, change: (change: Partial<State>) => void): Stage {
  const canvas = h('canvas', {
    tabIndex: 0,
    role: 'application',
    'aria-label': 'The picture. Arrow keys move the light; with Shift they turn the view; with Control they move the spot that is asked. Plus and minus zoom.',
  });
  const overlay = h('div', { className: 'overlay' });
  const spot = h('div', { className: 'spot', 'aria-hidden': 'true' });
  const element = h('div', { className: 'picture' }, canvas, spot, overlay);
  const made: Stage = { element, canvas, overlay, grip: 'light', update, square };

  const sizes = () => {
    const { width, height } = canvas.getBoundingClientRect();
    return { width, height, extent: extent(width, height) };
  };
  const place = (event: PointerEvent) => {
    const box = canvas.getBoundingClientRect();
    const [ex, ey] = extent(box.width, box.height);
    return {
      x: ex * ((2 * (event.clientX - box.left)) / box.width - 1),
      y: ey * (1 - (2 * (event.clientY - box.top)) / box.height),
    };
  };
  const turnView = (right: number, up: number) => {
    const { view } = current();
    change({
      view: {
        ...view,
        azimuth_deg: ((view.azimuth_deg - right + 540) % 360) - 180,
        elevation_deg: Math.max(-89, Math.min(89, view.elevation_deg - up)),
      },
    });
  };
  const turnLight = (right: number, up: number) => {
    const state = current();
    change(withLight(state, { direction: nudged(state.lights[state.active].direction, right, up) }));
  };
  const moveSpot = (right: number, up: number) => {
    const { pointer } = current();
    change({ pointer: { x: pointer.x + right, y: pointer.y + up } });
  };
  const zoom = (factor: number) => {
    const { view } = current();
    change({ view: { ...view, zoom: Math.max(0.5, Math.min(20, view.zoom * factor)) } });
  };

  let last: { x: number; y: number; grip: Grip } | null = null;
  let pinch: number | null = null;
  const held = new Map<number, PointerEvent>();
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, event);
    const other = event.shiftKey || event.button === 2;
    const grip = event.ctrlKey ? 'spot' : other ? (made.grip === 'view' ? 'light' : 'view') : made.grip;
    last = { x: event.clientX, y: event.clientY, grip };
    change({ pointer: place(event) });
  });
  canvas.addEventListener('pointermove', (event) => {
    if (held.has(event.pointerId)) held.set(event.pointerId, event);
    if (held.size === 2) {
      const [a, b] = [...held.values()];
      const apart = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
      if (pinch) zoom(apart / pinch);
      pinch = apart;
      return;
    }
    if (!last) {
      if (event.pointerType === 'mouse') change({ pointer: place(event) });
      return;
    }
    const perPixel = 160 / Math.min(sizes().width, sizes().height);
    const [right, up] = [(event.clientX - last.x) * perPixel, (last.y - event.clientY) * perPixel];
    last = { ...last, x: event.clientX, y: event.clientY };
    if (last.grip === 'spot') change({ pointer: place(event) });
    else if (last.grip === 'view') turnView(right, up);
    else turnLight(right, up);
  });
  const release = (event: PointerEvent) => {
    held.delete(event.pointerId);
    last = null;
    pinch = null;
  };
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', release);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / 600));
  }, { passive: false });
  canvas.addEventListener('keydown', (event) => {
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const arrow = arrows[event.key];
    if (arrow) {
      const [right, up] = arrow;
      if (event.ctrlKey || event.metaKey || made.grip === 'spot') moveSpot(SPOT_STEP * right, SPOT_STEP * up);
      else if (event.shiftKey !== (made.grip === 'view')) turnView(-LIGHT_STEP_DEG * right, -LIGHT_STEP_DEG * up);
      else turnLight(LIGHT_STEP_DEG * right, LIGHT_STEP_DEG * up);
    } else if (event.key === '+' || event.key === '=') zoom(1.1);
    else if (event.key === '-') zoom(1 / 1.1);
    else if (event.key === 'Home') change({ view: { azimuth_deg: 0, elevation_deg: 0, zoom: 1 } });
    else return;
    event.preventDefault();
  });

  function update(state: State): void {
    const { width, height, extent: [ex, ey] } = sizes();
    const [left, top] = [canvas.offsetLeft, canvas.offsetTop];
    spot.style.transform = `translate(${left + ((state.pointer.x / ex + 1) / 2) * width}px, ${top + ((1 - state.pointer.y / ey) / 2) * height}px)`;
  }

  function square(side: number | null): void {
    const box = element.getBoundingClientRect();
    canvas.style.width = canvas.style.height = side === null ? '' : `${side}px`;
    canvas.style.margin = side === null ? '' : `${(box.height - side) / 2}px ${(box.width - side) / 2}px`;
  }
  return made;
}
