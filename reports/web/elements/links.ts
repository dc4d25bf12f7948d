import { placeOf } from "./chosen";

// Where a reader is, in the fragment of the address: #PAGE, or #replay=ID,ID&t=SECONDS.

export interface ReplayPlace {
  trialIds: string[];
  t_s: number | null;  // null: from the beginning
}

export function replayLink(trialIds: string[], t_s: number | null = null): string {
  const ids = trialIds.map(encodeURIComponent).join(",");
  return `#replay=${ids}${t_s === null ? "" : `&t=${t_s.toFixed(2)}`}`;
}

export function readReplayLink(fragment: string): ReplayPlace | null {
  const match = /^#replay=([^&]+)(?:&t=([0-9.]+))?$/.exec(placeOf(fragment));
  if (!match) return null;
  try {
    return {
      trialIds: match[1].split(",").map(decodeURIComponent),
      t_s: match[2] === undefined ? null : Number(match[2]),
    };
  } catch {
    return null;  // not written by replayLink
  }
}

// The page a fragment names, or the first.
export function pageOf(fragment: string, pages: string[]): string {
  const name = /^#([a-z0-9-]+)/.exec(fragment)?.[1] ?? "";
  return pages.includes(name) ? name : pages[0];
}
