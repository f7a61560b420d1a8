import { createHash } from 'node:crypto';
import { describe, expect, it } from 'vitest';
import { atlasFiles } from '../src/atlas/files';
import { encoded } from './encoded';

const text = '{"name":"x"}';
const page = (files: Record<string, string>) => {
  const element = ([path, content]: [string, string]) => {
    const bytes = new TextEncoder().encode(content);
    return { textContent: encoded(bytes), dataset: { path, bytes: String(bytes.length) } };
  };
  return { querySelectorAll: () => Object.entries(files).map(element) } as unknown as Document;
};
const sha256 = createHash('sha256').update(text).digest('hex');

describe('files inside the page', () => {
  const files = atlasFiles(page({ 'a/specimen.json': text, 'b.json': 'no json' }));

  it('come as bytes and as JSON', async () => {
    expect(new TextDecoder().decode(await files.bytes('a/specimen.json'))).toBe(text);
    expect(await files.json('a/specimen.json')).toEqual({ name: 'x' });
    expect(await files.optionalJson('none.json')).toBeNull();
  });

  it('that are missing, damaged or no JSON say which', async () => {
    await expect(files.bytes('c.exr')).rejects.toThrow('c.exr is missing');
    await expect(files.json('b.json')).rejects.toThrow('b.json is damaged');
    files.expect([{ path: 'a/specimen.json', sha256 }]);
    expect(await files.json('a/specimen.json')).toEqual({ name: 'x' });
    files.expect([{ path: 'a/specimen.json', sha256: sha256.replace(/^./, (c) => (c === '0' ? '1' : '0')) }]);
    await expect(files.bytes('a/specimen.json')).rejects.toThrow('not what atlas.json says');
  });
});
