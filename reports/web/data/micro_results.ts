// What Google Benchmark wrote: its entries by name, as voronaut-micro gives them.

export interface Micro {
  context: Record<string, unknown>;
  benchmarks: Record<string, unknown>[];
}

export interface Cost {
  map: string;   // whose cost it is
  at: number;    // rays per scan, or scans known before
  us: number;    // CPU time per scan; of repetitions the median
  runs: number;
}

const kUs: Record<string, number> = { ns: 1e-3, us: 1, ms: 1e3, s: 1e6 };

function median(values: number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

// Entries "<family>/<map>/<argument>:<at>" of single runs, no aggregates and no failures.
export function costsOf(micro: Micro, family: string): Cost[] {
  const found = new Map<string, Cost & { all: number[] }>();
  for (const entry of micro.benchmarks) {
    const name = String(entry.run_name ?? entry.name);
    if (!name.startsWith(`${family}/`) || entry.run_type === "aggregate" || entry.error_occurred) continue;
    const [map, argument] = name.slice(family.length + 1).split("/");
    const at = Number(argument?.split(":").pop() ?? 0);
    const cost = found.get(name) ?? { map, at, us: 0, runs: 0, all: [] };
    cost.all.push(Number(entry.cpu_time) * (kUs[String(entry.time_unit)] ?? NaN));
    cost.us = median(cost.all);
    cost.runs = cost.all.length;
    found.set(name, cost);
  }
  return [...found.values()];
}

// Slope of log(cost) over log(scans known), least squares: 0 is flat, 1 grows like the map.
export function exponentOf(costs: Cost[]): number {
  const points = costs.filter((c) => c.at > 0 && c.us > 0).map((c) => [Math.log(c.at), Math.log(c.us)]);
  const mean = (k: number): number => points.reduce((sum, p) => sum + p[k], 0) / points.length;
  const [x, y] = [mean(0), mean(1)];
  const over = points.reduce((sum, p) => sum + (p[0] - x) * (p[1] - y), 0);
  const under = points.reduce((sum, p) => sum + (p[0] - x) ** 2, 0);
  return points.length < 2 ? NaN : over / under;
}

// What each rival of the map also answers, and what it does not: a ratio without this is half a truth.
export const kAnswers: Record<string, [string, string]> = {
  "naive_full_search": ["the same questions", "its cost grows with everything known"],
  "grid_0.1m_hits": ["whether a cell was hit", "clusters, extremes, exact points; needs bounds"],
  "grid_0.1m_full": ["free space", "clusters, extremes, exact points; needs bounds"],
  "nanoflann_single_scan": ["clusters of one scan", "keeps no map"],
  "pcl_single_scan": ["clusters of one scan, in 3-D too", "keeps no map"],
  "octomap_0.1m_hits": ["3-D, probabilities", "clusters, extremes"],
  "octomap_0.1m_full": ["3-D, probabilities, free space", "clusters, extremes"],
};
