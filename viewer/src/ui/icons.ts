// Small drawings of lines.

import { svg } from './dom';

const icon = (...paths: string[]) => (): SVGElement =>
  svg('svg', { viewBox: '0 0 24 24', className: 'glyph', 'aria-hidden': 'true' }, ...paths.map((d) => svg('path', { d })));

const round = (r: number, x = 12, y = 12) => `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;

export const icons = {
  mark: icon('M4 20V4M8 20V7M12 20V10M16 20V13M20 20V16'),
  ball: icon(round(8), 'M5 9c4 2.5 10 2.5 14 0M5 15c4-2.5 10-2.5 14 0'),
  snake: icon('M4 18c6 3 15 1 14-4S7 12 7 8s6-5 11-2l2-1'),
  flat: icon('M6 6h12l3 12H3z', 'M10 6L8.500 18M14 6l1.500 12'),
  screen: icon('M4 4h16v12H4z', round(1.5, 12, 10), 'M12 16v5'),
  map: icon(round(8), round(4), 'M12 4v16M4 12h16'),
  own: icon('M12 3l8 4.500v9L12 21l-8-4.500v-9z', 'M12 12l8-4.500M12 12L4 7.500M12 12v9'),
  light: icon(round(4), 'M12 2v3M12 19v3M2 12h3M19 12h3M5 5l2 2M17 17l2 2M19 5l-2 2M7 17l-2 2'),
  orbit: icon(round(3), 'M3 12c0-3 4-5 9-5s9 2 9 5-4 5-9 5', 'M14 14l-2 3 3 2'),
  spot: icon(round(6), 'M12 2v6M12 16v6M2 12h6M16 12h6'),
  pause: icon('M9 5v14M15 5v14'),
  sweep: icon(round(3, 18, 6), 'M4 19C5 11 8 8 14 6.500', 'M4 19l-1-3M4 19l3-1'),
  turn: icon('M4 12a8 8 0 1 0 3-6.200', 'M3 4l4 1.500L5.500 9.500'),
  link: icon('M10 14a4 4 0 0 0 6 0l3-3a4 4 0 0 0-6-6l-1 1', 'M14 10a4 4 0 0 0-6 0l-3 3a4 4 0 0 0 6 6l1-1'),
  picture: icon('M4 5h16v14H4z', round(1.5, 9, 10), 'M4 17l5-4 3 2 4-4 4 4'),
  film: icon('M4 5h16v14H4z', 'M10 9l5 3-5 3z'),
  theme: icon(round(8), 'M12 4a8 8 0 0 1 0 16z'),
};
