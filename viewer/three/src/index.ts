// An atlas as a material of three.js: open it, lay the structure on a geometry, light it with three's own lights.

export { AtlasError } from '../../src/atlas/files';
export type { Interpolation } from '../../src/gl/library';
export type { IlluminantName } from '../../src/light/illuminants';
export { openAtlas, type OpenAtlas } from './open';
export { DiffractionMaterial, type DiffractionOptions } from './material';
export { layStructure } from './structure';
