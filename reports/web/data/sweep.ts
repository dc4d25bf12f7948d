// Which groups of a summary form a sweep: the same thing at different values of one number. A suite
// may say its axes itself (`sweep`, reports/axis_columns.h); others are found here.
import { byName, PlannerSummary, Report, vehicleOf } from "./data";
import type { Filter } from "./sample";

const kFewest = 3;  // values that make a sweep of what differs by chance

export interface SweepPoint {
  x: number;
  summary: PlannerSummary;
}

export interface Sweep {
  title: string;
  xName: string;
  vehicle: string;
  held: string;    // the other axes of the suite and their values here; "" if there are none
  ratios: boolean; // its values have equal ratios, so the axis is logarithmic
  fewest: number;  // points that make a line worth drawing
  lines: { label: string; planner: string; points: SweepPoint[] }[];  // planner: whose colour
}

type Entries = Record<string, unknown>;

interface Configured {
  name: string;
  group: string;
  label: string;
  definition?: string;  // of a random scenario: key=value;key=value; ...
  params?: Entries;
}

function configured(report: Report, list: "scenarios" | "planners"): Configured[] {
  const configuration = (report.manifest as Entries | null)?.configuration as Entries | undefined;
  return (configuration?.[list] as Configured[] | undefined) ?? [];
}

// The one key whose numbers tell these apart, or null.
function varying(all: Entries[]): string | null {
  const keys = [...new Set(all.flatMap((entries) => Object.keys(entries)))];
  const differ = keys.filter((key) => new Set(all.map((e) => JSON.stringify(e[key]))).size > 1);
  if (differ.length !== 1) return null;
  const values = all.map((entries) => entries[differ[0]]);
  return values.every((v) => Number.isFinite(Number(v))) ? differ[0] : null;
}

function grouped<Item>(items: Item[], key: (item: Item) => string): Map<string, Item[]> {
  const groups = new Map<string, Item[]>();
  for (const item of items) {
    const list = groups.get(key(item));
    if (list) list.push(item);
    else groups.set(key(item), [item]);
  }
  return groups;
}

// The generator's name stands after the scenario's own and replaces it.
function entriesOf(definition: string): Record<string, string> {
  return Object.fromEntries(definition.split(";").map((pair) => pair.split("="))
    .filter((pair) => pair.length === 2));
}

// Scenario groups by the parameter of the generator they differ in: group name -> value.
function generatorSweeps(report: Report): { xName: string; x: Map<string, number> }[] {
  const scenarios = configured(report, "scenarios").filter((s) => s.definition)
    .map((s) => ({ group: s.group, entries: entriesOf(s.definition as string) }));
  const sweeps = [];
  for (const [name, list] of grouped(scenarios, (s) => s.entries.name)) {
    const key = varying(list.map((s) => s.entries));
    if (!key) continue;
    sweeps.push({ xName: `${name}: ${key}`,
      x: new Map(list.map((s) => [s.group, Number(s.entries[key])])) });
  }
  return sweeps;
}

// Else by the number in their names: "bearing-45", "bearing-90" ...
function namedSweeps(groups: string[]): { xName: string; x: Map<string, number> }[] {
  const parts = groups.map((name) => ({ name, match: /^(.*?)(-?\d+(?:\.\d+)?)(\D*)$/.exec(name) }))
    .flatMap(({ name, match }) => match ? [{ name, stem: `${match[1].replace(/[-_ ]$/, "")}${match[3]}`,
      x: Math.abs(Number(match[2])) }] : []);
  return [...grouped(parts, (p) => p.stem)].map(([stem, list]) => ({
    xName: `${stem || "scenario group"}: number in its name`,
    x: new Map(list.map((p) => [p.name, p.x])),
  }));
}

// An axis that the suite says (reports/axis_columns.h).
interface SaidAxis {
  path: string;
  column: "scenario" | "vehicle" | "planner";
  zipped: boolean;
  values: Entries;  // by the name in that column
  groups: Entries;  // by scenario group, of a scenario's axis
  bases: Record<string, string>;  // what the suite calls it, by name; of a scenario's axis by group
}

function saidAxes(report: Report): SaidAxis[] {
  const configuration = (report.manifest as Entries | null)?.configuration as Entries | undefined;
  return (configuration?.sweep as SaidAxis[] | undefined) ?? [];
}

function keyOf(row: PlannerSummary, column: SaidAxis["column"]): string {
  return column === "scenario" ? row.scenario_group : row[column];
}

function valueOn(axis: SaidAxis, row: PlannerSummary): unknown {
  return (axis.column === "scenario" ? axis.groups : axis.values)[keyOf(row, axis.column)];
}

function baseOf(axes: SaidAxis[], row: PlannerSummary, column: SaidAxis["column"]): string {
  const key = keyOf(row, column);
  const made = axes.find((axis) => axis.column === column && axis.bases[key] !== undefined);
  return made ? made.bases[key] : key;
}

// Axes whose values are no numbers have no line.
export function axesWithoutLine(report: Report): string[] {
  return saidAxes(report).filter((axis) => !Object.values(axis.values).every((v) => typeof v === "number"))
    .map((axis) => axis.path);
}

function haveEqualRatios(axis: SaidAxis): boolean {
  const values = [...new Set(Object.values(axis.values).map(Number))].sort((a, b) => a - b);
  if (values.length < 3 || values[0] <= 0) return false;
  const ratio = (values[values.length - 1] / values[0]) ** (1 / (values.length - 1));
  return values.every((v, i) => Math.abs(v / (values[0] * ratio ** i) - 1) < 0.01);
}

