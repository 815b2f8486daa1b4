// Keys of the page: they act on the motion, whatever has the focus, but for what a field needs itself.

/** Keys that fields need themselves: what moves in them, and signs of numbers. */
const TAKEN: [key: RegExp, field: string][] = [
  [/^(Arrow|Home|End)/, "input:not([type=checkbox]):not([aria-label=Time]), select"],
  [/^[+-]$/, "input[type=number]"],
];

/** A key does what `acts` says, or presses the button with this shortcut. */
export function keys(acts: Record<string, () => void>): void {
  const act = ({ key, target, ctrlKey, metaKey, altKey }: KeyboardEvent): (() => void) | undefined => {
    if (ctrlKey || metaKey || altKey || !(target instanceof Element)) return undefined;
    if (TAKEN.some(([keys, field]) => keys.test(key) && target.matches(field))) return undefined;
    const button = [...document.querySelectorAll("button")].find(({ ariaKeyShortcuts }) => ariaKeyShortcuts === (key === " " ? "Space" : key));
    return acts[key] ?? (button && (() => button.click()));
  };
  document.addEventListener("keydown", (event) => {
    const found = act(event);
    if (found === undefined) return;
    event.preventDefault();
    found();
  });
  // A button is pressed when the bar of spaces is released.
  document.addEventListener("keyup", (event) => event.key === " " && act(event) !== undefined && event.preventDefault());
}
