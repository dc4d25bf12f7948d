// The command that flies a trial again and says whether it is the same to the last bit.
import type { Report, Trial } from "../data/data";
import { button, el } from "./dom";

export function shellWord(word: unknown): string {
  const text = String(word);
  return /^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`;
}

const kShortId = 12;  // characters that tell a trial; the program takes a beginning

export function repeatCommand(report: Report, trial: Trial): string {
  return `voronaut replay ${shellWord(report.folder)} ${shellWord(trial.trial_id.slice(0, kShortId))}`;
}

export function commandOf(report: Report, trial: Trial): HTMLElement {
  const text = repeatCommand(report, trial);
  return el("span", { class: "command" }, el("code", { title: trial.trial_id }, text),
    button("Copy", "Copy the command", () => void navigator.clipboard?.writeText(text)));
}
