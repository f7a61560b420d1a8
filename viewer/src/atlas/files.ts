// Where an atlas's files come from: the page itself, or the folder beside it.

import { decoded } from './text';

/** A file that is not there or cannot be read, in words for the reader of the page. */
export class AtlasError extends Error {}

export interface AtlasFiles {
  /** Tells what the files must be: from now on those that differ are refused, where the browser can tell. */
  expect(digests: { path: string; sha256?: string }[]): void;
  /** The bytes of a file of the atlas, by its path within the version's folder. */
  bytes(path: string): Promise<Uint8Array>;
  /** The half floats of a table, where they are there in place of its file: see halves.ts. */
  halves(path: string): Promise<Uint8Array | null>;
  /** The same as JSON. */
  json<T>(path: string): Promise<T>;
  /** Whether a small file is there: asked of files that an atlas may lack. */
  optionalJson<T>(path: string): Promise<T | null>;
  /** An address for an <img>. */
  url(path: string): Promise<string>;
}

const IMAGE_TYPES: Record<string, string> = { png: 'image/png', svg: 'image/svg+xml' };

/** Asks for a file by its path within the version's folder; null where there is none. */
export type Get = (path: string) => Promise<Uint8Array | null>;

/** The files in the page's own elements of the class `atlas-file`, or else those under `atlas/`. */
export function atlasFiles(page: Document): AtlasFiles {
  const elements = Array.from(page.querySelectorAll<HTMLElement>('script.atlas-file'), (element) => [element.dataset.path ?? '', element] as const);
  const inside = elements.length > 0 ? new Map(elements) : null;
  const get = inside ? insidePage(inside) : under('atlas/');
  return filesFrom(get, async (path, bytes) => {
    const type = IMAGE_TYPES[path.split('.').pop() ?? ''] ?? 'application/octet-stream';
    return inside ? URL.createObjectURL(new Blob([(await bytes(path)) as Uint8Array<ArrayBuffer>], { type })) : `atlas/${path}`;
  }, inside ? (path) => get(`${path}.halves`) : undefined);
}

/** Files by what asks for them, held against their digests once these are known. */
export function filesFrom(get: Get, url: (path: string, bytes: AtlasFiles['bytes']) => Promise<string>, halves: Get = async () => null): AtlasFiles {
  const digests = new Map<string, string>();
  const bytes = async (path: string): Promise<Uint8Array> => {
    const found = await get(path);
    if (!found) throw new AtlasError(`The atlas's file ${path} is missing. Copy the atlas again, or make it anew.`);
    const wanted = digests.get(path);
    const digest = wanted ? await sha256(found) : null;
    if (digest && digest !== wanted) {
      throw new AtlasError(`The atlas's file ${path} is damaged: it is not what atlas.json says. Copy the atlas again, or make it anew.`);
    }
    return found;
  };
  const parse = <T>(path: string, data: Uint8Array): T => {
    try {
      return JSON.parse(new TextDecoder().decode(data)) as T;
    } catch {
      throw new AtlasError(`The atlas's file ${path} is damaged: it is no JSON. Copy the atlas again, or make it anew.`);
    }
  };
  return {
    bytes,
    halves,
    expect: (files) => files.forEach(({ path, sha256: digest }) => digest && digests.set(path, digest)),
    json: async <T>(path: string) => parse<T>(path, await bytes(path)),
    optionalJson: async <T>(path: string) => {
      const found = await get(path);
      return found ? parse<T>(path, found) : null;
    },
    url: (path) => url(path, bytes),
  };
}

/** The digest in hexadecimal; null where the browser computes none, as on pages that came over plain http. */
async function sha256(bytes: Uint8Array): Promise<string | null> {
  if (!globalThis.crypto?.subtle) return null;
  const digest = await crypto.subtle.digest('SHA-256', bytes as Uint8Array<ArrayBuffer>);
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

function insidePage(elements: Map<string, HTMLElement>): Get {
  return async (path) => {
    const element = elements.get(path);
    if (!element) return null;
    const found = decoded(element.textContent ?? '', Number(element.dataset.bytes));
    if (!found) throw new AtlasError(`The atlas's file ${path} is cut short in this page. Export the page again.`);
    return found;
  };
}

/** Those under an address, which ends with a slash. */
export const under =
  (base: string): Get =>
  async (path) => {
    let answer: Response;
    try {
      answer = await fetch(`${base}${path.split('/').map(encodeURIComponent).join('/')}`);
    } catch {
      throw new AtlasError(`The atlas's file ${path} cannot be reached. Is what serves this page still running?`);
    }
    if (answer.status === 404) return null;
    if (!answer.ok) throw new AtlasError(`The atlas's file ${path} cannot be read (status ${answer.status}).`);
    return new Uint8Array(await answer.arrayBuffer());
  };
