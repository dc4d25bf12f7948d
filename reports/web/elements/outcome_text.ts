// An outcome as the page shows it.
import { outcomeEntry, outcomeSign, outcomeWords } from "../data/outcomes";
import { el } from "./dom";

// In the outcome's colour; see style.css.
export function inOutcomeColour(element: HTMLElement, outcome: string): HTMLElement {
  const entry = outcomeEntry(outcome);
  element.classList.add("outcome");
  element.style.setProperty("--on-light", entry?.colour ?? "");
  element.style.setProperty("--on-dark", entry?.colour_on_dark ?? "");
  return element;
}

// Sign and words, what it means as its tooltip. `count`: of how many trials it is said.
export function outcomeText(outcome: string, count?: number): HTMLElement {
  const number = count === undefined ? "" : `${count} `;
  return inOutcomeColour(el("span", { title: outcomeEntry(outcome)?.meaning ?? "" },
    `${outcomeSign(outcome)} ${number}${outcomeWords(outcome)}`), outcome);
}
