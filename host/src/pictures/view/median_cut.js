// Palette of a picture with many colours, by Heckbert's median cut.

/** Number of bits of a channel by which colours are distinguished. */
const CHANNEL_BITS = 6;
const COLOURS = 1 << (3 * CHANNEL_BITS);

/** Colour of the pixel at this offset of RGBA bytes, as one integer. */
const colourAt = (pixels, i) =>
  ((pixels[i] >> 2) << (2 * CHANNEL_BITS)) | ((pixels[i + 1] >> 2) << CHANNEL_BITS) | (pixels[i + 2] >> 2);

/** Channels of such an integer, each from 0 to 63. */
const channelsOf = (colour) => [colour >> (2 * CHANNEL_BITS), (colour >> CHANNEL_BITS) & 63, colour & 63];

/** Box around colours: its longest side, that side's channel, and the number of its pixels. */
function boxOf(colours, counts) {
  const [low, high] = [[63, 63, 63], [0, 0, 0]];
  let pixels = 0;
  for (const colour of colours) {
    pixels += counts[colour];
    channelsOf(colour).forEach((x, k) => {
      low[k] = Math.min(low[k], x);
      high[k] = Math.max(high[k], x);
    });
  }
  const sides = high.map((x, k) => x - low[k]);
  const side = Math.max(...sides);
  return { colours, pixels, side, channel: sides.indexOf(side) };
}

/** Two boxes with about half of the pixels each. */
function halved({ colours, pixels, channel }, counts) {
  const shift = CHANNEL_BITS * (2 - channel);
  const sorted = [...colours].sort((a, b) => ((a >> shift) & 63) - ((b >> shift) & 63));
  let [below, cut] = [0, 0];
  while (cut < sorted.length - 1 && (cut === 0 || below + counts[sorted[cut]] <= pixels / 2)) below += counts[sorted[cut++]];
  return [sorted.slice(0, cut), sorted.slice(cut)].map((half) => boxOf(half, counts));
}

/** Mean colour of a box, each channel from 0 to 255. */
function meanOf({ colours, pixels }, counts) {
  const sums = [0, 0, 0];
  for (const colour of colours) channelsOf(colour).forEach((x, k) => (sums[k] += counts[colour] * x));
  return sums.map((x) => Math.round((x / pixels) * (255 / 63)));
}

/** Palette of at most `most` colours for pictures in RGBA bytes, with the index of each colour that was looked up. */
class Palette {
  constructor(pictures, most) {
    const counts = new Uint32Array(COLOURS);
    for (const pixels of pictures) {
      for (let i = 0; i < pixels.length; i += 4) counts[colourAt(pixels, i)]++;
    }
    const present = [];
    counts.forEach((count, colour) => count && present.push(colour));
    const boxes = [boxOf(present, counts)];
    while (boxes.length < most) {
      // the error of a large box of few pixels is as visible as that of a small box of many
      const error = ({ side, pixels }) => side * Math.sqrt(pixels);
      const worst = boxes.reduce((most, box) => (error(box) > error(most) ? box : most));
      if (worst.side === 0) break;
      boxes.splice(boxes.indexOf(worst), 1, ...halved(worst, counts));
    }
    this.colours = boxes.map((box) => meanOf(box, counts));
    this.places = new Int16Array(COLOURS).fill(-1);
  }

  /** Indices of the pixels of a picture in the palette. */
  placesOf(pixels) {
    const { places } = this;
    const found = new Uint8Array(pixels.length / 4);
    for (let i = 0; i < pixels.length; i += 4) {
      const colour = colourAt(pixels, i);
      if (places[colour] < 0) places[colour] = this.nearest(colour);
      found[i / 4] = places[colour];
    }
    return found;
  }

  nearest(colour) {
    const [r, g, b] = channelsOf(colour).map((x) => (x * 255) / 63);
    let [place, least] = [0, Infinity];
    this.colours.forEach(([x, y, z], i) => {
      const distance = (x - r) ** 2 + (y - g) ** 2 + (z - b) ** 2;
      if (distance < least) [place, least] = [i, distance];
    });
    return place;
  }
}
