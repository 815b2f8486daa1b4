// Buttons of the picture, and a menu of them.

/** Adds a button with its words, what it does in words, and what it does. */
export type Buttons = (words: string, title: string, act: () => void) => HTMLButtonElement;

export function buttons(bar: HTMLElement): Buttons {
  return (words, title, act) => {
    const made = document.createElement("button");
    made.textContent = words;
    made.title = title;
    made.onclick = act;
    bar.append(made);
    return made;
  };
}

/** The place for the buttons of a menu, which closes after a choice and when somebody points elsewhere. */
export function menu(bar: HTMLElement, words: string): HTMLElement {
  const made = document.createElement("details");
  made.className = "menu";
  const title = document.createElement("summary");
  title.textContent = words;
  const list = document.createElement("div");
  list.onclick = () => (made.open = false);
  made.append(title, list);
  bar.append(made);
  document.addEventListener("pointerdown", (event) => {
    if (!(event.target instanceof Node && made.contains(event.target))) made.open = false;
  });
  return list;
}
