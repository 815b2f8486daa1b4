"""The style sheet of the HTML report."""

STYLE = """\
:root { --ink: #1d2430; --soft: #5b6675; --line: #dfe3e8; --paper: #fdfdfb; --accent: #1f5f8b; --wash: #f1f5f8; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 17px/1.6 "Iowan Old Style", "Palatino Linotype", Palatino, "Book Antiqua", Georgia, serif; }
main { max-width: 54rem; margin: 0 auto; padding: 3.5rem 1.5rem 5rem; }
header { border-bottom: 3px solid var(--accent); padding-bottom: 1.2rem; margin-bottom: 1rem; }
.kicker { margin: 0; color: var(--accent); font: 600 0.8rem/1.4 system-ui, sans-serif; letter-spacing: 0.12em;
  text-transform: uppercase; }
h1 { font-size: 2.3rem; line-height: 1.15; margin: 0.3rem 0 0; font-weight: 600; }
.subtitle { margin: 0.5rem 0 0; color: var(--soft); font-style: italic; font-size: 1.1rem; }
section { padding: 0.4rem 0 0.2rem; }
h2 { font-size: 1.25rem; margin: 1.6rem 0 0.6rem; font-weight: 600; display: flex; align-items: center; gap: 0.7rem; }
.step { flex: none; min-width: 1.9rem; height: 1.9rem; padding: 0 0.5rem; border-radius: 1rem; color: #fff;
  background: var(--accent); font: 600 0.9rem/1.9rem system-ui, sans-serif; text-align: center; }
p { margin: 0.5rem 0; }
ul { margin: 0.5rem 0; padding-left: 1.3rem; }
li { margin: 0.25rem 0; }
code { font: 0.85em/1.4 ui-monospace, "SF Mono", Menlo, Consolas, monospace; background: var(--wash);
  padding: 0.1em 0.35em; border-radius: 3px; }
.scroll, .equations { overflow-x: auto; overflow-y: hidden; }
table { border-collapse: collapse; margin: 0.6rem 0; font-size: 0.97em; }
th { text-align: left; font: 600 0.74rem/1.4 system-ui, sans-serif; letter-spacing: 0.05em; color: var(--soft);
  text-transform: uppercase; border-bottom: 1px solid var(--line); padding: 0.3rem 1.4rem 0.3rem 0; }
td { padding: 0.35rem 1.4rem 0.35rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
math { font-size: 1.05em;
  font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", "DejaVu Math TeX Gyre", math; }
.equations { margin: 0.7rem 0; padding: 0.5rem 1.2rem; border-left: 3px solid var(--line); }
.equations.final { background: var(--wash); border-left-color: var(--accent); border-radius: 0 6px 6px 0;
  padding: 0.9rem 1.2rem; }
.aligned { margin: 0; font-size: 1em; }
.aligned td { padding: 0.34em 0.1em; border: 0; vertical-align: baseline; white-space: nowrap; }
.aligned td.left { text-align: right; }
figure { margin: 1rem 0; } figure svg { max-width: 100%; height: auto; }
figcaption { color: var(--soft); font-size: 0.92em; }
.dot { font-size: 140%; }
mi.word { font-style: italic; }
.cases > mtr > mtd { text-align: left; }
@media (max-width: 40rem) { main { padding: 2rem 1rem 3rem; } h1 { font-size: 1.8rem; } }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e7eb; --soft: #9aa5b1; --line: #343c47; --paper: #15191f; --accent: #6db3e0; --wash: #1e252e; }
  .step { color: #15191f; } }
@media print { body { font-size: 11pt; background: #fff; color: #000; } main { max-width: none; padding: 0; }
  .equations, .scroll { overflow: visible; }
  .equations math { font-size: min(0.82em, calc(84em / var(--letters, 92))); }
  tr { break-inside: avoid; } h2, p:has(+ .equations) { break-after: avoid; }
  figure { break-inside: avoid; } }
"""
