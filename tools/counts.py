# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts of what makes the next change touch many files: assumptions written out where a noun should be asked.

    python3 tools/counts.py [FOLDER | COMMIT]...        default: sensworkbench as it is

Every count is a number of source lines (circles: of modules in them).  They are heuristics: read them as a trend, and
list the places with --where NAME.
"""

from __future__ import annotations

import argparse
import ast
import re
import subprocess
import tarfile
import tempfile
from io import BytesIO
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SHAPES = {"linear", "polynomial", "periodic", "lag", "approach", "step", "power", "reversal", "hysteresis", "smooth",
          "random", "play", "table"}  # fmt: skip
LETTERS = {"XYZ", "xyz", "ABC", "ABC0", "XYZABC", "XYZABC0", "FXYZTW", "XYZTW"}
SQUARENESS = {"C0Y", "A0Z", "B0Z"}
READS = {"split", "partition", "rpartition", "startswith", "endswith", "removeprefix", "removesuffix", "index", "find",
         "fullmatch", "match", "search"}  # fmt: skip
FACTORS = {1e3, 1e6, 1e-3, 1e-6}


def strings(node) -> list[str]:
    """Return the string constants at or directly in a node (a tuple, list or set of them)."""
    items = node.elts if isinstance(node, (ast.Tuple, ast.List, ast.Set)) else [node]
    return [i.value for i in items if isinstance(i, ast.Constant) and isinstance(i.value, str)]


def words(text: str) -> bool:
    """Return whether a text is at least two words, i.e. a piece of a sentence and no key."""
    return bool(re.search(r"[a-z]{2,}[^a-z]* [a-z]|; |: ", text)) and "\\" not in text


def named(node) -> str:
    """Return the last name of what is called: `split` of `x.split("*")`."""
    function = getattr(node, "func", None)
    return getattr(function, "attr", getattr(function, "id", ""))


def places(path: Path):
    """Yield (count's name, line) of every place of one module."""
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text)
    documentation = {
        id(n.body[0].value) for n in ast.walk(tree)
        if isinstance(n, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(n) is not None
    }  # fmt: skip
    inside = {id(child) for f in ast.walk(tree) if isinstance(f, ast.FunctionDef)
              for child in ast.walk(f) if child is not f}  # fmt: skip
    for node in ast.walk(tree):
        if id(node) in documentation:
            continue
        line = getattr(node, "lineno", 0)
        if isinstance(node, (ast.Name, ast.Attribute)) and getattr(node, "id", getattr(node, "attr", "")) == "AXES":
            yield "three axes", line
        if isinstance(node, ast.Constant) and node.value in LETTERS | SQUARENESS:
            yield "three axes", line
        if isinstance(node, (ast.Tuple, ast.List)):
            found = strings(node)
            if len(found) >= 3 and re.search(r"(?i)([a-z_]*)x[a-z_]* \1y[a-z_]* \1z", " ".join(found)):
                yield "three axes", line
        if isinstance(node, ast.Call):
            numbers = [getattr(a, "value", None) for a in node.args]
            minus_one = [ast.unparse(a) for a in node.args[:1]] == ["-1"]
            three = numbers == [3] if named(node) == "range" else minus_one and numbers[1:] == [3]
            if three and named(node) in ("range", "reshape"):
                yield "three axes", line
            if named(node) in ("split", "partition", "join") and "*" in numbers[:1]:
                yield 'split("*")', line
            if named(node) in READS and any(isinstance(n, str) and words(n) for n in numbers):
                yield "sentences parsed", line
        if isinstance(node, ast.Compare):
            sides = [s for side in (node.left, *node.comparators) for s in strings(side)]
            if any(s in SHAPES for s in sides):
                yield "shape names compared", line
            if isinstance(node.ops[0], (ast.In, ast.NotIn)) and any(words(s) for s in strings(node.left)):
                yield "sentences parsed", line
        if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Mult, ast.Div)):
            if any(isinstance(s, ast.Constant) and s.value in FACTORS and isinstance(s.value, (int, float))
                   for s in (node.left, node.right)):  # fmt: skip
                yield "unit factors by hand", line
        if isinstance(node, ast.IfExp) and {getattr(node.body, "value", 0), getattr(node.orelse, "value", 0)} & FACTORS:
            yield "unit factors by hand", line
        if (
            isinstance(node, ast.ImportFrom)
            and id(node) in inside
            and (node.level or "sensworkbench" in (node.module or ""))
        ):
            yield "lazy imports", line
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
            if id(node) not in inside or isinstance(node, ast.ClassDef):
                if ast.get_docstring(node) is None:
                    yield "public, no docstring", line
        if isinstance(node, ast.Global):
            yield "global statements", line


