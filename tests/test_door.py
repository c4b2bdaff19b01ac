# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a newcomer is told to run exists: make targets, files and tests that pages, workflow and hooks name."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PAGES = ("CONTRIBUTING.md", "README.md", "docs/architecture.md", ".github/workflows/ci.yml", ".ci/run")
PAGES = [p for p in PAGES if (ROOT / p).exists()]


def text(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def targets() -> set[str]:
    return set(re.findall(r"^([a-z][\w-]*):", text("Makefile"), re.MULTILINE))


@pytest.mark.parametrize("page", PAGES)
def test_every_make_target_exists(page):
    named = set(re.findall(r"(?:`|run: |exec |^    )make ([a-z][\w-]*)", text(page), re.MULTILINE))
    assert named - targets() == set()
    assert named or page == "docs/architecture.md"


@pytest.mark.parametrize("page", PAGES)
def test_every_test_that_is_named_exists(page):
    for file, name in re.findall(r"(tests/[\w/]+\.py)(?:::(\w+))?", text(page)):
        assert (ROOT / file).is_file(), file
        if name:
            found = {n.name for n in ast.walk(ast.parse(text(file))) if isinstance(n, ast.FunctionDef)}
            assert name in found, f"{file}::{name}"


def test_the_workflow_runs_every_tier():
    tiers = {t for t in targets() if t.startswith("test-")} - {"test-matrix"}
    assert set(re.findall(r"run: make (test-[\w-]+)", text(".github/workflows/ci.yml"))) == tiers


def test_the_hooks_run_what_the_style_tier_runs():
    hooks = set(re.findall(r"entry: (ruff \w+)", text(".pre-commit-config.yaml")))
    style = text("Makefile").split("\ntest-style:")[1].split("\n\n")[0]
    assert hooks == set(re.findall(r"(ruff \w+)", style)) == {"ruff check", "ruff format"}


def test_the_portable_tests_exist():
    files = text("tests/portable.txt").split()
    assert files and all((ROOT / f).is_file() for f in files)


def test_every_package_that_the_tests_import_is_installed_with_them():
    listed = {re.split(r"[>=<]", line)[0].lower() for line in text("tests/requirements.txt").splitlines()}
    known = {"numpy", "scipy", "pytest", "hypothesis", "salib", "openturns"}
    used = set()
    for path in [*(ROOT / "tests").rglob("*.py"), *(ROOT / "benchmarks").rglob("*.py")]:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) and not node.level else []
            used |= {n.split(".")[0].lower() for n in names}
    assert known <= used and known <= listed and "matplotlib" in listed  # charts, by the package


def test_no_test_is_skipped():
    """Where something is missing, a test is not collected (tests/conftest.py): a skip looks like a test and is none."""
    skips = re.compile(r"pytest\.(skip|importorskip)\(|mark\.skip\b")
    found = [p for p in (ROOT / "tests").rglob("*.py") if skips.search(p.read_text(encoding="utf-8"))]
    assert found == []
