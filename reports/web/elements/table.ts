import { choose, chosen } from "./chosen";
import { el } from "./dom";

// A table whose columns sort when their heading is pressed.
export interface Column<Row> {
  heading: string | HTMLElement;
  title?: string;
  text?: boolean;  // left-aligned
  wrap?: boolean;
  cell: (row: Row) => Node | string;
  order?: (row: Row) => number | string;
}

function compare(a: number | string, b: number | string): number {
  if (typeof a === "string" || typeof b === "string") {
    return String(a).localeCompare(String(b), "en", { numeric: true });
  }
  // Absent numbers go last, whichever way.
  return Number.isNaN(a) ? (Number.isNaN(b) ? 0 : 1) : Number.isNaN(b) ? -1 : a - b;
}

// How the address calls it: "sort.everything-in-numbers" of "Everything in numbers (95 % ...".
function orderKey(caption: string): string {
  return `sort.${caption.split(/[(:]/)[0].toLowerCase().replace(/[^a-z]+/g, "-").replace(/^-|-$/g, "")}`;
}

export function table<Row>(
  caption: string, columns: Column<Row>[], rows: Row[], rowClass: (row: Row) => string = () => ""
): HTMLElement {
  const body = el("tbody");
  const headings = columns.map((column) => {
    const heading = el("th", { scope: "col", class: column.text ? "text" : "" });
    if (column.title) heading.title = column.title;
    return heading;
  });
  const fill = (ordered: Row[]): void => {
    body.replaceChildren(...ordered.map((row) => el("tr", { class: rowClass(row) },
      ...columns.map((column) => el("td",
        { class: [column.text && "text", column.wrap && "wrap"].filter(Boolean).join(" ") },
        column.cell(row))))));
  };
  const said = chosen(orderKey(caption));  // a heading, after a minus where it descends
  fill(rows);
  columns.forEach((column, k) => {
    const { order } = column;
    if (!order) {
      headings[k].append(column.heading);
      return;
    }
    const press = el("button", { type: "button" }, column.heading);
    const name = press.textContent ?? "";
    const sort = (down: boolean): void => {
      headings.forEach((h) => h.removeAttribute("aria-sort"));
      headings[k].setAttribute("aria-sort", down ? "descending" : "ascending");
      fill([...rows].sort((a, b) => {
        const sign = compare(order(a), order(b));
        const absent = Number.isNaN(order(a)) || Number.isNaN(order(b));
        return down && !absent ? -sign : sign;
      }));
    };
    press.addEventListener("click", () => {
      const down = headings[k].getAttribute("aria-sort") === "ascending";
      choose(orderKey(caption), down ? `-${name}` : name);
      sort(down);
    });
    headings[k].append(press);
    if (said === name || said === `-${name}`) sort(said !== name);
  });
  return el("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
    el("table", {}, el("caption", {}, caption), el("thead", {}, el("tr", {}, ...headings)), body));
}
