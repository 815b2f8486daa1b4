"""The search for cycles rests while blocks run, and goes on as it was set before."""

import gc
from weakref import ref

import pytest

from lagdsl.foundation.collection import without_collection


def test_the_search_goes_on_behind_the_last_block() -> None:
    assert gc.isenabled()
    with without_collection():
        with without_collection():
            assert not gc.isenabled()
        assert not gc.isenabled()
    assert gc.isenabled()


def test_the_search_goes_on_after_an_error() -> None:
    with pytest.raises(ValueError), without_collection():
        raise ValueError
    assert gc.isenabled()


class Ring:
    def __init__(self) -> None:
        self.own = self


def test_cycles_that_were_made_meanwhile_are_found_later() -> None:
    with without_collection():
        ring = ref(Ring())
        assert ring() is not None
    gc.collect()
    assert ring() is None


def test_a_search_that_was_off_stays_off() -> None:
    gc.disable()
    try:
        with without_collection():
            pass
        assert not gc.isenabled()
    finally:
        gc.enable()
