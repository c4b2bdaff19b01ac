# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rules of the house, held by reading the source: who may import whom, and what no module does.

Each rule is a function from a module's text to its findings; `test_every_rule_can_find_something` shows that it bites.
"""

from __future__ import annotations

import ast
import io
import re
import subprocess
import sys
import textwrap
import tokenize
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "sensworkbench"
LAYERS = ("gui", "document", "formats", "studies", "closedloop", "core", "messages")  # imports point to the right
FREECAD = {
    "FreeCAD",
    "FreeCADGui",
    "Part",
    "Mesh",
    "Points",
    "Import",
    "ImportGui",
    "TechDraw",
    "Spreadsheet",
    "Sketcher",
}
WINDOW = {"FreeCADGui", "ImportGui", "PySide", "pivy"}
EXTRAS = {"distributed"}  # `pip install sensworkbench[cluster]`: the command line may use it where it is
OUTSIDE = {"numpy", "matplotlib", "scipy", "PIL", "PySide", "pivy"} | FREECAD
OPTIONAL = {"matplotlib", "scipy", "PIL"}  # come with FreeCAD, may be missing under plain Python
FORBIDDEN = {
    "messages": FREECAD | WINDOW | OPTIONAL | {"numpy"},
    "core": FREECAD | WINDOW | OPTIONAL,
    "closedloop": FREECAD | WINDOW | OPTIONAL,
    "studies": FREECAD | WINDOW | {"matplotlib"},
    "formats": FREECAD | WINDOW,
    "cli": WINDOW,
    "document": WINDOW,
    "gui": set(),
}
MAX_FUNCTION = 80  # lines; a module may be as long as its subject, a function is read at one look
# layers whose public functions say what they return or do
DOCUMENTED = (*LAYERS, "cli")
# called by FreeCAD, Qt or Python under these names; every name like `paintEvent` is one of Qt's
CALLED_BY_NAME = {
    "execute",
    "dumps",
    "loads",
    "attach",
    "accept",
    "reject",
    "data",
    "flags",
    "paint",
    "get_field",
    "format_field",
}

MODULES = sorted(PACKAGE.rglob("*.py"))
STARTERS = [p for p in (ROOT / "Init.py", ROOT / "InitGui.py") if p.exists()]  # exec'd by FreeCAD
SOURCES = sorted(
    p
    for folder in ("sensworkbench", "tests", "benchmarks", "docs", "resources", "freecad")
    for p in (ROOT / folder).rglob("*.py")
) + sorted(ROOT.glob("*.py"))


def name(path: Path) -> str:
    return str(path.relative_to(ROOT))


def layer_of(path: Path) -> str | None:
    parts = path.relative_to(PACKAGE).parts
    return parts[0] if len(parts) > 1 else None


@cache
def parsed(text: str) -> ast.Module:
    return ast.parse(text)


@cache
def nodes(text: str) -> tuple[ast.AST, ...]:
    return tuple(ast.walk(parsed(text)))


# -- what is imported -----------------------------------------------------------------------------------------------
@cache
def imported(text: str, package: str) -> tuple:
    """Return (absolute dotted name, line, guarded) of every import, also those inside functions.

    guarded : inside a function, a try, or `if TYPE_CHECKING`.  `from . import x` yields the package of x and x.
    """

    def visit(node, guarded):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield alias.name, node.lineno, guarded
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                outer = package.split(".")[: len(package.split(".")) - node.level + 1]
                base = ".".join(outer + ([base] if base else []))
            for alias in node.names:
                yield f"{base}.{alias.name}", node.lineno, guarded
        elif isinstance(node, ast.Call) and ast.unparse(node.func).endswith(("import_module", "__import__")):
            if node.args and isinstance(node.args[0], ast.Constant):
                yield str(node.args[0].value), node.lineno, guarded
        inner = guarded or isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.Try))
        inner = inner or (isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test))
        for child in ast.iter_child_nodes(node):
            yield from visit(child, inner)

    return tuple(visit(parsed(text), False))


def package_of(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).parent.parts)


def upward_imports(text: str, package: str):
    """Imports of a layer to the left: formats that import the document, and the like."""
    layer = package.split(".")[1] if "." in package else None
    for target, line, _ in imported(text, package):
        parts = target.split(".")
        if parts[0] == "sensworkbench" and layer in LAYERS and len(parts) > 1:
            if parts[1] in ("cli", "__main__"):
                yield line, f"{layer} imports the command line"
            elif parts[1] in LAYERS and LAYERS.index(parts[1]) < LAYERS.index(layer):
                yield line, f"{layer} imports {parts[1]}"


def document_at_start(text: str, package: str):
    """The command line loads the document only where a verb was given one: FreeCAD may be missing."""
    for target, line, guarded in imported(text, package):
        if package.startswith("sensworkbench.cli") and target.startswith("sensworkbench.document") and not guarded:
            yield line, "the command line imports the document when it starts"


def forbidden_imports(text: str, package: str):
    layer = package.split(".")[1] if "." in package else None
    for target, line, _ in imported(text, package):
        if target.split(".")[0] in FORBIDDEN.get(layer, set()):
            yield line, f"{layer} imports {target}"


def unknown_imports(text: str, package: str):
    """What a user of FreeCAD does not have: anything but the standard library, numpy and FreeCAD's own."""
    for target, line, guarded in imported(text, package):
        top = target.split(".")[0]
        if top in EXTRAS and guarded and package == "sensworkbench.cli":
            continue
        if top in OPTIONAL and not guarded:
            yield line, f"{top} is imported where it may be missing"
        if top != "sensworkbench" and top not in OUTSIDE and top not in sys.stdlib_module_names:
            yield line, f"{top} is not there at run time"


