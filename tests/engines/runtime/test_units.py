"""Translation units hold the whole runtime, each file once, and keep the names of their files apart."""

from __future__ import annotations

from collections import Counter

from lagdsl.engines.runtime.units import ALONE, own_names, unit, unit_texts
from lagdsl.exchange.fmi.package.compile_objects import included
from lagdsl.foundation.resources import c_folder, compiled_runtime, fmi_folder, sources_in, units_in

FILE = """
#include "lag/part.h"
#define LIMIT 3
enum { FIRST = 1, SECOND };
typedef struct places {
    double inside;
} places;
typedef double law(double t);
static const double BEGIN = 1.0, END = 2.0 * FIRST;
static const char *const names[] = {"a", "b"};
static LAG_APART int scaled(const places *at, double (*f)(double)) /* static int no(void) */
{
    static const double HIDDEN = 1.0;
    return f(at->inside) > HIDDEN;
}
double lag_seen(double x)
{
    return x;
}
"""


def test_names_of_a_file_are_those_at_its_top():
    assert own_names(FILE) == {
        *("LIMIT", "FIRST", "SECOND", "places", "law", "BEGIN", "END", "names", "scaled"),
    }


def test_a_name_of_two_files_is_another_one_in_each():
    text = unit({"lag/a/one.c": "static int f(void) { return 1; }\n", "lag/a/two.c": "static int f(void);\n"}, bool)
    assert '#define f one_f\n#include "lag/a/one.c"\n#undef f\n' in text
    assert '#define f two_f\n#include "lag/a/two.c"\n#undef f\n' in text


def test_a_name_of_one_file_stays():
    text = unit({"lag/a/one.c": "static int f(void);\n", "lag/a/two.c": "static int g(void);\n"}, bool)
    assert "#define" not in text


def test_headers_with_a_guard_stand_before_all_files():
    text = unit({"lag/a.c": '#include "lag/a.h"\n#include "lag/twice.h"\n'}, lambda name: name == "lag/a.h")
    assert text.index('#include "lag/a.h"') < text.index('#include "lag/a.c"')
    assert "lag/twice.h" not in text


def test_the_units_are_those_of_the_files():
    """`make update` writes them."""
    for path, text in unit_texts().items():
        assert path.read_text(encoding="utf-8") == text, path.name
    assert {*units_in(c_folder()).values(), *units_in(fmi_folder()).values()} == set(unit_texts())


def test_every_file_is_in_one_unit():
    read = Counter(name for text in unit_texts().values() for name in included(text) if name.endswith(".c"))
    files = {name for name in (*compiled_runtime(), *sources_in(fmi_folder())) if name.endswith(".c")}
    assert read == Counter(files - set(ALONE))
