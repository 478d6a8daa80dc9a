// Lines through points on the floor: which one a place is nearest to, and where in its order.

/** Middles of the items of a kind, in their order: `course.gates.1`, `course.gates.2` and so on. */
export function ordered(points, kind) {
  const middles = [];
  for (let number = 1; ; number += 1) {
    const mine = points.filter(({ item }) => item === `${kind}.${number}`);
    if (!mine.length) return middles;
    middles.push(["x", "y"].map((axis) => mine.reduce((sum, one) => sum + one[axis], 0) / mine.length));
  }
}

/**
 * Finds the line that is nearest to a place: its name, how far away it is, and the number from 1 that a point there
 * gets. Before the first and after the last point of an open line it is the first or the last.
 */
export function nearest(lines, [x, y]) {
  let found = null;
  for (const { name, places, closed } of lines) {
    const count = places.length;
    for (let i = 0; i < (closed || count === 1 ? count : count - 1); i += 1) {
      const [[ax, ay], [bx, by]] = [places[i], places[(i + 1) % count]];
      const [dx, dy] = [bx - ax, by - ay];
      const along = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1);
      const t = Math.max(0, Math.min(1, along));
      const away = Math.hypot(x - ax - t * dx, y - ay - t * dy);
      if (found && away >= found.away) continue;
      const [first, last] = [!closed && count > 1 && i === 0 && along < 0, !closed && i === count - 2 && along > 1];
      found = { name, away, at: i + (first ? 1 : last ? 3 : 2) };
    }
  }
  return found;
}

const [COLUMNS, ROWS] = [16, 12]; // of the places among which one with room is chosen

/** The place in the middle of a frame that is furthest from every point, whole centimetres. */
export function roomiest(points, { left, top, width, height }) {
  let found = null;
  for (let i = 0; i < COLUMNS * ROWS; i += 1) {
    const [across, down] = [(i % COLUMNS) + 0.5, Math.floor(i / COLUMNS) + 0.5];
    const at = [left + width * (0.1 + (0.8 * across) / COLUMNS), top - height * (0.1 + (0.8 * down) / ROWS)];
    const room = Math.min(...points.map(({ x, y }) => Math.hypot(x - at[0], y - at[1])));
    if (!found || room > found.room) found = { room, at };
  }
  return found.at.map((value) => 10 * Math.round(value / 10));
}
