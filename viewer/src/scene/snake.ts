import type { Body } from './body';
export function snakeBody(): Body { throw new Error('not there yet'); }
