// Light or dark: as the system says, until the reader says otherwise.
import { choose, chosen } from "./chosen";
import { button } from "./dom";

const kDark = "(prefers-color-scheme: dark)";

function setTheme(theme: string): void {
  document.documentElement.dataset.theme = theme;
  window.dispatchEvent(new Event("themechange"));
}

export function followSystemTheme(): void {
  const query = matchMedia(kDark);
  const follow = (): void => setTheme(chosen("theme") === "dark" || chosen("theme") === "light"
    ? chosen("theme") : query.matches ? "dark" : "light");
  query.addEventListener("change", follow);
  follow();
  // Ink on paper, whatever the screen shows.
  let before = "";
  window.addEventListener("beforeprint", () => {
    before = document.documentElement.dataset.theme ?? "";
    setTheme("light");
  });
  window.addEventListener("afterprint", () => setTheme(before));
}

export function themeButton(): HTMLButtonElement {
  return button("Light / dark", "Switch between light and dark", () => {
    choose("theme", document.documentElement.dataset.theme === "dark" ? "light" : "dark");
    setTheme(chosen("theme"));
  });
}
