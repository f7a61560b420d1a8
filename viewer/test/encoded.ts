// Bytes as text, as the program's `text.rs` describes it: for tests of what reads them.

/** Seven bits a character, and three of the characters with the seven bits that follow. */
export function encoded(bytes: Uint8Array): string {
  const bits = Array.from(bytes, (byte) => byte.toString(2).padStart(8, '0')).join('');
  const sevens = (bits.match(/.{1,7}/g) ?? []).map((seven) => parseInt(seven.padEnd(7, '0'), 2));
  let text = '';
  for (let i = 0; i < sevens.length; i++) {
    const place = [0, 13, 60].indexOf(sevens[i]);
    text += String.fromCharCode(place < 0 ? sevens[i] : 0x100 + 128 * place + (sevens[++i] ?? 0));
  }
  return text;
}
