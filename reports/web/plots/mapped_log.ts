// One recorded lidar log as the map sees it, on a canvas: tens of thousands of points.
import type { MappedLog } from "../data/mapped_log";
import { el } from "../elements/dom";

const kWidthPx = 1120;
const kBorderPx = 16;
const kLowestPx = 300;
const kHighestPx = 1600;
const kColours = 8;

export function drawLog(log: MappedLog): HTMLElement {
  const { x, y } = log.points;
  const low = { x: x.reduce((a, b) => Math.min(a, b), Infinity), y: y.reduce((a, b) => Math.min(a, b), Infinity) };
  const high = { x: x.reduce((a, b) => Math.max(a, b), -Infinity), y: y.reduce((a, b) => Math.max(a, b), -Infinity) };
  const perM = Math.min((kWidthPx - 2 * kBorderPx) / (high.x - low.x || 1),
    (kHighestPx - 2 * kBorderPx) / (high.y - low.y || 1));
  const heightPx = Math.max(kLowestPx, Math.ceil((high.y - low.y) * perM) + 2 * kBorderPx);
  const canvas = el("canvas", { width: String(kWidthPx), height: String(heightPx), role: "img",
    "aria-label": `${log.name}: ${log.clusters} clusters` });
  const draw = (): void => {
    const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
    const colour = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name);
    const px = (v: number): number => kBorderPx + (v - low.x) * perM;
    const py = (v: number): number => heightPx - kBorderPx - (v - low.y) * perM;
    pen.clearRect(0, 0, kWidthPx, heightPx);
    pen.fillStyle = colour("--obstacle");
    log.returns.x.forEach((v, i) => pen.fillRect(px(v), py(log.returns.y[i]), 1, 1));
    const colours = Array.from({ length: kColours }, (_, i) => colour(`--c${i}`));
    x.forEach((v, i) => {
      pen.fillStyle = colours[log.points.cluster[i] % kColours];
      pen.fillRect(px(v) - 1, py(y[i]) - 1, 2.5, 2.5);
    });
    pen.strokeStyle = colour("--ray");
    pen.lineWidth = 1.5;
    pen.beginPath();
    log.track.x.forEach((v, i) => pen.lineTo(px(v), py(log.track.y[i])));
    pen.stroke();
    const barM = 10 ** Math.floor(Math.log10(200 / perM));
    pen.fillStyle = colour("--ink");
    pen.fillRect(kBorderPx, heightPx - 6, barM * perM, 2);
    pen.font = "18px sans-serif";
    pen.fillText(`${barM} m`, kBorderPx + barM * perM + 6, heightPx - 2);
  };
  window.addEventListener("themechange", draw);
  draw();
  return el("figure", { id: `log-${log.name}`, class: "mapped-log" },
    el("figcaption", {}, el("h3", {}, log.name)), canvas,
    el("p", { class: "note" }, `${log.points.x.length} points in ${log.clusters} clusters from ${log.scans} scans.`));
}
