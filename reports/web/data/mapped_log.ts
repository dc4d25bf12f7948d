// What the map made of one recorded lidar log.
interface Places {
  x: number[];
  y: number[];
}

export interface MappedLog {
  name: string;
  scans: number;
  return_count: number;
  invalid: number;  // ranges that were no measurement
  clusters: number;
  points: Places & { cluster: number[] };
  returns: Places;  // a share of all
  track: Places;
}
