// One moment of a trace in words, beside its picture. "governor": the share of the speed asked for that
// it allowed, and the way to rest; "search": how many edges the latest one looked at, and which it is.
import { fixed } from "../elements/dom";
import { wordsOf } from "./mode_strip";
import { hullsOf, searchedEdges } from "./replay_geometry";
import { Trace } from "../data/trace";

function governorAt(trace: Trace, k: number): string {
  const tube = trace.frames.tube[k];
  let length_m = 0;
  for (let i = 2; i < tube.length; i += 2) {
    length_m += Math.hypot(tube[i] - tube[i - 2], tube[i + 1] - tube[i - 1]);
  }
  const allowed = `${fixed(100 * trace.frames.share[k], 0)} %`;
  return tube.length > 0 ? `${allowed}, stop in ${fixed(length_m, 2)} m` : allowed;
}

function searchAt(trace: Trace, k: number): string {
  const search = trace.frames.search[k];
  if (search >= 0) return `${searchedEdges(trace, k).length} edges, ${search + 1} of ${trace.searches}`;
  return trace.kept_searches < trace.searches
    ? `kept to ${trace.kept_searches} of ${trace.searches}` : "\u2013";
}

export function isGoverned(trace: Trace): boolean {
  return trace.frames.tube.some((tube) => tube.length > 0);
}

export function factsAt(trace: Trace, k: number): [name: string, value: string][] {
  const f = trace.frames;
  const facts: [string, string][] = trace.static ? [
    ["clearance", `${fixed(f.clearance_m[k], 2)} m`],
    ["position", `${fixed(f.x_m[k], 2)}, ${fixed(f.y_m[k], 2)} m`],
  ] : [
    ["mode", wordsOf(trace.modes[f.mode[k]] ?? "\u2013")],
    ["speed", `${fixed(f.speed_m_s[k], 2)} m/s`],
    ["clearance", `${fixed(f.clearance_m[k], 2)} m`],
    ["position", `${fixed(f.x_m[k], 2)}, ${fixed(f.y_m[k], 2)} m`],
    ["points known", String(f.known[k])],
    ["clusters", String(hullsOf(trace, k).length)],
    ["planning", `${fixed(f.planning_time_us[k], 0)} \u00B5s`],
  ];
  if (trace.searches > 0 && !trace.static) {
    facts.push(["search", searchAt(trace, k)], ["planned again", wordsOf(trace.replan_reasons[f.replan[k]] ?? "no")],
      ["solve ended by", wordsOf(trace.solve_ends[f.solve_end[k]] ?? "\u2013")]);
  }
  if (isGoverned(trace) && !trace.static) facts.push(["governor", governorAt(trace, k)]);
  return facts;
}
