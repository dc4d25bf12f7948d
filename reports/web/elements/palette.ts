import { symbol, symbolCircle, symbolCross, symbolDiamond, symbolSquare, symbolStar,
  symbolTriangle, symbolWye } from "d3-shape";

import { svg } from "./dom";

// A planner is told by colour (Okabe and Ito's set, distinct for colour-blind readers; the values are
// in style.css, light and dark), by dash and by symbol: never by colour alone.
const kColours = 8;
const kDashes = ["", "7 3", "2 3", "9 3 2 3", "12 4", "4 2", "1 2", "6 2 2 2 2 2"];
const kSymbols = [symbolCircle, symbolTriangle, symbolSquare, symbolDiamond, symbolCross, symbolStar,
  symbolWye];

export class Palette {
  private readonly place: Map<string, number>;

  constructor(readonly planners: string[]) {
    this.place = new Map(planners.map((name, i) => [name, i]));
  }

  private index(planner: string): number {
    return this.place.get(planner) ?? 0;
  }

  // Class that sets --planner; see style.css.
  className(planner: string): string {
    return `p${this.index(planner) % kColours}`;
  }

  dash(planner: string): string {
    const i = this.index(planner);
    return kDashes[(i + Math.floor(i / kColours)) % kDashes.length];
  }

  symbolPath(planner: string, area: number): string {
    return symbol().type(kSymbols[this.index(planner) % kSymbols.length]).size(area)() as string;
  }

  // Line and symbol as a legend shows them.
  swatch(planner: string): SVGElement {
    return svg("svg", { class: `swatch ${this.className(planner)}`, width: 34, height: 12,
      viewBox: "0 0 34 12", "aria-hidden": "true" },
      svg("line", { x1: 1, x2: 33, y1: 6, y2: 6, "stroke-dasharray": this.dash(planner) }),
      svg("path", { d: this.symbolPath(planner, 46), transform: "translate(17,6)" }));
  }
}
