import { describe, expect, it } from 'vitest';
import { DEFAULTS, fromFragment, merged, toFragment } from '../src/state';

describe('the state', () => {
  it('comes back from the address', () => {
    const state = merged(DEFAULTS, { specimen: 'x', shape: 'patch', lights: [{ direction: [1, 0, 1], diameter_deg: 2, irradiance: 1 }], exposure: 1.5, view: { azimuth_deg: 10, elevation_deg: -3, zoom: 2 } });
    expect(fromFragment(toFragment(state))).toEqual(state);
    expect(toFragment(DEFAULTS)).toBe('');
  });

  it('takes nothing that makes no sense', () => {
    expect(fromFragment('#%7Bnonsense')).toEqual(DEFAULTS);
    const bad = { shape: 'cube', exposure: 'bright', laser_nm: 12, lights: [], view: { zoom: NaN }, tables: 0, nothing: 1 } as never;
    expect(merged(DEFAULTS, bad)).toEqual(DEFAULTS);
    expect(merged(DEFAULTS, { lights: [{ direction: [0, 0, 0], diameter_deg: 0, irradiance: 1 }] })).toEqual(DEFAULTS);
  });

  it('changes a part of a part', () => {
    expect(merged(DEFAULTS, { view: { zoom: 3 } as never }).view).toEqual({ azimuth_deg: 0, elevation_deg: 0, zoom: 3 });
  });
});
