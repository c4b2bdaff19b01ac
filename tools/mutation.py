# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do the tests see?  Makes one small fault at a time in a layer of the package and counts how many the tests find.

    .venv/bin/python tools/mutation.py core                        every fault of tools/mutants.py in core
    .venv/bin/python tools/mutation.py closedloop --sample 300     a seeded sample
    .venv/bin/python tools/mutation.py core --module limits        one module

pytest collects the tests once.  They are run once with coverage, to learn which tests reach which line and how long
each takes; later only those files of tests are run again that changed, or that reach a module that changed.  Then for
every fault a copy of the process (fork) exchanges the code of the function that holds it, and runs the tests that
reach its line until one fails: first those that failed before in this module, then those of files that name the
module, the quickest first.  For a fault in the body of a module or class, or in a function that runs on import, the
copy imports everything again.

What is known is kept in build/mutation/LAYER.jsonl and is not tried again, so that a run can be stopped and continued.
A fault that was not found is tried again as soon as other tests reach it.  tools/equivalent_faults.txt lists faults
that change nothing, each with the reason; they are counted apart.  Works where fork does (Linux, macOS).
"""

from __future__ import annotations

import argparse
import ast
import gc
import hashlib
import importlib.util
import json
import os
import random
import signal
import sys
import time
import types
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")  # a copy of a process has no other threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import coverage
import hypothesis.internal.conjecture.engine as engine
import pytest
from mutants import Mutant, mutants_of, mutated

ROOT = Path(__file__).resolve().parents[1]
TESTS = {
    "core": ["tests/core", "tests/formats/test_machine_json.py", "tests/formats/test_tolerances.py",
             "tests/formats/test_gcode.py", "tests/formats/test_corrected.py",
             "tests/formats/test_effects_json.py", "tests/formats/test_machine_version_2.py",
             "tests/formats/test_shares_in_files.py", "tests/formats/test_allocation_files.py", "tests/studies",
             "tests/closedloop/test_shapes.py", "tests/closedloop/test_new_shape.py",
             "tests/closedloop/test_predict.py", "tests/closedloop/test_design.py"],
    "closedloop": ["tests/closedloop", "tests/studies"],
}  # fmt: skip
OPTIONS = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "--tb=no"]
EQUIVALENT = ROOT / "tools" / "equivalent_faults.txt"  # path, change, text of the line, reason: separated by tabs
UNTOUCHED = ("test_benchmarks", "_takes_its_text_apart", "compares_the_name_of_a_shape")  # they read source files


def main() -> int:
    """Run the tests of the layer against each fault; 0 when at least nine of ten are found."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("layer", choices=sorted(TESTS))
    parser.add_argument("--sample", type=int, help="so many faults, drawn with --seed (default: all)")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--minutes", type=float, default=1e9, help="stop after this time; a later run goes on")
    parser.add_argument("--seconds", type=float, default=4.0, help="of tests per fault")
    parser.add_argument("--longest", type=float, default=1e9, help="leave out tests that take longer, s")
    parser.add_argument("--module", help="only faults of modules of this name")
    parser.add_argument("--tell", action="store_true", help="print what is known and try nothing")
    arguments = parser.parse_args()
    engine.MAX_SHRINKS = 0  # a failing example need not be a small one
    os.chdir(ROOT)
    runner = Runner(arguments)
    if arguments.tell:
        runner.tell_known()
    else:
        pytest.main([*OPTIONS, *TESTS[arguments.layer]], plugins=[runner])
    return runner.status


class _Replaced:
    """Imports the changed module in place of the one on disk."""

    def __init__(self, path: str, tree):
        self.name = path.removesuffix(".py").replace("/", ".").removesuffix(".__init__")
        self.code = compile(tree, str(ROOT / path), "exec")

    def find_spec(self, name, path=None, target=None):
        """The changed module's own finder's specification, with its code exchanged."""
        if name != self.name:
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(name)
        spec.loader.exec_module = lambda module: exec(self.code, module.__dict__)
        return spec


