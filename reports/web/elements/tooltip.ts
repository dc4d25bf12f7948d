// One box for the whole page that says what is under the pointer: the text of data-tip, or what a
// plot answers for a place in it.
import { el } from "./dom";

const kOffset_px = 14;

const box = el("div", { class: "tooltip", role: "status", hidden: "" });

function showAt(x_px: number, y_px: number, text: string): void {
  if (!box.isConnected) document.body.append(box);
  box.textContent = text;
  box.hidden = false;
  const { width, height } = box.getBoundingClientRect();
  const left = x_px + kOffset_px + width > window.innerWidth ? x_px - kOffset_px - width : x_px + kOffset_px;
  const top = y_px + kOffset_px + height > window.innerHeight ? y_px - kOffset_px - height : y_px + kOffset_px;
  box.style.left = `${Math.max(0, left)}px`;
  box.style.top = `${Math.max(0, top)}px`;
}

function hide(): void {
  box.hidden = true;
}

export function startTooltips(): void {
  document.addEventListener("pointermove", (event) => {
    const target = event.target as Element;
    const text = target.closest?.("[data-tip]")?.getAttribute("data-tip");
    if (text) showAt(event.clientX, event.clientY, text);
    else if (!target.closest?.("[data-probed]")) hide();
  });
  document.addEventListener("scroll", hide, true);
}

// While the pointer is over `picture`, shows what `answer` says for the place, in the units of its
// viewBox; null says nothing.
export function probe(
  picture: SVGElement, answer: (x: number, y: number) => string | null, onLeave: () => void
): void {
  picture.dataset.probed = "";
  const leave = (): void => {
    hide();
    onLeave();
  };
  picture.addEventListener("pointerleave", leave);
  picture.addEventListener("pointermove", (event) => {
    if ((event.target as Element).closest("[data-tip]")) return;
    const rect = picture.getBoundingClientRect();
    const view = (picture as SVGSVGElement).viewBox.baseVal;
    const text = answer(view.x + (event.clientX - rect.left) * view.width / rect.width,
      view.y + (event.clientY - rect.top) * view.height / rect.height);
    if (text) showAt(event.clientX, event.clientY, text);
    else leave();
  });
}
