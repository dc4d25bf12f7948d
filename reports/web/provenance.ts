// Where the numbers come from: the manifest as it was written, and how to repeat them.
import { Report } from "./data";
import { el } from "./dom";

type Entry = [path: string, value: string];

function flatten(value: unknown, path: string, out: Entry[]): void {
  if (value !== null && typeof value === "object") {
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

export function provenanceSection(report: Report): HTMLElement {
  const entries = manifestEntries(report.manifest);
  if (entries.length === 0) return el("p", { class: "soft" }, "No manifest was given.");
  const short = entries.filter(([, value]) => value.length <= kLongText && !value.includes("\n"));
  const long = entries.filter(([, value]) => value.length > kLongText || value.includes("\n"));
  const rows = short.map(([path, value]) => el("tr", {},
    el("th", { scope: "row", class: "text" }, path), el("td", { class: "text wrap" }, el("bdi", {}, value))));
  return el("div", {},
    el("div", { class: "scroll" }, el("table", {}, el("tbody", {}, ...rows))),
    ...long.map(([path, value]) =>
      el("details", {}, el("summary", {}, path), el("pre", {}, el("bdi", {}, value)))));
}
