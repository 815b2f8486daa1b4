// Keys of the page: they act on the motion, whatever has the focus, but for what a field needs itself.

/** Fields that need the arrows, and those into which somebody writes. */
const MOVES = "input:not([type=checkbox]):not([aria-label=Time]), select, [role=tab]";
const WRITES = "input[type=number], select";

export function keys(acts: Record<string, () => void>): void {
  const act = (event: KeyboardEvent): (() => void) | undefined => {
    if (event.ctrlKey || event.metaKey || event.altKey || !(event.target instanceof Element)) return undefined;
    const taken = event.key === " " ? "" : event.key.length > 1 ? MOVES : WRITES;
    return taken !== "" && event.target.matches(taken) ? undefined : acts[event.key];
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
