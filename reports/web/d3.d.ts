// What the page uses of d3, for the type check (Debian ships no types for these modules). Scales and
// selections are loose on purpose: their arguments are checked where they are our own.
declare module "d3-axis" {
  export function axisBottom(scale: any): any;
  export function axisLeft(scale: any): any;
}
declare module "d3-scale" {
  export function scaleLinear<Range = number>(): any;
  export function scaleLog(): any;
  export function scaleBand(): any;
}
declare module "d3-selection" {
  export function select(element: Element): any;
}
declare module "d3-shape" {
  export const symbolCircle: object, symbolCross: object, symbolDiamond: object, symbolSquare: object,
    symbolStar: object, symbolTriangle: object, symbolWye: object;
  export function symbol(): any;
}
declare module "d3-array" {
  export function ascending(a: number, b: number): number;
  export function bisectRight(sorted: number[], value: number): number;
  export function quantile(values: number[], probability: number): number | undefined;
}

// Newer than the library of the compiler that Debian ships.
declare class DecompressionStream {
  constructor(format: "deflate-raw");
  readonly readable: ReadableStream<Uint8Array>;
  readonly writable: WritableStream<Uint8Array>;
}
