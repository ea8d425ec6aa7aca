// SPDX-License-Identifier: Apache-2.0
// A picture of a page with at most 256 colours, which is half as large: PNG as Chromium writes it in, PNG with a palette out.
import { crc32, deflateSync, inflateSync } from 'node:zlib';

const most = 256;
const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);

function chunks(png) {
  const found = [];
  for (let at = signature.length; at < png.length; at += 12 + found.at(-1).content.length) {
    const length = png.readUInt32BE(at);
    found.push({ type: png.toString('latin1', at + 4, at + 8), content: png.subarray(at + 8, at + 8 + length) });
  }
  return found;
}

function chunk(type, content) {
  const named = Buffer.concat([Buffer.from(type, 'latin1'), content]);
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(content.length);
  sum.writeUInt32BE(crc32(named));
  return Buffer.concat([length, named, sum]);
}

/** The filter that the standard calls Paeth. */
function nearest(left, above, corner) {
  const [a, b, c] = [Math.abs(above - corner), Math.abs(left - corner), Math.abs(left + above - 2 * corner)];
  return a <= b && a <= c ? left : b <= c ? above : corner;
}

/** Red, green and blue of all pixels. */
function pixelsIn(png) {
  const parts = chunks(png);
  const header = parts.find(({ type }) => type === 'IHDR').content;
  const [width, height, depth, kind] = [header.readUInt32BE(0), header.readUInt32BE(4), header[8], header[9]];
  if (depth !== 8 || (kind !== 2 && kind !== 6) || header[12] !== 0) throw new Error(`found a PNG of kind ${kind} with ${depth} bits, wanted 8 bits of each colour`);
  const each = kind === 2 ? 3 : 4;
  const data = inflateSync(Buffer.concat(parts.filter(({ type }) => type === 'IDAT').map(({ content }) => content)));
  const wide = each * width;
  const pixels = Buffer.alloc(3 * width * height);
  let before = Buffer.alloc(wide);
  for (let y = 0; y < height; y++) {
    const filter = data[y * (wide + 1)];
    const line = data.subarray(y * (wide + 1) + 1, (y + 1) * (wide + 1));
    for (let i = 0; i < wide; i++) {
      const [left, above, corner] = [i < each ? 0 : line[i - each], before[i], i < each ? 0 : before[i - each]];
      line[i] += [0, left, above, (left + above) >> 1, nearest(left, above, corner)][filter];
    }
    for (let x = 0; x < width; x++) line.copy(pixels, 3 * (y * width + x), each * x, each * x + 3);
    before = line;
  }
  return { width, height, pixels };
}

const parts = (colour) => [colour >> 16, (colour >> 8) & 255, colour & 255];

function widest(colours) {
  const spans = [0, 1, 2].map((part) => {
    let [low, high] = [255, 0];
    for (const { rgb } of colours) [low, high] = [Math.min(low, rgb[part]), Math.max(high, rgb[part])];
    return high - low;
  });
  const part = spans.indexOf(Math.max(...spans));
  return { part, span: spans[part] };
}

const boxOf = (colours) => ({ colours, ...widest(colours), weight: colours.reduce((sum, { count }) => sum + Math.sqrt(count), 0) });

/** Boxes of colours that are alike: that which is worst is cut in two, again and again. */
function boxesOf(colours) {
  const boxes = [boxOf(colours)];
  while (boxes.length < most) {
    const worst = boxes.reduce((best, box) => (box.span ** 2 * box.weight > best.span ** 2 * best.weight ? box : best));
    if (worst.span === 0) break;
    const middle = (Math.min(...worst.colours.map(({ rgb }) => rgb[worst.part])) + Math.max(...worst.colours.map(({ rgb }) => rgb[worst.part]))) / 2;
    const halves = [worst.colours.filter(({ rgb }) => rgb[worst.part] <= middle), worst.colours.filter(({ rgb }) => rgb[worst.part] > middle)];
    boxes.splice(boxes.indexOf(worst), 1, ...halves.map(boxOf));
  }
  return boxes.map(({ colours: alike }) => alike);
}

/** A colour that fills areas stays what it is; others become their mean. */
function colourOf(alike) {
  const all = alike.reduce((sum, { count }) => sum + count, 0);
  const first = alike.reduce((best, one) => (one.count > best.count ? one : best));
  if (2 * first.count > all) return first.rgb;
  return [0, 1, 2].map((part) => Math.round(alike.reduce((sum, { rgb, count }) => sum + rgb[part] * count, 0) / all));
}

export function paletted(png) {
  const { width, height, pixels } = pixelsIn(png);
  const counts = new Map();
  for (let i = 0; i < pixels.length; i += 3) {
    const colour = pixels.readUIntBE(i, 3);
    counts.set(colour, (counts.get(colour) ?? 0) + 1);
  }
  const boxes = boxesOf([...counts].map(([colour, count]) => ({ rgb: parts(colour), count, colour })));
  const places = new Map(boxes.flatMap((alike, place) => alike.map(({ colour }) => [colour, place])));
  const lines = Buffer.alloc((width + 1) * height); // each begins with 0: no filter
  for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) lines[y * (width + 1) + 1 + x] = places.get(pixels.readUIntBE(3 * (y * width + x), 3));
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 3, 0, 0, 0], 8);
  return Buffer.concat([signature, chunk('IHDR', header), chunk('PLTE', Buffer.from(boxes.flatMap(colourOf))), chunk('IDAT', deflateSync(lines, { level: 9 })), chunk('IEND', Buffer.alloc(0))]);
}
