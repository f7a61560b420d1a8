// EXR images as an atlas holds them: one part, scan lines, ZIP or no compression, channels of half or 32-bit floats.

export interface ExrImage {
  width: number;
  height: number;
  /** Names of the channels, in the file's order (alphabetical: B, G, R). */
  channels: string[];
  /** Whether every channel holds half floats. */
  half: boolean;
  /** Of each channel the numbers row by row, top row first: bits of half floats, or 32-bit floats. */
  planes: (Uint16Array | Float32Array)[];
  /** What each channel's numbers are to be multiplied by, beside what the atlas says; 1 where absent. */
  scales?: number[];
}

/** What is wrong with a file that cannot be read. */
export class ExrError extends Error {}

interface Channel {
  name: string;
  bytes: 2 | 4;
}

const MAGIC = 20000630;
const SIDE_MAX = 16384;

/** Reads an image. Throws an ExrError that says what is wrong with the file. */
export async function readExr(bytes: Uint8Array): Promise<ExrImage> {
  try {
    return await decode(bytes);
  } catch (error) {
    if (error instanceof ExrError) throw error;
    throw new ExrError(error instanceof RangeError ? 'it ends too early' : `it is damaged (${String(error)})`);
  }
}

async function decode(bytes: Uint8Array): Promise<ExrImage> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== MAGIC) throw new ExrError('it is no EXR image');
  if (view.getUint32(4, true) & 0x1a00) throw new ExrError('it has tiles, deep samples or several parts, which are not read');
  const header = readHeader(bytes, view, 8);
  const { channels, compression, width, height } = header;
  const linesOf: Record<number, number> = { 0: 1, 2: 1, 3: 16 };
  const lines = linesOf[compression];
  if (!lines) throw new ExrError(`its compression (${compression}) is not read: ZIP is`);
  const pixel = channels.reduce((sum, channel) => sum + channel.bytes, 0);
  const planes = channels.map((channel) =>
    channel.bytes === 2 ? new Uint16Array(width * height) : new Float32Array(width * height),
  );
  const chunks = Math.ceil(height / lines);
  const read = Array.from({ length: chunks }, async (_, chunk) => {
    const at = Number(view.getBigUint64(header.end + 8 * chunk, true));
    const row = view.getInt32(at, true) - header.top;
    const size = view.getUint32(at + 4, true);
    if (row < 0 || row >= height || row % lines) throw new ExrError('its rows are out of place');
    const rows = Math.min(lines, height - row);
    const due = rows * width * pixel;
    const data = bytes.subarray(at + 8, at + 8 + size);
    if (data.length < size) throw new ExrError('it ends too early');
    const raw = compression === 0 || size === due ? data : unpredict(await inflate(data, due));
    if (raw.length !== due) throw new ExrError('it is damaged: rows of a wrong length');
    deal(raw, channels, planes, { row, rows, width });
    return rows;
  });
  const filled = (await Promise.all(read)).reduce((sum, rows) => sum + rows, 0);
  if (filled !== height) throw new ExrError('rows are missing');
  return { width, height, channels: channels.map((c) => c.name), half: channels.every((c) => c.bytes === 2), planes };
}

function readHeader(bytes: Uint8Array, view: DataView, start: number) {
  let at = start;
  const text = () => {
    const end = bytes.indexOf(0, at);
    if (end < 0) throw new ExrError('it ends too early');
    const value = new TextDecoder().decode(bytes.subarray(at, end));
    at = end + 1;
    return value;
  };
  let channels: Channel[] = [];
  let compression = -1;
  let window: number[] = [];
  for (let name = text(); name !== ''; name = text()) {
    text();
    const size = view.getUint32(at, true);
    const value = at + 4;
    at = value;
    if (name === 'channels') channels = readChannels(view, text, () => at, (next) => (at = next));
    else if (name === 'compression') compression = view.getUint8(value);
    else if (name === 'dataWindow') window = [0, 4, 8, 12].map((offset) => view.getInt32(value + offset, true));
    at = value + size;
    if (at > bytes.length) throw new ExrError('it ends too early');
  }
  if (!channels.length || window.length !== 4) throw new ExrError('its header lacks what every image has');
  const [left, top, right, bottom] = window;
  const [width, height] = [right - left + 1, bottom - top + 1];
  if (!(width > 0 && height > 0 && width <= SIDE_MAX && height <= SIDE_MAX)) {
    throw new ExrError(`its size, ${width} x ${height}, is not that of a table`);
  }
  return { channels, compression, width, height, top, end: at };
}

function readChannels(view: DataView, text: () => string, where: () => number, go: (at: number) => void): Channel[] {
  const channels: Channel[] = [];
  for (let name = text(); name !== ''; name = text()) {
    const type = view.getUint32(where(), true);
    if (type !== 1 && type !== 2) throw new ExrError(`its channel ${name} holds whole numbers`);
    const sampling = [view.getUint32(where() + 8, true), view.getUint32(where() + 12, true)];
    if (sampling[0] !== 1 || sampling[1] !== 1) throw new ExrError(`its channel ${name} is subsampled`);
    channels.push({ name, bytes: type === 1 ? 2 : 4 });
    go(where() + 16);
  }
  return channels;
}

export async function inflate(data: Uint8Array, due: number): Promise<Uint8Array> {
  const stream = new Blob([data as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new DecompressionStream('deflate'));
  const out = new Uint8Array(due);
  let filled = 0;
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    if (filled + value.length > due) throw new ExrError('it is damaged: more data than pixels');
    out.set(value, filled);
    filled += value.length;
  }
  if (filled !== due) throw new ExrError('it is damaged: less data than pixels');
  return out;
}

/** Undoes what EXR does before deflating: differences of bytes, and odd bytes behind even ones. */
function unpredict(data: Uint8Array): Uint8Array {
  for (let i = 1; i < data.length; i++) data[i] = data[i - 1] + data[i] - 128;
  const out = new Uint8Array(data.length);
  const half = (data.length + 1) >> 1;
  for (let i = 0; i < data.length; i++) out[i] = data[i % 2 ? half + (i >> 1) : i >> 1];
  return out;
}

function deal(
  raw: Uint8Array,
  channels: Channel[],
  planes: (Uint16Array | Float32Array)[],
  { row, rows, width }: { row: number; rows: number; width: number },
): void {
  const view = new DataView(raw.buffer, raw.byteOffset, raw.byteLength);
  let at = 0;
  for (let line = row; line < row + rows; line++) {
    channels.forEach(({ bytes }, index) => {
      const plane = planes[index];
      const start = line * width;
      if (bytes === 2) for (let x = 0; x < width; x++, at += 2) plane[start + x] = view.getUint16(at, true);
      else for (let x = 0; x < width; x++, at += 4) plane[start + x] = view.getFloat32(at, true);
    });
  }
}
