// What a drawing of a scene is taken away as: the picture, or the numbers of the ways in it.
import { Report, Trial } from "../data/data";
import { button, csv, saveText } from "../elements/dom";
import { standaloneSvg } from "../elements/take_away";
import { hasTrace, loadTrace } from "../data/trace";

async function waysOf(report: Report, trials: Trial[]): Promise<string> {
  const drawn = trials.filter((t) => hasTrace(report, t.trial_id));
  const traces = await Promise.all(drawn.map((t) => loadTrace(report, t.trial_id)));
  return csv(["trial_id", "planner", "outcome", "time_s", "x_m", "y_m"], traces.flatMap((trace, i) =>
    Array.from(trace.frames.t_s, (t_s, k) => [drawn[i].trial_id, drawn[i].planner, drawn[i].outcome, t_s,
      trace.frames.x_m[k], trace.frames.y_m[k]])));
}

// `drawing`: null as long as it is not drawn.
export function waysButtons(report: Report, trials: Trial[], id: string, title: string,
                            drawing: () => SVGElement | null): HTMLElement[] {
  return [
    button("SVG", `Save "${title}" as SVG`, () => {
      const picture = drawing();
      if (picture) saveText(`${id}.svg`, "image/svg+xml", standaloneSvg(picture, title));
    }),
    button("CSV", `Save the ways of "${title}" as CSV`, () => {
      void waysOf(report, trials).then((text) => saveText(`${id}.csv`, "text/csv", text));
    }),
  ];
}
