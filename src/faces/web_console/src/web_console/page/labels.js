// Places labels so that none overlaps another: the important first, each beside its mark, or not at all.

const HEIGHT_PX = 17;
const GAP_PX = 3;
const MOST = 80;
// Things get labels once a metre is so large.
const NEAR_PX = 48;
let pen = null;

function widthOf(text, kind) {
  pen = pen || document.createElement("canvas").getContext("2d");
  pen.font = kind === "room" ? "600 13px system-ui, sans-serif" : "12px system-ui, sans-serif";
  return Math.ceil(pen.measureText(text).width * 1.08) + 8;
}

// `taken` are boxes that stay free: the robot, and the buttons of the map.
export function labelBoxes(wanted, { width, height, zoom_px: zoom, taken = [] }) {
  const boxes = [];
  const isFree = (box) => box.left >= 0 && box.top >= 0 && box.left + box.width <= width && box.top + box.height <= height
    && [...taken, ...boxes].every((other) => box.left >= other.left + other.width + GAP_PX || other.left >= box.left + box.width + GAP_PX
      || box.top >= other.top + other.height + GAP_PX || other.top >= box.top + box.height + GAP_PX);
  const shown = wanted.filter((one) => one.rank <= 4 || zoom >= NEAR_PX).sort((one, other) => one.rank - other.rank);
  for (const one of shown) {
    if (boxes.length >= MOST) break;
    const size = { width: widthOf(one.text, one.kind), height: HEIGHT_PX };
    // A label that is longer than its furniture would be read for its neighbour.
    if (one.kind === "furniture" && one.wide_px * 2 < size.width && zoom < 2 * NEAR_PX) continue;
    const middle = one.x - size.width / 2;
    const places = one.isMiddle || one.kind === "furniture"
      ? [[middle, one.y - HEIGHT_PX / 2], [middle, one.y + HEIGHT_PX], [middle, one.y - 2 * HEIGHT_PX], [middle, one.y + 2.5 * HEIGHT_PX]]
      : [[middle, one.y + 10], [middle, one.y - HEIGHT_PX - 10], [one.x + 11, one.y - HEIGHT_PX / 2], [one.x - 11 - size.width, one.y - HEIGHT_PX / 2]];
    const found = places.map(([left, top]) => ({ ...size, left: Math.round(left), top: Math.round(top), text: one.text, kind: one.kind })).find(isFree);
    if (found) boxes.push(found);
  }
  return boxes;
}