def qt_of_one_version(text: str, package: str):
    for target, line, _ in imported(text, package):
        if re.match(r"(PySide[26]|PyQt\d|shiboken\d)\b", target):
            yield line, f"{target} binds to one version of Qt; FreeCAD's PySide is both"


# -- what is done ---------------------------------------------------------------------------------------------------
def called(node) -> str:
    return ast.unparse(node.func) if isinstance(node, ast.Call) else ""


def prints(text: str, package: str):
    for node in nodes(text):
        if called(node) == "print":
            yield node.lineno, "print in the library"


def bare_excepts(text: str, package: str):
    for node in nodes(text):
        if isinstance(node, ast.ExceptHandler) and node.type is None:
            yield node.lineno, "bare except"


def dangerous_calls(text: str, package: str):
    for node in nodes(text):
        if called(node) in ("eval", "exec", "pickle.load", "pickle.loads", "marshal.loads", "os.system"):
            yield node.lineno, called(node)
        if called(node) in ("np.load", "numpy.load") and any(
            k.arg == "allow_pickle" and getattr(k.value, "value", True) for k in node.keywords
        ):
            yield node.lineno, "np.load with pickles"
    for target, line, _ in imported(text, package):
        if target.split(".")[0] in ("pickle", "shelve", "marshal"):
            yield line, target


def version_comparisons(text: str, package: str):
    """Probe for the capability instead."""
    pattern = re.compile(r"\b(__version__|version_info|hexversion)\b|\bVersion\(|\bqVersion\(|\bversion\.parse\(")
    for node in nodes(text):
        if isinstance(node, ast.Compare) and pattern.search(ast.unparse(node)):
            yield node.lineno, ast.unparse(node)
    for target, line, _ in imported(text, package):
        if target.startswith(("packaging", "pkg_resources", "distutils")):
            yield line, target


def unfinished(text: str, package: str):
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and re.search(r"\b(TODO|FIXME|HACK)\b", token.string):
            yield token.start[0], token.string


def undocumented(text: str, package: str):
    tree = parsed(text)
    if tree.body and not ast.get_docstring(tree):
        yield 1, "no module docstring"


def postponed_annotations(text: str, package: str):
    defines = any(isinstance(n, (ast.FunctionDef, ast.AnnAssign)) for n in nodes(text))
    if defines and not any(t == "__future__.annotations" for t, _, _ in imported(text, package)):
        yield 1, "from __future__ import annotations is missing"


def long_functions(text: str, package: str):
    for node in nodes(text):
        if isinstance(node, ast.FunctionDef):
            words = node.body[0].end_lineno - node.body[0].lineno + 1 if ast.get_docstring(node) else 0
            lines = node.end_lineno - node.lineno + 1 - words
            if lines > MAX_FUNCTION:
                yield node.lineno, f"{node.name}: {lines} lines, its docstring apart"


