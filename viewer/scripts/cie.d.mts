export function cieFromRust(): Promise<unknown>;