class _Asked:
    """Runs tests of a runner in a pytest of its own."""

    def __init__(self, runner, tests):
        self.runner, self.tests, self.status = runner, tests, 0

    def pytest_runtestloop(self, session):
        """Runs in place of pytest's own loop."""
        self.runner.session, self.runner.items = session, session.items
        self.status = self.runner._run(self.tests)
        return True


class Runner:
    """The loop over the faults, inside pytest, whose collected tests it runs."""

    def __init__(self, arguments):
        self.arguments, self.status = arguments, 1
        self.folder = ROOT / "build" / "mutation"
        self.log = self.folder / f"{arguments.layer}.jsonl"
        self.killers: dict[str, int] = {}
        self.named: dict[str, set[str]] = {}

    def pytest_collection_finish(self, session):
        """Keep the collected tests."""
        self.items = [i for i in session.items if not any(word in i.nodeid for word in UNTOUCHED)]

    def pytest_runtestloop(self, session):
        """Runs in place of pytest's own loop."""
        self.session = session
        self.folder.mkdir(parents=True, exist_ok=True)
        self._learn()
        self._loop()
        return True

    # -- what the tests reach ----------------------------------------------------------------------------------------
    def _learn(self):
        """Lines that each test reaches and its duration, from a copy of this process under coverage; kept on disk."""
        kept = self.folder / f"{self.arguments.layer}-reach.json"
        files = sorted({i.nodeid.split("::")[0] for i in self.items})
        stamp = {f: _hash(f) for f in (*files, *(str(p.relative_to(ROOT)) for p in sorted(self._modules())))}
        known = json.loads(kept.read_text(encoding="utf-8")) if kept.exists() else {}
        was, reach = known.get("stamp", {}), known.get("reach", {})
        new = {f for f in stamp if was.get(f) != stamp[f]}
        changed = {f for f in files if f in new}
        for path in new - set(files):  # of a module: whoever reached it
            changed |= {t.split("::")[0] for tests in reach.get(path, {}).values() for t in tests}
        self.seconds = {t: s for t, s in known.get("seconds", {}).items() if t.split("::")[0] in set(files) - changed}
        self.reach = {
            path: {line: [t for t in tests if t in self.seconds] for line, tests in lines.items()}
            for path, lines in reach.items()
            if path not in new
        }
        items = [i for i in self.items if i.nodeid.split("::")[0] in changed]
        if items:
            self._trace(items)
            data = {"stamp": stamp, "seconds": self.seconds, "reach": self.reach}
            kept.write_text(json.dumps(data), encoding="utf-8")

    def _trace(self, items):
        started = time.monotonic()
        data_file = self.folder / f"{self.arguments.layer}.coverage"
        data_file.unlink(missing_ok=True)
        times = self.folder / f"{self.arguments.layer}-seconds.json"
        if _fork(lambda: self._traced(items, data_file, times), 3600)[0] != 0:
            raise SystemExit("the tests fail without any fault: nothing can be learned")
        seconds = json.loads(times.read_text(encoding="utf-8"))
        self.seconds |= seconds
        data = coverage.CoverageData(str(data_file))
        data.read()
        for file in data.measured_files():
            lines = self.reach.setdefault(str(Path(file).relative_to(ROOT)), {})
            for line, tests in data.contexts_by_lineno(file).items():
                lines[str(line)] = sorted(set(lines.get(str(line), [])) | {t for t in tests if t})
        print(f"learned what {len(items)} tests reach, {time.monotonic() - started:.0f} s", flush=True)

    def _modules(self):
        return (ROOT / "sensworkbench" / self.arguments.layer).rglob("*.py")

    def _traced(self, items, data_file, times) -> int:
        seconds, passed = {}, True
        tracer = coverage.Coverage(data_file=str(data_file), source=[str(ROOT / "sensworkbench")])
        tracer.start()
        for n, item in enumerate(items):
            tracer.switch_context(item.nodeid)
            started = time.process_time()
            good = self._passes(item, items[n + 1] if n + 1 < len(items) else None)
            if not good:
                print("fails without any fault:", item.nodeid, file=sys.stderr)
            passed &= good
            seconds[item.nodeid] = time.process_time() - started
        tracer.stop()
        tracer.save()
        times.write_text(json.dumps(seconds), encoding="utf-8")
        return 0 if passed else 1

    def _passes(self, item, following) -> bool:
        before = self.session.testsfailed
        item.ihook.pytest_runtest_protocol(item=item, nextitem=following)
        return self.session.testsfailed == before

    # -- the faults --------------------------------------------------------------------------------------------------
    def _loop(self):
        everything, known = self._everything(), self._known()
        end = time.monotonic() + 60 * self.arguments.minutes
        todo = [m for m in everything if _key(m) not in known or self._may_be_found(m, known[_key(m)])]
        random.Random(self.arguments.seed + 1).shuffle(todo)  # a run that is stopped has tried a fair part
        functions = _functions()
        with self.log.open("a", encoding="utf-8") as log:
            for mutant in todo:
                if time.monotonic() > end:
                    break
                entry = {"path": mutant.path, "number": mutant.number, "line": mutant.line, "what": mutant.what,
                         "text": _line(mutant)} | self._try(mutant, functions)  # fmt: skip
                known[_key(mutant)] = entry
                log.write(json.dumps(entry) + "\n")
                log.flush()
        self._tell([known[_key(m)] for m in everything if _key(m) in known], len(everything))

    def _everything(self) -> list[Mutant]:
        everything = []
        for path in sorted(self._modules()):
            if self.arguments.module in (None, path.stem):
                everything += mutants_of(str(path.relative_to(ROOT)), path.read_text(encoding="utf-8"))
        if self.arguments.sample and self.arguments.sample < len(everything):
            chosen = random.Random(self.arguments.seed).sample(everything, self.arguments.sample)
            everything = sorted(chosen, key=lambda m: (m.path, m.number))
        return everything

    def _may_be_found(self, mutant: Mutant, entry: dict) -> bool:
        """Whether tests that were not tried yet would be tried for a fault that was not found."""
        if entry["result"] not in ("survived", "not reached"):
            return False
        return bool(set(self._chosen(mutant)[0]) - set(entry.get("tests", [])))

    def tell_known(self):
        """Print what is known of the faults chosen."""
        everything, known = self._everything(), self._known()
        self._tell([known[_key(m)] for m in everything if _key(m) in known], len(everything))

    def _known(self) -> dict:
        """What was tried already, by path, line, text of the line and change; the last answer counts."""
        if not self.log.exists():
            return {}
        entries = [json.loads(line) for line in self.log.read_text(encoding="utf-8").splitlines()]
        return {(e["path"], e["number"], e["what"], e["text"]): e for e in entries}

    def _chosen(self, mutant: Mutant) -> tuple[list[str], float]:
        """(the tests for a fault, in their order, and the seconds they take)."""
        lines = self.reach.get(mutant.path, {})
        naming = self._naming(Path(mutant.path).stem)
        if mutant.function is None:  # a constant: whoever is about its module or reaches a line that names it
            tests = naming | (self._using(mutant) or {t for names in lines.values() for t in names})
        else:
            tests = set(lines.get(str(mutant.line), []))
        tests = sorted(t for t in tests if t in self.seconds and self.seconds[t] <= self.arguments.longest)
        tests.sort(key=lambda t: (-self.killers.get(mutant.path + t, 0), t not in naming, self.seconds[t]))
        chosen, total = [], 0.0
        for test in tests:
            if chosen and total + self.seconds[test] > self.arguments.seconds:
                continue
            chosen.append(test)
            total += self.seconds[test]
        return chosen, total

    def _try(self, mutant: Mutant, functions) -> dict:
        chosen, total = self._chosen(mutant)
        if not chosen:
            return {"result": "not reached"}
        afresh = mutant.function not in functions.get(mutant.path, {})
        work = self._afresh if afresh else self._in_copy
        code, killer = _fork(lambda: work(mutant, functions, chosen), 10 + 8 * total + 20 * afresh)
        if code == 0:
            return {"result": "survived", "tests": chosen, "seconds": round(total, 2)}
        if killer:
            self.killers[mutant.path + killer] = self.killers.get(mutant.path + killer, 0) + 1
        return {"result": "killed" if code == 1 else "timeout" if code is None else f"ended {code}", "by": killer}

    def _naming(self, module: str) -> set[str]:
        """The tests of files that name a module: they are about it, and may read a table of it and run no line."""
        if module not in self.named:
            files = {t.split("::")[0] for t in self.seconds}
            naming = {f for f in files if module in Path(f).read_text(encoding="utf-8")}
            self.named[module] = {t for t in self.seconds if t.split("::")[0] in naming}
        return self.named[module]

    def _using(self, mutant: Mutant) -> set[str]:
        """The tests that reach a line with a name that the changed statement defines."""
        names = _defined(mutant)
        found = set()
        for path in self._modules():
            lines = self.reach.get(str(path.relative_to(ROOT)), {})
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                word = getattr(node, "id", getattr(node, "attr", None))
                if word in names and isinstance(getattr(node, "ctx", None), ast.Load):
                    found.update(lines.get(str(node.lineno), []))
        return found

    def _in_copy(self, mutant: Mutant, functions, tests) -> int:
        source = Path(mutant.path).read_text(encoding="utf-8")
        code = compile(mutated(mutant.path, source, mutant.number), str(ROOT / mutant.path), "exec")
        new = _code_of(code, mutant.function)
        for function in functions[mutant.path][mutant.function]:
            function.__code__ = new
        return self._run(tests)

    def _run(self, tests) -> int:
        """Run these in order; tells the first that fails on the pipe.  0: all pass, 1: one failed."""
        by_name = {i.nodeid: i for i in self.items}
        items = [by_name[t] for t in tests if t in by_name]
        for n, item in enumerate(items):
            if not self._passes(item, items[n + 1] if n + 1 < len(items) else None):
                tell(item.nodeid)
                return 1
        return 0

    def _afresh(self, mutant: Mutant, functions, tests) -> int:
        """Import everything again, with the changed module in place of its own."""
        tree = mutated(mutant.path, Path(mutant.path).read_text(encoding="utf-8"), mutant.number)
        for name in [n for n in sys.modules if n.split(".")[0] in ("sensworkbench", "tests", "conftest")]:
            del sys.modules[name]
        sys.meta_path.insert(0, _Replaced(mutant.path, tree))
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 2)
        asked = _Asked(self, tests)
        return max(
            int(pytest.main([*OPTIONS, *dict.fromkeys(t.split("::")[0] for t in tests)], plugins=[asked])), asked.status
        )

    def _tell(self, entries, of):
        count = {}
        for e in entries:
            count[e["result"]] = count.get(e["result"], 0) + 1
        alive = [e for e in entries if e["result"] in ("survived", "not reached")]
        reasons = _equivalents()
        same = [e for e in alive if (e["path"], e["what"], e["text"]) in reasons]
        alive = [e for e in alive if e not in same]
        by_module: dict[str, list[int]] = {}
        for e in entries:
            row = by_module.setdefault(e["path"], [0, 0, 0])
            row[0] += 1
            row[1] += e in alive
            row[2] += e in same
        for path, (n, left, equal) in sorted(by_module.items()):
            share = 100 * (1 - left / max(1, n - equal))
            print(f"{path:50} {n:5} tried {n - left - equal:5} found {equal:4} change nothing {share:6.1f} %")
        for e in alive:
            print(f"alive: {e['path']}:{e['line']}: {e['what']}: {e['text']}")
        n, found = len(entries), len(entries) - len(alive) - len(same)
        print(f"{n} of {of} faults tried: {count}")
        print(f"found {found} of all {n}: {_share(found, n)}")
        print(f"found {found} of {n - len(same)} that change something: {_share(found, n - len(same))}")
        self.status = 0 if found >= 0.9 * (n - len(same)) else 1


