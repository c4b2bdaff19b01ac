# SPDX-License-Identifier: LGPL-2.1-or-later
"""A few thousand changed files in the ordinary tests, the same each time, and every file that once broke something.

`make fuzz` runs half a million.
"""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensworkbench.core.refusal import Refused

from . import mutate, readers

CORPUS = sorted(p for p in (Path(__file__).parent / "corpus").iterdir() if p.is_file())
KINDS = sorted(mutate.SEEDS)
EACH = 400
FEW = settings(max_examples=150, derandomize=True, deadline=None, database=None)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("fuzz")


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_changed_is_valid_itself(kind, folder):
    assert all(readers.judge(kind, text.encode(), folder) for text in mutate.SEEDS[kind])


@pytest.mark.parametrize("kind", KINDS)
def test_changed_files_are_read_or_refused(kind, folder):
    rng = random.Random(kind)
    outcomes = [readers.judge(kind, mutate.changed(rng, rng.choice(mutate.SEEDS[kind])), folder) for _ in range(EACH)]
    assert 0 < sum(outcomes) < EACH  # neither everything is refused nor anything is taken


@pytest.mark.parametrize("path", CORPUS, ids=lambda p: p.name)
def test_files_that_once_broke_something_are_read_or_refused(path, folder):
    kind = path.name.partition("--")[0].replace("-", " ")
    readers.judge(kind, path.read_bytes(), folder)


def test_a_fault_is_found(folder, monkeypatch):
    def broken(path):
        raise KeyError("x")

    def wordy(path):
        raise Refused("readings-cell-empty", "word " * 100)

    for reader in (broken, wordy):
        monkeypatch.setitem(readers.READERS, "isg", reader)
        with pytest.raises(readers.Fault):
            readers.judge("isg", b"", folder)


# -- strategies: files that are made instead of changed ----------------------------------------------------------------
NUMBER = st.one_of(st.floats(), st.integers(-(10**400), 10**400), st.floats(-1e3, 1e3), st.sampled_from(mutate.NUMBERS))
CELL = st.one_of(NUMBER.map(str), st.text(max_size=12), st.sampled_from(mutate.PIECES))
NAME = st.one_of(
    st.sampled_from(["x_mm", "y_mm", "z_mm", "ex_um", "ey_um", "ez_um", "t_s", "dir_x", "temp_a_C", "run", "u_um", "nx",
                     "ny", "nz", "reading_um", "tool_dx_mm", "feed_mm_min", "load_a_kg", "spindle_rpm", "x_um", "t_h"]),
    st.text(max_size=8),
)  # fmt: skip
JSON = st.recursive(
    st.one_of(st.none(), st.booleans(), st.floats(), st.integers(), st.text(max_size=8)),
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(st.text(max_size=6), inner, max_size=4)),
    max_leaves=12,
)


@st.composite
def tables(draw) -> bytes:
    """A table with some of our names, some cells, comments and a separator."""
    names = draw(st.lists(NAME, min_size=1, max_size=9))
    if draw(st.booleans()):
        names = ["x_mm", "y_mm", "z_mm", *names]
    rows = draw(st.lists(st.lists(CELL, min_size=len(names), max_size=len(names)), max_size=5))
    comments = draw(
        st.lists(st.sampled_from(["# sign: error", "# sign: ,", "# positions: table Z", "# frame = table", "#"]))
    )
    separator = draw(st.sampled_from([",", ";", "\t"]))
    lines = [*comments, separator.join(names), *(separator.join(row) for row in rows)]
    return "\n".join(lines).encode("utf-8", "surrogatepass")


@pytest.mark.parametrize("kind", ["readings", "positions", "tolerances", "isg", "etalon", "path points", "conditions"])
def test_made_tables_are_read_or_refused(kind, folder):
    @FEW
    @given(tables())
    def check(data):
        readers.judge(kind, data, folder)

    check()


@pytest.mark.parametrize("kind", ["machine", "mapping", "tolerances", "fcm", "manifest", "features"])
def test_made_json_is_read_or_refused(kind, folder):
    import json

    seed = json.loads(mutate.SEEDS[kind][-1])

    @FEW
    @given(st.dictionaries(st.sampled_from(sorted(seed)), JSON, max_size=3), st.booleans())
    def check(changes, keep):
        data = (seed if keep else {}) | changes
        readers.judge(kind, json.dumps(data).encode("utf-8", "surrogatepass"), folder)

    check()


WORD = st.one_of(
    st.sampled_from("G0 G1 G2 G3 G17 G18 G19 G20 G41 G42 G40 G43 G53 G54 G81 G91 G90 G80 G98 G28 M6 M30".split()),
    st.sampled_from("T1 D1 H1 F100 % / (x) O1 ;".split()),
    st.builds("{}{}".format, st.sampled_from("XYZIJKRFPQLABSNM"), st.one_of(st.integers(-50, 50), CELL)),
)


def test_made_programs_are_read_or_refused(folder):
    @FEW
    @given(st.lists(st.lists(WORD, max_size=6).map(" ".join), max_size=12), st.booleans())
    def check(blocks, placed):
        head = "G0 X0 Y0 Z5\nG1 F100 Z0\n" if placed else ""
        readers.judge("program", (head + "\n".join(blocks)).encode("utf-8", "surrogatepass"), folder)

    check()


@pytest.mark.parametrize("kind", KINDS)
def test_any_bytes_are_read_or_refused(kind, folder):
    @FEW
    @given(st.binary(max_size=200))
    def check(data):
        readers.judge(kind, data, folder)

    check()
