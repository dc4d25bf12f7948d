// Where the numbers come from: the manifest as it was written, and how to repeat them.
import { Report } from "../data/data";
import { el } from "../elements/dom";
import { repeatCommand, shellWord } from "../elements/repeat_command";

type Entry = [path: string, value: string];

// A list of plain values reads as one line; "command" as it was typed.
function flatten(value: unknown, path: string, out: Entry[]): void {
  if (Array.isArray(value) && value.every((v) => v === null || typeof v !== "object")) {
    out.push([path, path.endsWith("command") ? value.map(shellWord).join(" ") : value.join(", ")]);
  } else if (value !== null && typeof value === "object") {
    for (const [key, inner] of Object.entries(value)) {
      flatten(inner, path ? `${path}.${key}` : key, out);
    }
  } else {
    out.push([path, String(value)]);
  }
}

export function manifestEntries(manifest: unknown): Entry[] {
  const entries: Entry[] = [];
  if (typeof manifest === "string") return [["manifest", manifest]];
  flatten(manifest, "", entries);
  return entries;
}

const kLongText = 200;
const kFolded = "configuration";  // hundreds of values that most readers do not ask for

export function provenanceSection(report: Report): HTMLElement {
  const entries = manifestEntries(report.manifest);
  if (entries.length === 0) return el("p", { class: "soft" }, "No manifest was given.");
  const folded = (report.manifest as Record<string, unknown>)[kFolded];
  const plain = entries.filter(([path]) => !path.startsWith(`${kFolded}.`));
  const short = plain.filter(([, value]) => value.length <= kLongText && !value.includes("\n"));
  const long = plain.filter(([, value]) => value.length > kLongText || value.includes("\n"));
  const rows = short.map(([path, value]) => el("tr", {},
    el("th", { scope: "row", class: "text" }, path), el("td", { class: "text wrap" }, el("bdi", {}, value))));
  const first = report.trials[0];
  return el("div", {},
    first && el("p", {}, el("code", {}, repeatCommand(report, first)),
      " flies a trial again and says whether it is the same to the last bit; Replay and Failures show the " +
      "command of each."),
    el("div", { class: "scroll" }, el("table", {}, el("tbody", {}, ...rows))),
    ...long.map(([path, value]) =>
      el("details", {}, el("summary", {}, path), el("pre", {}, el("bdi", {}, value)))),
    folded !== undefined && el("details", {}, el("summary", {}, "full configuration, defaults included"),
      el("pre", {}, el("bdi", {}, JSON.stringify(folded, null, 2)))));
}