def graph(folder: Path) -> dict[str, set[str]]:
    """Return module -> own modules that it imports, lazy ones counted."""
    files = {".".join(p.relative_to(folder.parent).with_suffix("").parts).removesuffix(".__init__"): p
             for p in folder.rglob("*.py")}  # fmt: skip
    found = {}
    for module, path in files.items():
        package = module if path.name == "__init__.py" else module.rpartition(".")[0]
        edges = set()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            targets = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            if isinstance(node, ast.ImportFrom):
                base = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
                base = ".".join([*base, *([node.module] if node.module else [])])
                targets = [f"{base}.{a.name}" for a in node.names]
            for target in targets:
                while target and target not in files:
                    target = target.rpartition(".")[0]
                if target and not f"{module}.".startswith(f"{target}."):
                    edges.add(target)
        found[module] = edges
    return found


def in_circles(edges: dict[str, set[str]]) -> int:
    """Return how many modules can reach themselves."""

    def reached(start):
        seen, left = set(), list(edges[start])
        while left:
            node = left.pop()
            if node not in seen:
                seen.add(node)
                left += edges[node]
        return seen

    return sum(module in reached(module) for module in edges)


def count(folder: Path) -> tuple[dict[str, int], dict[str, list[str]]]:
    """Return (counts, places of each) of a package."""
    where: dict[str, list[str]] = {}
    for path in sorted(folder.rglob("*.py")):
        for name, line in sorted(set(places(path))):
            where.setdefault(name, []).append(f"{path.relative_to(folder.parent)}:{line}")
    counts = {name: len(found) for name, found in sorted(where.items())}
    counts["modules in import circles"] = in_circles(graph(folder))
    texts = [p.read_text(encoding="utf-8") for p in folder.rglob("*.py")]
    counts["modules"] = len(texts)
    counts["lines"] = sum(t.count("\n") for t in texts)
    return counts, where


def package(what: str, folder: str) -> Path:
    """Return the package in a folder, or of a commit unpacked into `folder`."""
    if Path(what).is_dir():
        return Path(what).resolve()
    done = subprocess.run(["git", "archive", what, "sensworkbench"], cwd=ROOT, capture_output=True, check=True)
    with tarfile.open(fileobj=BytesIO(done.stdout)) as archive:
        archive.extractall(folder)
    return Path(folder) / "sensworkbench"


def main() -> None:
    parser = argparse.ArgumentParser(description="Count what makes the next change touch many files.")
    parser.add_argument("what", nargs="*", default=[str(ROOT / "sensworkbench")], help="folders or commits")
    parser.add_argument("--where", help="list the places of this count")
    given = parser.parse_args()
    columns = []
    for what in given.what:
        with tempfile.TemporaryDirectory() as folder:
            columns.append(count(package(what, folder)))
    if given.where:
        print("\n".join(columns[-1][1].get(given.where, [])))
        return
    for name in dict.fromkeys(n for counts, _ in columns for n in counts):
        print(f"{name:28}" + "".join(f"{counts.get(name, 0):10,d}" for counts, _ in columns))


if __name__ == "__main__":
    main()
