"""`%load_ext lagdsl`: the cell magic, forms of results, words for failures, bars of progress."""

from __future__ import annotations

from functools import partial
from typing import Any

from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.interfaces.api.watch import watch_with
from lagdsl.interfaces.notebook.bar import Bar
from lagdsl.interfaces.notebook.cell import lag
from lagdsl.interfaces.notebook.pictures import show_figures, without_figures
from lagdsl.interfaces.notebook.tables import FORMS
from lagdsl.interfaces.notebook.told import Told
from lagdsl.motion.simulate.failure import SimulationFailed


def load_ipython_extension(shell: Any) -> None:
    """Called by `%load_ext lagdsl`; `shell` is IPython's InteractiveShell."""
    shell.register_magic_function(partial(lag, shell), "cell", "lag")
    html = shell.display_formatter.formatters["text/html"]
    for (module, name), form in FORMS.items():
        html.for_type_by_name(module, name, form)
    show_figures(shell)
    shell.set_custom_exc((CompilationFailed, SimulationFailed), _tell)
    watch_with(Bar)


def unload_ipython_extension(shell: Any) -> None:
    """Called by `%unload_ext lagdsl`."""
    html = shell.display_formatter.formatters["text/html"]
    for module, name in FORMS:
        html.pop(f"{module}.{name}", None)
    without_figures(shell)
    shell.set_custom_exc((), None)
    watch_with(None)


def _tell(
    shell: Any, kind: object, failure: CompilationFailed | SimulationFailed, trace: object, tb_offset: int | None = None
) -> None:
    """The words of a failure in place of a traceback through the compiler. The cell has failed all the same."""
    from IPython.display import display

    display(Told(failure.diagnostics))
