// A copy of a drawing that stands alone: what the style sheet says is written into its elements, the
// title and the legend, which the page sets as text beside it, are drawn into it.
import { svg } from "./dom";

const kProperties = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray",
  "stroke-linecap", "stroke-linejoin", "font-size", "font-weight", "text-anchor", "paint-order"];
const kTitle_px = 26;
const kLegendLine_px = 20;
const kSwatch_px = 40;
const kCharacter_px = 6.6;  // of 12 px sans-serif, generous
const kGap_px = 18;

// `copy` is a clone of `original`; tooltips become titles, which every viewer of SVG shows.
function writeStyle(original: Element, copy: Element): void {
  const originals = [original, ...original.querySelectorAll("*")];
  const copies = [copy, ...copy.querySelectorAll("*")];
  originals.forEach((element, i) => {
    const style = getComputedStyle(element);
    for (const property of kProperties) {
      const value = style.getPropertyValue(property);
      if (value) copies[i].setAttribute(property, value);
    }
    copies[i].removeAttribute("class");
    const tip = copies[i].getAttribute("data-tip");
    if (tip) copies[i].prepend(svg("title", {}, tip));
    for (const name of copies[i].getAttributeNames()) {
      if (name.startsWith("data-")) copies[i].removeAttribute(name);
    }
  });
}

// The entries of a legend as the page shows them, broken into lines of `width`. Returns its height.
function drawLegend(root: SVGElement, legend: HTMLElement, width: number, ink: string): number {
  let x = 0;
  let y = 0;
  for (const entry of legend.children) {
    const words = [...entry.children].filter((part) => part.tagName.toLowerCase() !== "svg")
      .map((part) => part.textContent ?? "").join("  ");
    const swatch = entry.querySelector("svg");
    const length = (swatch ? kSwatch_px : 0) + kCharacter_px * words.length + kGap_px;
    if (x > 0 && x + length > width) {
      x = 0;
      y += kLegendLine_px;
    }
    const group = svg("g", { transform: `translate(${x.toFixed(1)},${y})` });
    if (swatch) {
      const mark = swatch.cloneNode(true) as SVGElement;
      writeStyle(swatch, mark);
      mark.setAttribute("y", "2");
      group.append(mark);
    }
    group.append(svg("text", { x: swatch ? kSwatch_px : 0, y: 12, fill: ink, "font-size": "12px" }, words));
    root.append(group);
    x += length;
  }
  return legend.children.length > 0 ? y + kLegendLine_px + 4 : 0;
}

export function standaloneSvg(
  picture: SVGElement, title: string, legend: HTMLElement | null = null
): string {
  const view = (picture as SVGSVGElement).viewBox.baseVal;
  const ink = getComputedStyle(document.body).color;
  const head = svg("g", { transform: `translate(${view.x + 8},${kTitle_px})` });
  const headHeight = kTitle_px +
    (legend ? drawLegend(head, legend, view.width - 16, ink) : 0);
  const body = picture.cloneNode(true) as SVGElement;
  writeStyle(picture, body);
  for (const [name, value] of [["x", view.x], ["y", view.y + headHeight], ["width", view.width],
    ["height", view.height]] as const) {
    body.setAttribute(name, String(value));
  }
  const height = view.height + headHeight;
  const root = svg("svg", { xmlns: "http://www.w3.org/2000/svg", "font-family": "sans-serif",
    viewBox: `${view.x} ${view.y} ${view.width} ${height}`, width: view.width, height },
    svg("title", {}, title),
    svg("rect", { x: view.x, y: view.y, width: view.width, height,
      fill: getComputedStyle(document.body).backgroundColor }),
    svg("g", { transform: `translate(0,${view.y})` },
      svg("text", { x: view.x + 8, y: 18, fill: ink, "font-size": "15px", "font-weight": "600" }, title),
      head),
    body);
  return new XMLSerializer().serializeToString(root);
}
