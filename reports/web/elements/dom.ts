// Elements with text set as text, never as markup: names may hold anything.

type Child = Node | string | null | undefined | false;

export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  for (const child of children) {
    if (child) element.append(child);
  }
  return element;
}

const kSvg = "http://www.w3.org/2000/svg";

export function svg(
  tag: string, attributes: Record<string, string | number> = {}, ...children: (Node | string)[]
): SVGElement {
  const element = document.createElementNS(kSvg, tag);
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element as SVGElement;
}

// A name of unknown direction and length: isolated, cut by style, whole as its tooltip.
export function nameOf(text: string): HTMLElement {
  return el("bdi", { class: "name", title: text }, text);
}

export function fixed(value: number | null | undefined, decimals: number): string {
  return value === null || value === undefined || Number.isNaN(value)
    ? "\u2013" : value.toFixed(decimals).replace(/^-(?=[0.]*$)/, "");
}

export const kShareDigits = 1;  // of a share in percent: 999 of 1000 are not all

export function percent(value: number | null | undefined, digits = kShareDigits): string {
  return value === null || value === undefined ? "\u2013" : `${fixed(100 * value, digits)} %`;
}

export function saveText(name: string, type: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type }));
  el("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

export function csv(header: string[], rows: (string | number)[][]): string {
  const field = (value: string | number): string => {
    const text = typeof value === "number" && Number.isNaN(value) ? "" : String(value);
    return /[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
  };
  return [header, ...rows].map((row) => row.map(field).join(",") + "\r\n").join("");
}

export function select(
  label: string, options: { value: string; text: string }[], chosen: string,
  onChange: (value: string) => void
): HTMLLabelElement {
  const box = el("select", {}, ...options.map((o) => el("option", { value: o.value }, o.text)));
  box.value = chosen;
  box.addEventListener("change", () => onChange(box.value));
  return el("label", { class: "control" }, el("span", {}, label), box);
}

export function checkbox(
  label: string | Node, checked: boolean, onChange: (checked: boolean) => void
): HTMLLabelElement {
  const box = el("input", { type: "checkbox" });
  box.checked = checked;
  box.addEventListener("change", () => onChange(box.checked));
  return el("label", { class: "check" }, box, label);
}

export function button(label: string, title: string, onClick: () => void): HTMLButtonElement {
  const element = el("button", { type: "button", title }, label);
  element.addEventListener("click", onClick);
  return element;
}
