// How trials end: the table of reports/outcome.h as the page was given it.

export interface OutcomeEntry {
  name: string;
  words: string;
  sign: string;  // drawn where a trial ended
  colour: string;
  colour_on_dark: string;
  failure: boolean;
  meaning: string;
}

const kEntries = new Map<string, OutcomeEntry>();

export function useOutcomes(table: OutcomeEntry[]): void {
  kEntries.clear();
  for (const entry of table) kEntries.set(entry.name, entry);
}

export function failed(outcome: string): boolean {
  return kEntries.get(outcome)?.failure ?? true;
}

export function outcomeSign(outcome: string): string {
  return kEntries.get(outcome)?.sign ?? "?";
}

export function outcomeWords(outcome: string): string {
  return kEntries.get(outcome)?.words ?? outcome;
}

export function outcomeEntry(outcome: string): OutcomeEntry | undefined {
  return kEntries.get(outcome);
}