def _share(found: int, n: int) -> str:
    """The share with the 95 % interval of Wilson for a sample."""
    if not n:
        return "none"
    p, z = found / n, 1.96
    middle, half = p + z * z / (2 * n), z * (p * (1 - p) / n + z * z / (4 * n * n)) ** 0.5
    low, high = ((middle - half) / (1 + z * z / n), (middle + half) / (1 + z * z / n))
    return f"{100 * p:.1f} % ({100 * low:.1f} to {100 * high:.1f})"


def _equivalents() -> dict[tuple[str, str, str], str]:
    """(path, change, text of the line) -> why it changes nothing."""
    if not EQUIVALENT.exists():
        return {}
    rows = [line.split("\t") for line in EQUIVALENT.read_text(encoding="utf-8").splitlines() if "\t" in line]
    return {tuple(row[:3]): row[3] for row in rows}


def _hash(path: str) -> str:
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def _defined(mutant: Mutant) -> set[str]:
    """The names that the statement of a module or class defines in which a change is."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(Path(mutant.path).read_text(encoding="utf-8"))):
        if isinstance(node, (ast.Assign, ast.AnnAssign)) and node.lineno <= mutant.line <= node.end_lineno:
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            found = {n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)} or found
        elif isinstance(node, ast.FunctionDef) and node.lineno <= mutant.line < node.body[0].lineno:
            found = {node.name}  # a default
    return found


def _key(m: Mutant):
    return m.path, m.number, m.what, _line(m)


_SOURCES: dict[str, list[str]] = {}


def _line(m: Mutant) -> str:
    if m.path not in _SOURCES:
        _SOURCES[m.path] = Path(m.path).read_text(encoding="utf-8").splitlines()
    return _SOURCES[m.path][m.line - 1].strip()


def _functions() -> dict[str, dict[tuple[str, int], list]]:
    """path -> (qualified name, first line) -> the functions of that code that exist."""
    found: dict[str, dict] = {}
    prefix = str(ROOT) + os.sep
    for thing in gc.get_objects():
        if isinstance(thing, types.FunctionType) and thing.__code__.co_filename.startswith(prefix + "sensworkbench"):
            path = thing.__code__.co_filename.removeprefix(prefix)
            key = (thing.__qualname__, thing.__code__.co_firstlineno)
            found.setdefault(path, {}).setdefault(key, []).append(thing)
    return found


def _code_of(code, wanted: tuple[str, int]):
    """The code object of a function (qualified name, first line) inside that of its module."""
    for part in code.co_consts:
        if isinstance(part, types.CodeType):
            if part.co_firstlineno == wanted[1] and part.co_name == wanted[0].rsplit(".", 1)[-1]:
                return part
            found = _code_of(part, wanted)
            if found:
                return found
    return None


# -- processes -------------------------------------------------------------------------------------------------------
_PIPE: list[int] = []


def tell(text: str):
    """Say the name of the test that failed to the process that waits."""
    for pipe in _PIPE:
        os.write(pipe, text.encode()[:2000])


def _fork(work, limit: float) -> tuple[int | None, str]:
    """(status of `work` in a copy of this process, what it told); None where it took longer than `limit` s of CPU."""
    back, forth = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(back)
        _PIPE[:] = [forth]
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        for number in (signal.SIGALRM, signal.SIGPROF):
            signal.signal(number, signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_PROF, limit)  # of this processor: a busy computer is no fault
        signal.alarm(int(10 * limit) + 1)
        status = 3
        try:
            status = work()
        finally:
            os._exit(status)
    os.close(forth)
    told = b""
    while part := os.read(back, 2000):
        told += part
    os.close(back)
    _, state = os.waitpid(child, 0)
    if os.WIFSIGNALED(state):
        return (None if os.WTERMSIG(state) in (signal.SIGALRM, signal.SIGPROF) else 2), told.decode()
    return os.WEXITSTATUS(state), told.decode()


if __name__ == "__main__":
    sys.exit(main())
