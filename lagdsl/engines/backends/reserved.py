"""Names that generated files must not have: what compilers, interpreters and systems look up under them."""

from __future__ import annotations

import builtins
import keyword
import sys
from collections.abc import Iterable, Iterator
from typing import Literal, TypeAlias

from lagdsl.engines.backends.identifier import identifier
from lagdsl.foundation.diagnostics import Sink

Language: TypeAlias = Literal["c", "python", "modelica"]

_PORTS = [f"{port}{k}" for port in ("com", "lpt") for k in range(10)]
_DEVICES = ("con", "prn", "aux", "nul", "conin$", "conout$", "clock$", *_PORTS)
_C_KEYWORDS = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while alignas alignof
    bool complex imaginary noreturn thread_local static_assert typeof nullptr true false constexpr asm fortran
"""
_CPP_KEYWORDS = """
    and and_eq bitand bitor catch class compl concept consteval constinit const_cast co_await co_return co_yield
    decltype delete dynamic_cast explicit export friend mutable namespace new noexcept not not_eq operator or or_eq
    private protected public reinterpret_cast requires static_cast template this throw try typeid typename using
    virtual wchar_t xor xor_eq
"""
# Headers that `#include <...>` finds in the folder of the sources before those of the compiler and of the system.
_HEADERS = """
    assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg stdatomic
    stdbit stdbool stdckdint stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype
    aio alloca ar argz byteswap cpio dirent dlfcn elf endian envz err error execinfo fcntl features float fnmatch fts
    ftw gconv getopt glob gnu_versions grp iconv ieee754 ifaddrs langinfo lastlog libgen libintl link malloc mcheck
    memory mntent monetary mqueue netdb nss obstack paths poll printf pthread pty pwd regex regexp resolv sched search
    semaphore sgtty shadow spawn stab strings stropts syscall syslog tar termio termios thread_db ttyent ucontext
    ulimit unistd utime utmp utmpx values varargs wait wordexp xlocale
    availability cpuid direct immintrin intrin io conio corecrt crtdbg dos emmintrin libio mm_malloc process sal share
    smmintrin tmmintrin vadefs windows winnt windef winbase winuser xmmintrin x86intrin arm_neon altivec
    algorithm array atomic bit bitset charconv chrono codecvt compare concepts coroutine deque exception execution
    filesystem format functional future iomanip ios iosfwd iostream istream iterator latch list map memory_resource
    mutex new numbers numeric optional ostream queue random ranges ratio semaphore set span sstream stack stdexcept
    streambuf string_view thread tuple type_traits typeinfo unordered_map unordered_set utility valarray variant
    vector version
"""
# Names of the Makefile, the runtime, the examples and the headers of FMI.
_OWN = """
    main realtime makefile readme lag freestanding all clean sources binaries
    fmi2functions fmi2functiontypes fmi2typesplatform fmi3functions fmi3functiontypes fmi3platformtypes
"""
_MODELICA_KEYWORDS = """
    algorithm and annotation block break class connect connector constant constrainedby der discrete each else elseif
    elsewhen encapsulated end enumeration equation expandable extends external false final flow for function if import
    impure in initial inner input loop model not operator or outer output package parameter partial protected public
    pure record redeclare replaceable return stream then true type when while within
"""
_PACKAGES = (
    "numpy",
    "scipy",
    "casadi",
    "jax",
    "jaxlib",
    "setup",
    "conftest",
    "lagdsl",
    "test",
    "tests",
    "sitecustomize",
    "usercustomize",
)


def _folded(names: Iterable[str]) -> Iterator[str]:
    """Without case, as file systems compare them."""
    return (name.lower() for name in names)


MODELICA_KEYWORDS = frozenset(_MODELICA_KEYWORDS.split())

_LANGUAGES: dict[Language, tuple[tuple[str, frozenset[str]], ...]] = {
    "c": (
        ("a name that its build files use", frozenset(_OWN.split())),
        ("a keyword of C or C++", frozenset((_C_KEYWORDS + _CPP_KEYWORDS).split())),
        ("a header of the C library or of a system", frozenset(_HEADERS.split())),
        ("a device of Windows", frozenset(_DEVICES)),
    ),
    "python": (
        ("a keyword of Python", frozenset(_folded((*keyword.kwlist, *keyword.softkwlist)))),
        ("a module of Python", frozenset(_folded((*sys.stdlib_module_names, *_PACKAGES)))),
        ("a built-in name of Python", frozenset(_folded(dir(builtins)))),
        ("a device of Windows", frozenset(_DEVICES)),
    ),
    "modelica": (
        ("a keyword of Modelica", frozenset(_folded(MODELICA_KEYWORDS))),
        ("a device of Windows", frozenset(_DEVICES)),
    ),
}

C_NAMES = frozenset[str]().union(*(names for _, names in _LANGUAGES["c"]))
PYTHON_NAMES = frozenset[str]().union(*(names for _, names in _LANGUAGES["python"]))
MODELICA_NAMES = frozenset[str]().union(*(names for _, names in _LANGUAGES["modelica"]))
_NAMES: dict[Language, frozenset[str]] = {"c": C_NAMES, "python": PYTHON_NAMES, "modelica": MODELICA_NAMES}


def report_renamed(name: str, language: Language, sink: Sink) -> None:
    """N0910 where the files of a model have another name than the model."""
    stem = identifier(name, _NAMES[language])
    if stem != name:
        sink.report("N0910", None, name=name, stem=stem, reason=_reason(name, language))


def _reason(name: str, language: Language) -> str:
    for words, names in _LANGUAGES[language]:
        if name.lower() in names:
            return f"`{name}` is {words}"
    return "names of files are letters, digits and `_`, at most 64 of them"
