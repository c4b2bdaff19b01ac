# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do the tests see?  Makes one small fault at a time in a layer of the package and counts how many the tests find.

    .venv/bin/python tools/mutation.py core                        every fault of tools/mutants.py in core
    .venv/bin/python tools/mutation.py closedloop --sample 300     a seeded sample

pytest collects the tests once.  They are run once with coverage, to learn which tests reach which line and how long
each takes.  Then for every fault a copy of the process (fork) exchanges the code of the function that holds it, and
runs the tests that reach its line, the quickest first, until one fails.  A fault in the body of a module or class, or
in a function that runs on import, is tried in a process that imports everything again.  What is known is kept in
build/mutation/LAYER.jsonl and is not tried again, so that a run can be stopped and continued; `--again` tries the
survivors once more, with more time.  Works where fork does (Linux, macOS).
"""

from __future__ import annotations

import argparse
import gc
import importlib.util
import json
import os
import random
import signal
import subprocess
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
             "tests/formats/test_effects_json.py", "tests/formats/test_machine_version_2.py",
             "tests/formats/test_shares_in_files.py", "tests/formats/test_allocation_files.py", "tests/studies",
             "tests/closedloop/test_shapes.py", "tests/closedloop/test_new_shape.py",
             "tests/closedloop/test_predict.py", "tests/closedloop/test_design.py"],
    "closedloop": ["tests/closedloop", "tests/studies"],
}  # fmt: skip
UNTOUCHED = ("test_benchmarks", "_takes_its_text_apart", "compares_the_name_of_a_shape")  # they read source files


def main() -> int:
    """Run the tests of the layer against each fault; 0 when at least nine of ten are found."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("layer", choices=sorted(TESTS))
    parser.add_argument("--sample", type=int, help="so many faults, drawn with --seed (default: all)")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--minutes", type=float, default=1e9, help="stop after this time; a later run goes on")
    parser.add_argument("--seconds", type=float, default=6.0, help="of tests per fault, the quickest first")
    parser.add_argument("--longest", type=float, default=1e9, help="leave out tests that take longer, s")
    parser.add_argument("--again", action="store_true", help="try the survivors again")
    parser.add_argument("--one", nargs=2, metavar=("PATH", "NUMBER"), help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    engine.MAX_SHRINKS = 0  # a failing example need not be a small one
    os.chdir(ROOT)
    runner = Runner(arguments)
    files = TESTS[arguments.layer]
    if arguments.one:
        path, number = arguments.one
        runner.asked = json.loads(sys.stdin.read())
        files = sorted({t.split("::")[0] for t in runner.asked})
        sys.meta_path.insert(0, _Replaced(path, mutated(path, Path(path).read_text(encoding="utf-8"), int(number))))
    options = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "--tb=no"]
    pytest.main([*options, *files], plugins=[runner])
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
        if self.arguments.one:
            self._one()
        self._learn()
        self._loop()
        return True

    # -- what the tests reach ----------------------------------------------------------------------------------------
    def _learn(self):
        """Lines that each test reaches and its duration, from a copy of this process under coverage; kept on disk."""
        kept = self.folder / f"{self.arguments.layer}-reach.json"
        stamp = sorted([[i.nodeid for i in self.items], self._sources()])
        if kept.exists():
            data = json.loads(kept.read_text(encoding="utf-8"))
            if data["stamp"] == json.loads(json.dumps(stamp)):
                self.seconds, self.reach = data["seconds"], data["reach"]
                return
        started = time.process_time()
        data_file = self.folder / f"{self.arguments.layer}.coverage"
        data_file.unlink(missing_ok=True)
        times = self.folder / "seconds.json"
        if _fork(lambda: self._traced(data_file, times), 3600)[0] != 0:
            raise SystemExit("the tests fail without any fault: nothing can be learned")
        self.seconds = json.loads(times.read_text(encoding="utf-8"))
        data = coverage.CoverageData(str(data_file))
        data.read()
        self.reach = {}
        for file in data.measured_files():
            lines = {str(k): sorted(v) for k, v in data.contexts_by_lineno(file).items()}
            self.reach[str(Path(file).relative_to(ROOT))] = lines
        stamp = {"stamp": stamp, "seconds": self.seconds, "reach": self.reach}
        kept.write_text(json.dumps(stamp), encoding="utf-8")
        print(f"learned what {len(self.seconds)} tests reach, {time.process_time() - started:.0f} s")

    def _sources(self):
        return [f"{p.relative_to(ROOT)} {p.stat().st_size}" for p in sorted(self._modules())]

    def _modules(self):
        return (ROOT / "sensworkbench" / self.arguments.layer).rglob("*.py")

    def _traced(self, data_file, times) -> int:
        seconds, passed = {}, True
        tracer = coverage.Coverage(data_file=str(data_file), source=[str(ROOT / "sensworkbench")])
        tracer.start()
        for n, item in enumerate(self.items):
            tracer.switch_context(item.nodeid)
            started = time.perf_counter()
            good = self._passes(item, self.items[n + 1] if n + 1 < len(self.items) else None)
            if not good:
                print("fails without any fault:", item.nodeid, file=sys.stderr)
            passed &= good
            seconds[item.nodeid] = time.perf_counter() - started
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
        random_ = random.Random(self.arguments.seed)
        everything = []
        for path in sorted(self._modules()):
            name = str(path.relative_to(ROOT))
            everything += mutants_of(name, path.read_text(encoding="utf-8"))
        if self.arguments.sample and self.arguments.sample < len(everything):
            everything = sorted(random_.sample(everything, self.arguments.sample), key=lambda m: (m.path, m.number))
        known = self._known()
        end = time.monotonic() + 60 * self.arguments.minutes
        todo = [m for m in everything if _key(m) not in known]
        if self.arguments.again:
            todo = [m for m in everything if known.get(_key(m), {}).get("result") in ("survived", "not reached")]
        random_.shuffle(todo)  # a run that is stopped has tried a fair part
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

    def _known(self) -> dict:
        """What was tried already, by path, line, text of the line and change; the last answer counts."""
        if not self.log.exists():
            return {}
        entries = [json.loads(line) for line in self.log.read_text(encoding="utf-8").splitlines()]
        return {(e["path"], e["number"], e["what"], e["text"]): e for e in entries}

    def _try(self, mutant: Mutant, functions) -> dict:
        lines = self.reach.get(mutant.path, {})
        tests = [t for t in lines.get(str(mutant.line), []) if t]
        again = self.arguments.again or mutant.function not in functions.get(mutant.path, {})
        if mutant.function is None:  # a constant: whoever reaches its module
            tests = sorted({t for names in lines.values() for t in names if t} | self._naming(Path(mutant.path).stem))
        tests = [t for t in tests if self.seconds.get(t, 0) <= self.arguments.longest]
        if not tests:
            return {"result": "not reached"}
        tests.sort(key=lambda t: (-self.killers.get(mutant.path + t, 0), self.seconds.get(t, 0)))
        chosen, total = [], 0.0
        for test in tests:
            if chosen and total + self.seconds.get(test, 0) > self.arguments.seconds:
                continue
            chosen.append(test)
            total += self.seconds.get(test, 0)
        limit = 10 + 8 * total
        if again:
            code, killer = _again(mutant, chosen, limit + 10, self.arguments)
        else:
            code, killer = _fork(lambda: self._in_copy(mutant, functions, chosen), limit)
        if code == 0:
            return {"result": "survived", "tests": len(chosen), "of": len(tests), "seconds": round(total, 2)}
        if killer:
            self.killers[mutant.path + killer] = self.killers.get(mutant.path + killer, 0) + 1
        return {"result": "killed" if code == 1 else "timeout" if code is None else f"ended {code}", "by": killer}

    def _naming(self, module: str) -> set[str]:
        """The tests of files that name a module: they may read a table of it and run no line."""
        if module not in self.named:
            files = {t.split("::")[0] for t in self.seconds}
            naming = {f for f in files if module in Path(f).read_text(encoding="utf-8")}
            self.named[module] = {t for t in self.seconds if t.split("::")[0] in naming}
        return self.named[module]

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

    def _one(self):
        os._exit(self._run(self.asked))

    def _tell(self, entries, of):
        count = {}
        for e in entries:
            count[e["result"]] = count.get(e["result"], 0) + 1
        alive = [e for e in entries if e["result"] in ("survived", "not reached")]
        share = 1 - len(alive) / max(1, len(entries))
        by_module: dict[str, list[int]] = {}
        for e in entries:
            row = by_module.setdefault(e["path"], [0, 0])
            row[0] += 1
            row[1] += e in alive
        for path, (n, left) in sorted(by_module.items()):
            print(f"{path:55} {n:5} tried {n - left:5} found {100 * (1 - left / n):6.1f} %")
        for e in alive:
            print(f"alive: {e['path']}:{e['line']}: {e['what']}: {e['text']}")
        print(f"{len(entries)} of {of} faults tried, {100 * share:.1f} % found: {count}")
        self.status = 0 if share >= 0.9 else 1


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
    """(status of `work` in a copy of this process, what it told); None where it took longer than `limit` s."""
    back, forth = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(back)
        _PIPE[:] = [forth]
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.alarm(int(limit) + 1)
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
        return (None if os.WTERMSIG(state) == signal.SIGALRM else 2), told.decode()
    return os.WEXITSTATUS(state), told.decode()


def _again(mutant: Mutant, tests, limit: float, arguments) -> tuple[int | None, str]:
    """As `_fork`, in a process that imports everything again, with the changed module in place of its own."""
    command = [sys.executable, __file__, arguments.layer, "--one", mutant.path, str(mutant.number)]
    try:
        done = subprocess.run(command, input=json.dumps(tests), capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return None, ""
    return (0 if done.returncode == 0 else 1), ""


if __name__ == "__main__":
    sys.exit(main())
