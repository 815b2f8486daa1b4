"""The engine that chooses: the tape at once, compiled C where the work that is foreseen pays for the compiler.

C is compiled so that every operation is rounded as on the tape. Results are the same to the bit, whichever of the two
computes them, so that the choice may depend on the clock and on what lies in the cache.
"""

from __future__ import annotations

import hashlib
import weakref
from ctypes import byref
from functools import cache, cached_property
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from lagdsl.derivation.program.digest import digest
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.tape.emit import PARTS
from lagdsl.engines.runtime.building.cache import cache_folder
from lagdsl.engines.runtime.engines.c_engine import opened, pays
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.engines.one_value import Place
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.engines.runtime.structures import Status
from lagdsl.foundation.collection import without_collection
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.foundation.resources import c_folder
from lagdsl.foundation.version import __version__

if TYPE_CHECKING:
    from lagdsl.engines.runtime.building.background_build import BackgroundBuild
    from lagdsl.engines.runtime.building.compiler import Compiler

# Calls of one value at one state from one look at their time to the next.
_CALLS = 4096
# The part with the derivatives of the motion.
_DERIVATIVES = ("jacobian",)


class AutoEngine(TapeEngine):
    """As TapeEngine, until there is C: `worked` starts the compiler where that pays, `hasten` takes what it made.

    A library that lies in the cache is taken at once. Without a compiler it stays the tape.
    """

    name: EngineName = "auto"

    def __init__(self, program: Program, *, together: bool = False) -> None:
        self._compiled: NativeModel | None = None
        self._worked = 0.0
        self._build: BackgroundBuild | None = None
        self._derivatives: BackgroundBuild | NativeModel | None = None
        super().__init__(program, together=together)

    @property
    def is_compiled(self) -> bool:
        return self._compiled is not None

    def worked(self, seconds: float, left: float = 0.0) -> None:
        """So many seconds of work were done, and so many are known to come. Without better knowledge there comes as
        much again as there was."""
        if self._compiled is not None or self._build is not None:
            return
        self._worked += seconds
        if pays(max(left, self._worked), self._tape) and self._compiler is not None:
            parts = self._parts_of_native
            self._build = _building(self.program, parts, self._name(self._compiler, parts))
            weakref.finalize(self, self._build.cancel)

    @property
    def native(self) -> NativeModel:
        """The compiled model where there is one, else that of the tape."""
        self.hasten()
        return self._model

    def hasten(self) -> NativeModel | None:
        """The compiled model, when it has just been finished; from then on everything is computed by it."""
        if self._build is None or self._build.is_running or self._compiled is not None:
            return None
        library, self._build = self._build.library, None
        if library is None:
            self._compiler = None
            return None
        self._compiled = _loaded(library, self.program, self._parts_of_native)
        if self._compiled is not None:
            self._use(self._compiled)
        return self._compiled

    def differentiated(self) -> NativeModel | None:
        """On the tape at first. Where the motion is worth compiling, so are its derivatives, which take longer."""
        taped = super().differentiated()
        if taped is None or self._compiled is None or self._compiler is None:
            return taped
        if self._derivatives is None:
            name = self._name(self._compiler, _DERIVATIVES)
            self._derivatives = _cached(name, self.program, _DERIVATIVES)
            if self._derivatives is None:
                self._derivatives = build = _building(self.program, _DERIVATIVES, name)
                weakref.finalize(self, build.cancel)
        if not isinstance(self._derivatives, NativeModel) and not self._derivatives.is_running:
            library = self._derivatives.library
            self._derivatives = taped if library is None else _loaded(library, self.program, _DERIVATIVES) or taped
        return self._derivatives if isinstance(self._derivatives, NativeModel) else taped

    @property
    def _patience(self) -> int:
        return 0 if self.is_compiled else _CALLS

    def _heed(self, status: int, given: int, place: Place) -> bool:
        super()._heed(status, given, place)
        if status == Status.ATTENTION and not self.is_compiled:
            structure = place[-1].call
            structure.left = _CALLS
            begin = perf_counter()
            self._runtime.call_once(byref(structure), given)
            self.worked(_CALLS * (perf_counter() - begin))
            self.hasten()
        return not (status == Status.ATTENTION and self.is_compiled)

    def _provide(self, part: str | None = None) -> NativeModel:
        if part is None and self._has_library() and self._compiler is not None:
            parts = self._parts_of_native
            self._compiled = _cached(self._name(self._compiler, parts), self.program, parts)
        return super()._provide(part) if part is not None or self._compiled is None else self._compiled

    def _has_library(self) -> bool:
        """True if the cache has the folder of this program: names of libraries in it take longer to find."""
        try:
            return (cache_folder() / self._key).is_dir()
        except (CompilationFailed, OSError):
            return False

    def _made(self, part: str | None) -> bytes:
        return super()._made(part) if part in PARTS else self._tape

    @cached_property
    def _compiler(self) -> Compiler | None:
        """None where there is none, or where it failed. Few models run long enough to ask."""
        from lagdsl.engines.runtime.building.compiler import find_compiler

        try:
            return find_compiler()
        except CompilationFailed:
            return None

    @cached_property
    def _tape(self) -> bytes:
        """Made when it is first asked for: not where a library lies in the cache."""
        return self._tapes.tape()

    @cached_property
    def _key(self) -> str:
        """The folder in the cache of libraries that were made of this program."""
        return digest(self.program)[:20]

    def _name(self, compiler: Compiler, parts: tuple[str, ...]) -> str:
        """Of the library in the cache with these parts: made of all that decides what is in it."""
        from lagdsl.engines.runtime.building.build import content_hash
        from lagdsl.engines.runtime.building.compiler import ALIKE

        made_of = {"program": _writers(), **dict.fromkeys(parts, "")}
        return f"{self._key}/{content_hash(made_of, compiler, (ALIKE,))}"


def _building(program: Program, parts: tuple[str, ...], name: str) -> BackgroundBuild:
    """Starts a build in the background. The modules that write and compile C are imported here, because most runs end
    before that pays."""
    from lagdsl.engines.backends.c.emit import engine_sources
    from lagdsl.engines.runtime.building.background_build import BackgroundBuild
    from lagdsl.engines.runtime.building.compiler import ALIKE

    def sources() -> dict[str, str]:
        with without_collection():
            return engine_sources(program, parts)

    return BackgroundBuild(sources, (ALIKE,), name)


def _cached(name: str, program: Program, parts: tuple[str, ...]) -> NativeModel | None:
    try:
        library = cache_folder() / f"{name}.so"
    except CompilationFailed:
        return None
    return _loaded(library, program, parts) if library.is_file() else None


def _loaded(library: Path, program: Program, parts: tuple[str, ...]) -> NativeModel | None:
    """None for a library that was cut short or made for another machine."""
    try:
        return opened(library, program, *parts)
    except OSError:
        return None


@cache
def _writers() -> str:
    """Modules that write C, and headers that the C is compiled against: a change of them makes another library of the
    same program."""
    digest = hashlib.sha256(__version__.encode())
    emitter = Path(__file__).resolve().parents[2] / "backends"
    for path in sorted([*emitter.rglob("*.py"), *(c_folder() / "lag").rglob("*.h")]):
        digest.update(f"{path.name}:".encode() + path.read_bytes())
    return digest.hexdigest()
