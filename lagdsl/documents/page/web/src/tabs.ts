// The panels, one at a time: a tab list as the ARIA Authoring Practices describe it.

/** `changed` is called when another panel is shown. */
export function tabs(changed: () => void): void {
  const all = [...document.querySelectorAll<HTMLButtonElement>("[role=tab]")];
  const choose = (chosen: HTMLButtonElement): void => {
    for (const tab of all) {
      tab.ariaSelected = `${tab === chosen}`;
      tab.tabIndex = tab === chosen ? 0 : -1;
      document.getElementById(tab.getAttribute("aria-controls") ?? "")?.toggleAttribute("hidden", tab !== chosen);
    }
    changed();
  };
  all.forEach((tab, i) => {
    tab.onclick = () => choose(tab);
    tab.onkeydown = (event) => {
      const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (step === 0) return;
      event.stopPropagation();
      const next = all[(i + step + all.length) % all.length];
      choose(next);
      next.focus();
    };
  });
  choose(all[0]);
}
