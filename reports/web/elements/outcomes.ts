// How trials end: the table of reports/outcome.h as the page was given it.
import { el } from "./dom";

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

// In the outcome's colour; see style.css.
export function inOutcomeColour(element: HTMLElement, outcome: string): HTMLElement {
  const entry = kEntries.get(outcome);
  element.classList.add("outcome");
  element.style.setProperty("--on-light", entry?.colour ?? "");
  element.style.setProperty("--on-dark", entry?.colour_on_dark ?? "");
  return element;
}

// Sign and words, what it means as its tooltip. `count`: of how many trials it is said.
export function outcomeText(outcome: string, count?: number): HTMLElement {
  const number = count === undefined ? "" : `${count} `;
  return inOutcomeColour(el("span", { title: kEntries.get(outcome)?.meaning ?? "" },
    `${outcomeSign(outcome)} ${number}${outcomeWords(outcome)}`), outcome);
}
