// Keys of the page: they act on the motion, whatever has the focus, but for what a field needs itself.

/** Keys that fields need themselves: what moves in them, and signs of numbers. */
const TAKEN: [key: RegExp, field: string][] = [
  [/^(Arrow|Home|End)/, "input:not([type=checkbox]):not([aria-label=Time]), select, [role=tab]"],
  [/^[+-]$/, "input[type=number]"],
];

export function keys(acts: Record<string, () => void>): void {
  const act = (event: KeyboardEvent): (() => void) | undefined => {
    if (event.ctrlKey || event.metaKey || event.altKey || !(event.target instanceof Element)) return undefined;
    const { key, target } = event;
    return TAKEN.some(([keys, field]) => keys.test(key) && target.matches(field)) ? undefined : acts[key];
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
