// Unpacks what the report embeds: base64, zlib (by the browser), words that were split into their bytes.

function bytesOfBase64(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

export async function inflate(text) {
  const stream = new Blob([bytesOfBase64(text)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function inflateJson(text) {
  return JSON.parse(new TextDecoder().decode(await inflate(text)));
}

// Takes arrays off the front of a block of bytes.
export class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  take(count) {
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }

  // `count` words of 32 bits, all lowest bytes first; XORed with `base` where there is one.
  words(count, base) {
    const words = new Uint32Array(count);
    for (let shift = 0; shift < 32; shift += 8) {
      const bytes = this.take(count);
      for (let i = 0; i < count; ++i) words[i] |= bytes[i] << shift;
    }
    if (base) for (let i = 0; i < count; ++i) words[i] ^= base[i];
    return words;
  }
}