// One drawing for each combination of what else is swept but the planners', which are lines: all other
// axes are held, nothing is averaged over them.
function saidSweep(axes: SaidAxis[], axis: SaidAxis, rows: PlannerSummary[]): Sweep[] {
  const inStep = axes.filter((other) => other !== axis && other.zipped && axis.zipped);
  const held = axes.filter((other) => other !== axis && !inStep.includes(other));
  const heldText = (row: PlannerSummary, mine: boolean): string => held
    .filter((other) => (other.column === "planner") === mine && valueOn(other, row) !== undefined)
    .map((other) => `${other.path} = ${valueOn(other, row)}`).join(", ");
  const vehicle = (row: PlannerSummary): string =>
    vehicleOf({ vehicle: baseOf(axes, row, "vehicle"), regulator: row.regulator });
  const xName = axis.path + (inStep.length ? ` (in step with ${inStep.map((a) => a.path).join(", ")})` : "");
  const inside = rows.filter((row) => typeof valueOn(axis, row) === "number");
  const panels = grouped(inside, (row) =>
    JSON.stringify([vehicle(row), baseOf(axes, row, "scenario"), heldText(row, false)]));
  return [...panels.values()].map((panel): Sweep => ({
    title: `over ${axis.path} in ${baseOf(axes, panel[0], "scenario")}`, xName,
    vehicle: vehicle(panel[0]), held: heldText(panel[0], false), ratios: haveEqualRatios(axis), fewest: 2,
    lines: [...grouped(panel, (row) => JSON.stringify([baseOf(axes, row, "planner"), heldText(row, true)]))
      .values()].map((line) => ({
        label: [baseOf(axes, line[0], "planner"), heldText(line[0], true)].filter((t) => t).join(", "),
        planner: line[0].planner,
        points: byX(line.map((row) => ({ x: valueOn(axis, row) as number, summary: row }))),
      })).sort((l, m) => byName(l.label, m.label)),
  }));
}

function saidSweeps(report: Report, rows: PlannerSummary[]): Sweep[] {
  const axes = saidAxes(report);
  return axes.flatMap((axis) => saidSweep(axes, axis, rows));
}

function byX(points: SweepPoint[]): SweepPoint[] {
  return points.sort((a, b) => a.x - b.x);
}

function scenarioSweeps(report: Report, rows: PlannerSummary[]): Sweep[] {
  const exact = generatorSweeps(report);
  const covered = new Set(exact.filter((s) => s.x.size >= kFewest).flatMap((s) => [...s.x.keys()]));
  const axes = [...exact, ...namedSweeps(report.groups.filter((g) => !covered.has(g)))]
    .filter((axis) => axis.x.size >= kFewest);
  return axes.flatMap(({ xName, x }) => {
    const inside = rows.filter((r) => x.has(r.scenario_group));
    return [...grouped(inside, vehicleOf)].map(([vehicle, list]): Sweep => ({
      title: "over the scenarios", xName, vehicle, held: "", ratios: false, fewest: kFewest,
      lines: [...grouped(list, (r) => r.planner)].sort(([a], [b]) => byName(a, b)).map(([planner, mine]) => ({
        label: planner, planner,
        points: byX(mine.map((r) => ({ x: x.get(r.scenario_group) as number, summary: r }))),
      })),
    }));
  });
}

function plannerSweeps(report: Report, rows: PlannerSummary[]): Sweep[] {
  const sweeps: Sweep[] = [];
  for (const [name, list] of grouped(configured(report, "planners"), (p) => p.name)) {
    const key = list.length >= kFewest ? varying(list.map((p) => p.params ?? {})) : null;
    if (!key) continue;
    const x = new Map(list.map((p) => [p.label, Number(p.params?.[key])]));
    const inside = rows.filter((r) => x.has(r.planner));
    for (const [place, mine] of grouped(inside, (r) => JSON.stringify([vehicleOf(r), r.scenario_group]))) {
      const [vehicle, group] = JSON.parse(place) as [string, string];
      sweeps.push({ title: `over ${key} of ${name} in ${group}`, xName: `${name}: ${key}`, vehicle,
        held: "", ratios: false, fewest: kFewest,
        lines: [{ label: name, planner: list[0].label,
          points: byX(mine.map((r) => ({ x: x.get(r.planner) as number, summary: r }))) }] });
    }
  }
  return sweeps;
}

export function sweepsOf(report: Report, filter: Filter): Sweep[] {
  const rows = report.summary.groups.filter((r) => filter.planners.has(r.planner) &&
    (!filter.group || r.scenario_group === filter.group) &&
    (!filter.vehicle || vehicleOf(r) === filter.vehicle));
  const axes = saidAxes(report);
  const found = rows.filter((row) => axes.every((axis) => valueOn(axis, row) === undefined));
  const said = saidSweeps(report, rows);
  const others = [...scenarioSweeps(report, found), ...plannerSweeps(report, found)]
    .sort((a, b) => byName(a.title, b.title) || byName(a.xName, b.xName) || byName(a.vehicle, b.vehicle));
  return [...said, ...others]
    .filter((sweep) => sweep.lines.some((line) => line.points.length >= sweep.fewest));
}
