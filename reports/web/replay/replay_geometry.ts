// What a moment of a trace looks like, without drawing it.
import { scaleLinear } from "d3-scale";

import { Trace } from "../data/trace";

// Cividis (Nunez, Anderton, Renslow, doi:10.1371/journal.pone.0199239), sampled: even in lightness and
// the same to colour-blind eyes. The ends are cut, so that both stand out from a light and a dark page.
const kSpeedColours = ["#31446b", "#4d556b", "#666970", "#7d7c78", "#958f78", "#aea371", "#c8b866",
  "#e4cf5b"];
export const kSpeedBins = 16;
const speedColour = scaleLinear<string>().domain(kSpeedColours.map((_, i) => i / 7))
  .range(kSpeedColours).clamp(true);

export function speedRamp(): string[] {
  return Array.from({ length: kSpeedBins }, (_, i) => speedColour(i / (kSpeedBins - 1)));
}

// The last frame that had been recorded by then.
export function frameAt(trace: Trace, t_s: number): number {
  const { t_s: times, count } = trace.frames;
  let low = 0;
  let high = count - 1;
  while (low < high) {
    const mid = (low + high + 1) >> 1;
    if (times[mid] <= t_s + 1e-9) low = mid;
    else high = mid - 1;
  }
  return low;
}

export type Point = [number, number];

// Corners of the body, turned as it is; none of a disc.
export function footprintAt(trace: Trace, k: number): Point[] {
  const { x_m, y_m, heading_x, heading_y } = trace.frames;
  const corners: Point[] = [];
  for (let i = 0; i + 1 < trace.footprint.length; i += 2) {
    const [ahead, left] = [trace.footprint[i], trace.footprint[i + 1]];
    corners.push([x_m[k] + ahead * heading_x[k] - left * heading_y[k],
      y_m[k] + ahead * heading_y[k] + left * heading_x[k]]);
  }
  return corners;
}

// Across its heading, at its widest.
export function bodyWidth_m(trace: Trace): number {
  const left = trace.footprint.filter((_, i) => i % 2 === 1);
  return left.length > 0 ? Math.max(...left) - Math.min(...left) : 2 * trace.body_radius_m;
}

function convexHull(points: Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list: Point[]): Point[] => {
    const out: Point[] = [];
    for (const p of list) {
      while (out.length >= 2) {
        const [a, b] = [out[out.length - 2], out[out.length - 1]];
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        out.pop();
      }
      out.push(p);
    }
    out.pop();
    return out;
  };
  return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.reverse())];
}

// What each label has become by a frame: merges are in order of time and always into the older one.
function mergedBy(trace: Trace, frame: number): Map<number, number> {
  const into = new Map<number, number>();
  for (let i = 0; i < trace.merges.length && trace.merges[i] <= frame; i += 3) {
    into.set(trace.merges[i + 1], trace.merges[i + 2]);
  }
  return into;
}

// Hulls of what was known in a frame, grouped as the map grouped it then.
export function hullsOf(trace: Trace, frame: number): Point[][] {
  const into = mergedBy(trace, frame);
  const groups = new Map<number, Point[]>();
  const known = Math.min(trace.frames.known[frame], trace.cluster_of.length);
  for (let i = 0; i < known; ++i) {
    let label = trace.cluster_of[i];
    for (let next = into.get(label); next !== undefined; next = into.get(label)) label = next;
    const point: Point = [trace.known_points[2 * i], trace.known_points[2 * i + 1]];
    const group = groups.get(label);
    if (group) group.push(point);
    else groups.set(label, [point]);
  }
  return [...groups.values()].map(convexHull);
}

// Edges of the latest search by a frame, x, y, x, y of each.
export function searchedEdges(trace: Trace, frame: number): Float64Array[] {
  const search = trace.frames.search[frame];
  const { ends, first, last } = trace.edges;
  const edges: Float64Array[] = [];
  first.forEach((from, i) => {
    if (from <= search && search <= last[i]) edges.push(ends.subarray(4 * i, 4 * i + 4));
  });
  return edges;
}

// Beams go counter-clockwise from the rightmost; a full circle leaves out the one that would repeat.
export function rayEnds(trace: Trace, k: number): { ends: Point[]; hit: boolean[] } {
  const f = trace.frames;
  const scan = f.range_m[k];
  const full = trace.field_of_view_rad > 2 * Math.PI - 1e-9;
  const step = trace.field_of_view_rad / Math.max(1, full ? scan.length : scan.length - 1);
  const heading = Math.atan2(f.heading_y[k], f.heading_x[k]);
  const first = scan.length > 1 ? heading - trace.field_of_view_rad / 2 : heading;
  const ends: Point[] = [];
  const hit: boolean[] = [];
  scan.forEach((range, i) => {
    const angle = first + i * step;
    ends.push([f.x_m[k] + range * Math.cos(angle), f.y_m[k] + range * Math.sin(angle)]);
    hit.push(range < trace.max_range_m);
  });
  return { ends, hit };
}
