// What a reader has chosen, in the fragment of the address behind the place: #PAGE?theme=dark&group=forest.
// So it outlives a reload, goes with a copied address, and stays from page to page.

const kBehind = /\?(.*)$/;

let choices = new URLSearchParams();

// The fragment without the choices.
export function placeOf(fragment: string): string {
  return fragment.replace(kBehind, "");
}

function choicesOf(fragment: string): URLSearchParams {
  return new URLSearchParams(kBehind.exec(fragment)?.[1] ?? "");
}

// Puts a place into the address, with the choices, without a step of the browser's history.
export function standAt(place: string): void {
  const all = choices.toString();
  history.replaceState(null, "", (place || "#") + (all && `?${all}`));
}

// Takes the address for the choices from now on.
export function readChoices(): void {
  choices = choicesOf(location.hash);
}

// A link to a place keeps the choices; an address that brings others is drawn with those.
export function followAddress(): void {
  if (!location.hash.includes("?")) standAt(location.hash);
  else if (choicesOf(location.hash).toString() !== choices.toString()) location.reload();
}

export function chosen(key: string): string {
  return choices.get(key) ?? "";
}

export function allChosen(key: string): string[] {
  return choices.getAll(key);
}

// None: the default again.
export function choose(key: string, ...values: string[]): void {
  choices.delete(key);
  values.filter((v) => v).forEach((v) => choices.append(key, v));
  standAt(placeOf(location.hash));
}
