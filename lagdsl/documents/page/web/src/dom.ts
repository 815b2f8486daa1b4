// Elements with their properties and what is in them; buttons and menus of them.

/** ARIA attributes are properties, too: `ariaLabel`. */
export function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  given: Partial<HTMLElementTagNameMap[Tag]> = {},
  ...inside: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const made = Object.assign(document.createElement(tag), given);
  made.append(...inside);
  return made;
}

/** A choice of one of some words by its number; what is chosen at first is told nobody. */
export function choice(ariaLabel: string, words: readonly string[], chosen: number, act: (number: number) => void): HTMLSelectElement {
  const options = words.map((text, i) => new Option(text, `${i}`, i === chosen, i === chosen));
  const made = make("select", { ariaLabel }, ...options);
  made.onchange = () => act(made.selectedIndex);
  return made;
}

/** An element of a drawing, with its attributes. */
export function drawn(tag: string, given: Record<string, string | number>, text = ""): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [key, value] of Object.entries(given)) made.setAttribute(key, `${value}`);
  made.textContent = text;
  return made;
}

export function place(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no #${id}`);
  return found;
}

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