def stray_thresholds(text: str, package: str):
    """A fraction that something is compared with, and a named number that decides: a setting, with unit and reason.

    What is 1e-6 or less is what rounding leaves.
    """

    def fractions(node):
        if isinstance(node, ast.Constant) and isinstance(node.value, float):
            return [node.value] if 1e-6 < abs(node.value) and node.value != 1.0 else []
        parts = {ast.UnaryOp: ("operand",), ast.BinOp: ("left", "right")}.get(type(node), ())
        return [v for part in parts for v in fractions(getattr(node, part))]

    named = {
        node.targets[0].id
        for node in parsed(text).body
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and fractions(node.value)
    }
    for node in nodes(text):
        if isinstance(node, ast.Compare):
            for operand in (node.left, *node.comparators):
                names = {n.id for n in ast.walk(operand) if isinstance(n, ast.Name)} & named
                if fractions(operand) or names:
                    yield node.lineno, ast.unparse(node)


def without_licence(text: str, package: str):
    if text and text.split("\n", 1)[0] != "# SPDX-License-Identifier: LGPL-2.1-or-later":
        yield 1, "the first line is not the licence"


RULES = {  # rule: a text that breaks it
    upward_imports: "from ..document import factory",
    forbidden_imports: "def f():\n    import FreeCAD",
    unknown_imports: "import pandas",
    qt_of_one_version: "try:\n    from PySide6 import QtCore\nexcept ImportError:\n    pass",
    prints: "print('x')",
    bare_excepts: "try:\n    f()\nexcept:\n    pass",
    dangerous_calls: "x = eval('1')",
    version_comparisons: "if FreeCAD.Version()[0] > '0':\n    pass",
    unfinished: "x = 1  # TODO",
    undocumented: "x = 1",
    postponed_annotations: "def f(x):\n    return x",
    long_functions: "def f():\n" + "    x = 1\n" * MAX_FUNCTION,
    without_licence: '"""A module."""\n',
    stray_thresholds: "ok = size > 0.3 * floor",
}
MORE_BREACHES = [
    (upward_imports, "from sensworkbench.gui import colours"),
    (upward_imports, "from .. import document"),
    (upward_imports, "import sensworkbench.cli"),
    (forbidden_imports, "import importlib\nimportlib.import_module('pivy.coin')"),
    (forbidden_imports, "from PySide import QtGui"),
    (unknown_imports, "import matplotlib.pyplot as plt"),
    (stray_thresholds, "LIMIT = 5.0\ndef f(z):\n    return abs(z) < LIMIT"),
    (stray_thresholds, "ok = score < -2.33"),
    (dangerous_calls, "import pickle"),
    (dangerous_calls, "np.load(f, allow_pickle=True)"),
    (version_comparisons, "ok = np.__version__ >= '2'"),
    (version_comparisons, "import sys\nok = sys.version_info > (3, 11)"),
    (version_comparisons, "from packaging import version"),
]
HARMLESS = [
    (long_functions, 'def f():\n    """' + "a\n" * 90 + '"""\n    return 1'),
    (upward_imports, "from ..core import sobol\nfrom . import files"),
    (unknown_imports, "import json\nimport numpy as np\ndef f():\n    import matplotlib"),
    (prints, "x.print()\n'print(1)'"),
    (version_comparisons, "text = FreeCAD.Version()\nok = hasattr(x, 'y')"),
    (dangerous_calls, "np.load(f, allow_pickle=False)"),
    (postponed_annotations, "x = 1"),
    (stray_thresholds, "ok = size > settings.floor and values > 1e-9 * values[-1] and count < 3 and x != 0.0"),
]


@pytest.mark.parametrize("rule, text", [*RULES.items(), *MORE_BREACHES], ids=lambda v: getattr(v, "__name__", None))
def test_every_rule_can_find_something(rule, text):
    assert list(rule(text, "sensworkbench.formats"))


@pytest.mark.parametrize("rule, text", HARMLESS, ids=lambda v: getattr(v, "__name__", None))
def test_rules_let_the_harmless_pass(rule, text):
    assert not list(rule(text, "sensworkbench.formats"))


def findings(rules, paths):
    return [
        f"{name(path)}:{line}: {what}"
        for path in paths
        for rule in rules
        for line, what in rule(path.read_text(encoding="utf-8"), package_of(path))
    ]


def test_every_folder_of_the_package_has_its_place_among_the_layers():
    assert {layer_of(p) for p in MODULES} - {None, *LAYERS, "cli"} == set()


@pytest.mark.parametrize(
    "rule", [r for r in RULES if r not in (prints, without_licence, stray_thresholds)], ids=lambda r: r.__name__
)
def test_modules_keep_the_rule(rule):
    assert findings([rule], MODULES) == []


