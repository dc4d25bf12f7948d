// What a replay draws, each layer with a sample of its ink and a switch.
import { checkbox, el, svg } from "../elements/dom";

export interface Layers {
  truth: boolean;
  rays: boolean;
  known: boolean;
  hulls: boolean;
  search: boolean;
  plan: boolean;
  tube: boolean;
  trail: boolean;
}

interface Layer {
  key: keyof Layers;
  label: string;
  sample: () => SVGElement[];
  flown?: boolean;  // only of what flew
}

const stroke = (d: string, colour: string, more: Record<string, string | number> = {}): SVGElement =>
  svg("path", { d, fill: "none", stroke: `var(--${colour})`, "stroke-width": 1.4, ...more });

const kLayers: Layer[] = [
  { key: "truth", label: "true world", sample: () => [svg("circle", { cx: 15, cy: 7, r: 5.5,
    fill: "var(--obstacle)", stroke: "var(--obstacle-edge)" })] },
  { key: "rays", flown: true, label: "rays and field of view", sample: () => [svg("path", { d: "M3 7L27 1V13Z",
    fill: "var(--ray)", "fill-opacity": 0.25 }), stroke("M3 7L27 1M3 7H27M3 7L27 13", "ray")] },
  { key: "known", flown: true, label: "known points", sample: () => [3, 9, 15, 21, 27].map((x, i) =>
    svg("rect", { x: x - 1.2, y: 5.8 - (i % 2) * 2, width: 2.4, height: 2.4, fill: "var(--ink)" })) },
  { key: "hulls", flown: true, label: "clusters", sample: () =>
    [stroke("M3 11L8 2L24 3L27 11Z", "hull", { "stroke-dasharray": "4 3" })] },
  { key: "search", label: "Voronoi edges, roadmap or trees", sample: () =>
    [stroke("M2 12L10 7L18 9L28 2M10 7L6 1M18 9L24 13", "search", { "stroke-width": 1 })] },
  { key: "plan", label: "plan and subgoal", sample: () => [stroke("M1 7H19", "ink", { "stroke-dasharray": "6 3" }),
    stroke("M21 3L28 11M21 11L28 3", "subgoal", { "stroke-width": 2 })] },
  { key: "tube", flown: true, label: "stopping tube of the governor", sample: () =>
    [stroke("M6 7H24", "tube", { "stroke-width": 11, "stroke-opacity": 0.28, "stroke-linecap": "round" }),
      stroke("M6 7H24", "tube")] },
  { key: "trail", flown: true, label: "way, coloured by speed", sample: () => [] },
];

export function everyLayer(): Layers {
  return { truth: true, rays: true, known: true, hulls: true, search: true, plan: true, tube: true, trail: true };
}

export function layerSwitches(layers: Layers, plannedOnly: boolean, changed: () => void): HTMLElement[] {
  return kLayers.filter((layer) => !layer.flown || !plannedOnly).map(({ key, label, sample }) => {
    const box = checkbox(el("span", {}, svg("svg", { class: "layer-sample", width: 30, height: 14,
      viewBox: "0 0 30 14", "aria-hidden": "true" }, ...sample()), ` ${label}`), layers[key], (on) => {
      layers[key] = on;
      changed();
    });
    box.dataset.layer = key;
    return box;
  });
}
