// Elements with their properties and what is in them.

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
export function choice(ariaLabel: string, words: readonly string[], chosen: number, act?: (number: number) => void): HTMLSelectElement {
  const options = words.map((text, i) => new Option(text, `${i}`, i === chosen, i === chosen));
  const made = make("select", { ariaLabel }, ...options);
  made.onchange = () => act?.(made.selectedIndex);
  return made;
}

export function place(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no #${id}`);
  return found;
}

/** A button with its words, what it does in words, what it does, and the key that does it, too. */
export function button(textContent: string, title: string, onclick: () => void, ariaKeyShortcuts: string | null = null): HTMLButtonElement {
  return make("button", { textContent, title, onclick, ariaKeyShortcuts });
}

/** A menu of buttons, which closes after a choice and when somebody points elsewhere. */
export function menu(words: string, ...inside: HTMLButtonElement[]): HTMLElement[] {
  const list = make("div", { className: "menu", popover: "auto", onclick: () => list.hidePopover() }, ...inside);
  return [make("button", { textContent: words, popoverTargetElement: list }), list];
}