def test_the_thresholds_of_a_trace_are_its_settings():
    elsewhere = ("settings.py", "prior.py")  # where they are declared, each with its reason
    paths = [p for p in MODULES if layer_of(p) == "closedloop" and p.name not in elsewhere]
    assert len(paths) > 20
    numerical = ("b.condition <= REFINED",)  # which of two equal solutions is computed
    assert [f for f in findings([stray_thresholds], paths) if not f.endswith(numerical)] == []


def test_only_the_command_line_prints():
    assert findings([prints], [p for p in MODULES if layer_of(p) != "cli"]) == []


def test_files_that_freecad_executes_keep_the_rules_too():
    rules = (unknown_imports, qt_of_one_version, bare_excepts, dangerous_calls, version_comparisons, prints)
    assert findings(rules, STARTERS) == []


def test_every_source_file_names_its_licence():
    assert SOURCES and findings([without_licence], SOURCES) == []


def test_tests_and_benchmarks_have_no_bare_except():
    assert findings([bare_excepts], [p for p in SOURCES if p not in MODULES]) == []


def test_the_command_line_starts_without_the_document():
    verb = "from ..document import factory\ndef run(args):\n    from ..document import batch"
    assert [line for line, _ in document_at_start(verb, "sensworkbench.cli")] == [1]
    assert findings([document_at_start], MODULES) == []


# -- what is said ----------------------------------------------------------------------------------------------------
def public(tree):
    """Yield (node, class or None) of the public functions, classes and methods of a module."""
    for node in tree.body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
            yield node, None
            if isinstance(node, ast.ClassDef):
                for method in node.body:
                    if isinstance(method, ast.FunctionDef) and not method.name.startswith("_"):
                        yield method, node


def silent(texts: dict[str, str]) -> list[str]:
    """Public functions, classes and methods without a docstring: "where:line name".

    A method needs none where a base class, found by its name, says what it does, where FreeCAD or Qt calls it, or where
    it sets a property whose getter says it; nor does a command, whose `tip` says it, or a verb's `add` and `run`, which
    `cli.verbs` describes.
    """
    bases, told = {}, set()
    for text in texts.values():
        for node, owner in public_and_private(parsed(text)):
            if isinstance(node, ast.ClassDef):
                bases.setdefault(node.name, set()).update(
                    ast.unparse(b).split(".")[-1].split("[")[0] for b in node.bases
                )
            elif ast.get_docstring(node):
                told.add((owner, node.name))

    def inherited(name, method, seen=()):
        return any(
            (base, method) in told or (base not in seen and inherited(base, method, (*seen, base)))
            for base in bases.get(name, ())
        )

    found = []
    for where, text in texts.items():
        for node, owner in public(parsed(text)):
            excused = owner is not None and (
                node.name in CALLED_BY_NAME
                or re.search(r"[a-z][A-Z]|^[A-Z]", node.name)
                or any(ast.unparse(d).endswith((".setter", "overload")) for d in node.decorator_list)
                or inherited(owner.name, node.name)
            )
            excused = excused or ("/verbs/" in where and node.name in ("add", "run"))
            excused = excused or any(
                isinstance(n, ast.Assign) and ast.unparse(n.targets[0]) == "tip" for n in node.body
            )
            if not ast.get_docstring(node) and not excused:
                found.append(f"{where}:{node.lineno} {node.name}")
    return found


def public_and_private(tree):
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            yield node, None
            yield from ((m, node.name) for m in node.body if isinstance(m, ast.FunctionDef))


def test_a_missing_docstring_is_found_and_an_inherited_one_counts():
    base = 'class Shape:\n    """A shape."""\n    def basis(self):\n        """Return columns."""\n'
    child = 'class Step(Shape):\n    """A step."""\n    def basis(self):\n        pass\n'
    child += "    def paintEvent(self, event):\n        pass\n"
    assert silent({"a": base, "b": child}) == []
    assert silent({"b": child}) == ["b:3 basis"]
    assert silent({"c": "def f():\n    return 1\ndef _g():\n    return 2"}) == ["c:1 f"]


@pytest.mark.parametrize("layer", DOCUMENTED)
def test_public_functions_say_what_they_return_or_do(layer):
    texts = {name(p): p.read_text(encoding="utf-8") for p in MODULES}
    assert [line for line in silent(texts) if line.startswith(f"sensworkbench/{layer}/")] == []


