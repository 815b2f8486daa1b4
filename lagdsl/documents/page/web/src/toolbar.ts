// Buttons of the picture, and a menu of them.
import { make } from "./dom.ts";

/** Adds a button with its words, what it does in words, and what it does. */
export type Buttons = (words: string, title: string, act: () => void) => HTMLButtonElement;

export function buttons(bar: HTMLElement): Buttons {
  return (words, title, act) => {
    const made = make("button", { textContent: words, title, onclick: act });
    bar.append(made);
    return made;
  };
}

/** The place for the buttons of a menu, which closes after a choice and when somebody points elsewhere. */
export function menu(bar: HTMLElement, words: string): HTMLElement {
  const list = make("div", { onclick: () => (made.open = false) });
  const made = make("details", { className: "menu" }, make("summary", { textContent: words }), list);
  bar.append(made);
  document.addEventListener("pointerdown", (event) => {
    if (!(event.target instanceof Node && made.contains(event.target))) made.open = false;
  });
  return list;
}
