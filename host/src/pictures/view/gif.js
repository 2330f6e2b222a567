// GIF 89a: pictures with one palette. Each picture contains only the pixels that differ from the one before.

/** Index in the palette of a pixel that has not changed. */
const UNCHANGED = 255;
const MOST_CODES = 4096;

/** Growing array of bytes. */
class Bytes {
  constructor() {
    Object.assign(this, { bytes: new Uint8Array(1 << 16), length: 0 });
  }

  put(...values) {
    this.putAll(values);
  }

  putAll(values) {
    while (this.length + values.length > this.bytes.length) {
      const longer = new Uint8Array(2 * this.bytes.length);
      longer.set(this.bytes);
      this.bytes = longer;
    }
    this.bytes.set(values, this.length);
    this.length += values.length;
  }

  /** Whole numbers of two bytes, the lower byte first. */
  putShorts(...values) {
    for (const value of values) this.put(value & 255, value >> 8);
  }

  putText(text) {
    this.putAll(new TextEncoder().encode(text));
  }
}

/** Codes of 9 to 12 bits in blocks of at most 255 bytes. */
class CodeWriter {
  constructor(bytes) {
    Object.assign(this, { bytes, block: new Uint8Array(255), length: 0, bits: 0, held: 0 });
  }

  put(code, size) {
    this.held |= code << this.bits;
    this.bits += size;
    while (this.bits >= 8) this.putByte();
  }

  putByte() {
    this.block[this.length++] = this.held & 255;
    this.held >>>= 8;
    this.bits -= 8;
    if (this.length === 255) this.endBlock();
  }

  endBlock() {
    this.bytes.put(this.length);
    this.bytes.putAll(this.block.subarray(0, this.length));
    this.length = 0;
  }

  end() {
    if (this.bits > 0) this.putByte();
    if (this.length > 0) this.endBlock();
    this.bytes.put(0);
  }
}

/** Compression by Lempel, Ziv and Welch, in codes of at least 9 bits. */
class Compressor {
  constructor() {
    // for each code followed by a byte: the code of both in the lower 12 bits, and the number of its table above
    Object.assign(this, { followers: new Uint32Array(MOST_CODES * 256), tables: 0 });
  }

  write(values, bytes) {
    const { followers } = this;
    const [clear, end] = [256, 257];
    const writer = new CodeWriter(bytes);
    let [next, size, table] = [end + 1, 9, ++this.tables];
    writer.put(clear, size);
    let code = values[0];
    for (let i = 1; i < values.length; i++) {
      const place = (code << 8) | values[i];
      if (followers[place] >>> 12 === table) {
        code = followers[place] & (MOST_CODES - 1);
        continue;
      }
      writer.put(code, size);
      code = values[i];
      if (next === MOST_CODES) {
        writer.put(clear, size);
        [next, size, table] = [end + 1, 9, ++this.tables];
        continue;
      }
      followers[place] = (table << 12) | next;
      if (next === 1 << size) size++;
      next++;
    }
    writer.put(code, size);
    writer.put(end, size);
    writer.end();
  }
}

/** GIF that repeats without end: pictures of one size, each shown for some hundredths of a second. */
class Gif {
  constructor([width, height], { colours }, hundredths) {
    Object.assign(this, { size: [width, height], hundredths, bytes: new Bytes(), compressor: new Compressor(), before: null });
    const { bytes } = this;
    bytes.putText("GIF89a");
    bytes.putShorts(width, height);
    // a palette of 256 colours for all pictures
    bytes.put(0xf7, 0, 0);
    for (let i = 0; i < 256; i++) bytes.put(...(colours[i] ?? [0, 0, 0]));
    bytes.put(0x21, 0xff, 11);
    bytes.putText("NETSCAPE2.0");
    bytes.put(3, 1, 0, 0, 0);
  }

  /** Adds a picture, given as the indices of its pixels in the palette. */
  add(places) {
    const { bytes, before } = this;
    const changed = before ? places.map((place, i) => (place === before[i] ? UNCHANGED : place)) : places;
    this.before = places;
    // the picture is drawn over the one before, and one index of the palette is transparent
    bytes.put(0x21, 0xf9, 4, 0b101);
    bytes.putShorts(this.hundredths);
    bytes.put(UNCHANGED, 0);
    bytes.put(0x2c);
    bytes.putShorts(0, 0, ...this.size);
    bytes.put(0, 8);
    this.compressor.write(changed, bytes);
  }

  end() {
    this.bytes.put(0x3b);
    return this.bytes.bytes.slice(0, this.bytes.length);
  }
}