# -- names of other modules ------------------------------------------------------------------------------------------
def defined(tree) -> set[str]:
    """Every name that a module binds at its top, in whatever branch, or declares global."""
    found = set()

    def bind(target):
        found.update(n.id for n in ast.walk(target) if isinstance(n, ast.Name))

    def visit(body):
        for node in body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                found.add(node.name)
            elif isinstance(node, (ast.Import, ast.ImportFrom)):
                found.update((a.asname or a.name).split(".")[0] for a in node.names)
            elif isinstance(node, (ast.Assign, ast.AnnAssign, ast.AugAssign)):
                for target in getattr(node, "targets", [getattr(node, "target", None)]):
                    bind(target)
            elif isinstance(node, (ast.For, ast.With)):
                for target in [getattr(node, "target", None), *(i.optional_vars for i in getattr(node, "items", ()))]:
                    if target is not None:
                        bind(target)
            for part in ("body", "orelse", "finalbody"):
                if not isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                    visit(getattr(node, part, None) or [])
            for handler in getattr(node, "handlers", ()):
                visit(handler.body)

    visit(tree.body)
    return found | {name for n in ast.walk(tree) if isinstance(n, ast.Global) for name in n.names}


def absent(texts: dict[str, tuple[str, str]], top: str) -> list[str]:
    """Names taken from modules of `top` that these do not have: "module:line module.name".

    texts : as in `import_graph`.  Sees `from .module import name`, and `module.name` where that module was imported.
    """
    names = {module: defined(parsed(text)) for module, (_, text) in texts.items()}
    lazy = {module for module, known in names.items() if "__getattr__" in known}

    def there(module, name):
        return name in names[module] or f"{module}.{name}" in texts or module in lazy or re.fullmatch("__.*__", name)

    found = []
    for module, (package, text) in texts.items():
        aliases = {}
        for node in nodes(text):
            if not isinstance(node, ast.ImportFrom):
                continue
            outer = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
            base = ".".join([*outer, *([node.module] if node.module else [])])
            for alias in node.names:
                if f"{base}.{alias.name}" in texts:
                    aliases[alias.asname or alias.name] = f"{base}.{alias.name}"
                elif base.split(".")[0] == top and (base not in texts or not there(base, alias.name)):
                    found.append(f"{module}:{node.lineno} {base}.{alias.name}")
        rebound = {n.id for n in nodes(text) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
        rebound |= {a.arg for n in nodes(text) if isinstance(n, ast.arguments) for a in n.args + n.kwonlyargs}
        for node in nodes(text):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id not in rebound:
                target = aliases.get(node.value.id)
                if target and target.split(".")[0] == top and not there(target, node.attr):
                    found.append(f"{module}:{node.lineno} {target}.{node.attr}")
    return found


def test_a_name_that_a_module_does_not_have_is_found():
    texts = {
        "p": ("p", ""),
        "p.a": ("p", "def f():\n    pass\nif x:\n    y = 1"),
        "p.b": ("p", "from . import a\nfrom .a import f, y\na.f()\na.g()"),
        "p.c": ("p", "from .a import h\nfrom .gone import k\ndef f(a):\n    a.anything"),
    }
    assert absent(texts, "p") == ["p.b:4 p.a.g", "p.c:1 p.a.h", "p.c:2 p.gone.k"]


def test_what_is_taken_from_a_module_is_there():
    """Also inside functions, and where only FreeCAD could run the module."""
    apart = (ROOT / "tests", ROOT / "benchmarks")
    paths = [*MODULES, *(p for p in SOURCES if any(p.is_relative_to(folder) for folder in apart))]
    texts = {module_of(p): (package_of(p), p.read_text(encoding="utf-8")) for p in paths}
    assert absent(texts, "sensworkbench") == []


# -- circles ----------------------------------------------------------------------------------------------------------
CIRCLES_LEFT = ()  # where some are still left: take a name out when its circle is gone


def module_of(path: Path) -> str:
    dotted = ".".join(path.relative_to(ROOT).with_suffix("").parts)
    return dotted.removesuffix(".__init__")


def import_graph(texts: dict[str, tuple[str, str]]) -> dict[str, set[str]]:
    """module -> own modules that it imports, at its top or inside functions.  texts : module -> (package, source).

    A package that a module lies in is loaded with it, so it is no edge of its own; `from . import x` means x.
    """
    graph = {}
    for module, (package, text) in texts.items():
        found = set()
        for target, _, _ in imported(text, package):
            while target and target not in texts:
                target = target.rpartition(".")[0]
            if target and not f"{module}.".startswith(f"{target}."):
                found.add(target)
        graph[module] = found
    return graph


def circles(graph: dict[str, set[str]]) -> list[list[str]]:
    """Groups of modules each of which leads to all the others, sorted (Tarjan 1972)."""
    number, low, stack, found = {}, {}, [], []

    def visit(node):
        number[node] = low[node] = len(number)
        stack.append(node)
        for other in sorted(graph[node]):
            if other not in number:
                visit(other)
            if other in stack:
                low[node] = min(low[node], low[other])
        if low[node] == number[node]:
            group = stack[stack.index(node) :]
            del stack[stack.index(node) :]
            if len(group) > 1:
                found.append(sorted(group))

    for node in sorted(graph):
        if node not in number:
            visit(node)
    return sorted(found)


def test_circles_are_found_also_through_functions():
    texts = {
        "p": ("p", ""),
        "p.a": ("p", "from . import b"),
        "p.b": ("p", "def f():\n    from .c import x"),
        "p.c": ("p", "import p.a"),
        "p.d": ("p", "from .a import y\nfrom . import d"),
    }
    assert circles(import_graph(texts)) == [["p.a", "p.b", "p.c"]]
    assert circles(import_graph(texts | {"p.c": ("p", "import numpy")})) == []


def test_no_module_imports_itself_through_others():
    texts = {module_of(p): (package_of(p), p.read_text(encoding="utf-8")) for p in MODULES}
    left = [c for c in circles(import_graph(texts)) if {m.split(".")[1] for m in c} - set(CIRCLES_LEFT)]
    assert left == []


def test_a_layer_that_is_free_of_circles_is_no_longer_excused():
    texts = {module_of(p): (package_of(p), p.read_text(encoding="utf-8")) for p in MODULES}
    still = {m.split(".")[1] for c in circles(import_graph(texts)) for m in c}
    assert set(CIRCLES_LEFT) == still


# -- without FreeCAD ------------------------------------------------------------------------------------------------
BLOCKER = """
    import importlib, importlib.abc, pkgutil, sys
    BLOCKED = {blocked!r}

    class Block(importlib.abc.MetaPathFinder):
        def find_spec(self, fullname, path=None, target=None):
            if fullname.split(".")[0] in BLOCKED:
                raise ImportError(fullname + " cannot be imported here")
            return None

    sys.meta_path.insert(0, Block())
    try:
        import FreeCAD
    except ImportError:
        pass
    else:
        sys.exit("FreeCAD was not blocked")
    import sensworkbench
    for layer in {layers!r}:
        package = importlib.import_module("sensworkbench." + layer)
        for module in pkgutil.walk_packages(package.__path__, package.__name__ + "."):
            importlib.import_module(module.name)
    loaded = sorted(m for m in sys.modules if m.split(".")[0] in BLOCKED)
    assert not loaded, loaded
"""
RUN = """
    import json
    from sensworkbench.core import workspace
    from sensworkbench.core.joints import linear
    from sensworkbench.core.machine import Machine
    axes = {{k: linear(k, d, (0, 0, 0), (0, 100)) for k, d in zip("XYZ", ((1, 0, 0), (0, 1, 0), (0, 0, 1)))}}
    machine = Machine("m", ("Y", "X"), ("Z",), axes, (0, 0, -150))
    result = workspace.sensitivity(machine)
    print(json.dumps({{s: t for s, t in zip(result.symbols, result.total)}}))
"""


def run_blocked(code: str, blocked, layers) -> subprocess.CompletedProcess:
    text = textwrap.dedent(code).format(blocked=blocked, layers=layers)
    return subprocess.run(
        [sys.executable, "-c", text], cwd=ROOT, capture_output=True, text=True, timeout=120, check=False
    )


def test_core_closedloop_and_formats_import_and_run_where_freecad_cannot_be_imported():
    blocked = sorted(FREECAD | WINDOW | {"PySide2", "PySide6", "shiboken6"})
    layers = ("core", "closedloop", "studies", "formats")
    done = run_blocked(textwrap.dedent(BLOCKER) + textwrap.dedent(RUN), blocked, layers)
    assert done.returncode == 0, done.stderr
    assert '"EAX": 0.' in done.stdout


def test_core_and_closedloop_need_numpy_alone():
    blocked = sorted(FREECAD | WINDOW | OPTIONAL | {"PySide2", "PySide6"})
    done = run_blocked(textwrap.dedent(BLOCKER) + textwrap.dedent(RUN), blocked, ("core", "closedloop", "studies"))
    assert done.returncode == 0, done.stderr
    assert '"EAX": 0.' in done.stdout
