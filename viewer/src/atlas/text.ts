// Bytes as the text of an element of the page, as `text.rs` of the program writes them: seven bits a character.

/** What an element cannot hold as it is, told with the seven bits that follow by a character from PAIRS on. */
const REFUSED = [0, 13, 60];
const PAIRS = 0x100;

/** The bytes of a text; null where it holds fewer. */
export function decoded(text: string, length: number): Uint8Array | null {
  const out = new Uint8Array(length);
  let at = 0;
  // Bits that are there and not yet written, the newest lowest.
  let bits = 0;
  let count = 0;
  const take = (seven: number) => {
    bits = ((bits << 7) | seven) & 0x7fff;
    count += 7;
    if (count >= 8) {
      count -= 8;
      if (at < length) out[at] = bits >> count;
      at++;
    }
  };
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    if (code < PAIRS) {
      take(code);
    } else {
      take(REFUSED[(code - PAIRS) >> 7] ?? 0);
      take((code - PAIRS) & 0x7f);
    }
  }
  return at >= length ? out : null;
}
