# SPDX-License-Identifier: LGPL-2.1-or-later
"""`verify RESULT`: whether files of results are whole, and the same when they are computed again."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
from pathlib import Path

from sensworkbench.core.refusal import Refused

from .. import common, without_manifest

HELP = "whether results are whole and come out the same again"
FILES = "none; says what differs"
FURTHER = {"part": "--correct"}  # verb -> the option that names one more file that it writes, a set of its own


def add(parser) -> None:
    parser.add_argument("result", metavar="RESULT", help="a folder of results, or one result file")
    parser.add_argument("--sums-only", action="store_true", help="compare the sums, compute nothing again")
    text = "what a result without manifest was made from, in the order of its command: machine, readings or positions"
    parser.add_argument("--input", metavar="FILE", action="append", default=[], help=text)


def run(arguments) -> int:
    from sensworkbench.formats import file_sets, manifest

    if arguments.input:
        sentences = without_manifest.check(Path(arguments.result), arguments.input)
    else:
        folder, path, name = _manifest(arguments.result)
        file_sets.recover(folder)
        sets = manifest.load(path)["sets"]
        again = not arguments.sums_only
        sentences = (words for entry in sets for words in check_set(folder, entry, name, again, sets))
    differs = 0
    for words in sentences:
        differs += not words.startswith(("same:", "note:"))
        common.say(words)
    common.say("verified" if not differs else f"{differs} differences")
    return common.DONE if not differs else common.REFUSED


def _manifest(result) -> tuple[Path, Path, str | None]:
    """(folder of the set, its manifest, the single result file or None).  Refuses a result that has no manifest."""
    from sensworkbench.formats import manifest

    path = Path(result)
    if path.is_dir():
        places = [(path, path / manifest.NAME, None)]
    else:
        own = path.with_name(manifest.name_of(path.name))
        places = [(path.parent, own, path.name), (path.parent, path.parent / manifest.NAME, None)]
        if path.name == manifest.NAME:
            places = [(path.parent, path, None)]
        elif path.name.endswith("." + manifest.NAME):
            places = [(path.parent, path, path.name.removesuffix("." + manifest.NAME))]
    if not path.exists():
        raise Refused("verify-nothing", str(result))
    for place in places:
        if place[1].is_file():
            return place
    raise Refused("verify-no-manifest", str(result))


def check_set(folder: Path, entry: dict, name: str | None, recompute: bool = True, sets=()):
    """Say, sentence by sentence, what of one set is the same and what is not.

    entry : the set in the manifest of `folder`.  name : the single result, or None for a set of files.  sets : all sets
    of the manifest: those that were made within a run (a demonstration) are compared with it.
    """
    from sensworkbench.formats import manifest, provenance

    verb, whole = entry["verb"] or "results", True
    if entry["made_by"] != manifest.MADE_BY:
        yield f"note: {verb}: made by {entry['made_by']}, this is {manifest.MADE_BY}"
    for over in entry.get("written_over", ()):
        yield f"note: {verb}: {over} has been written over by another verb"
    for file in entry["files"]:
        path = folder / file["name"]
        if not path.is_file():
            whole = False
            yield f"missing: {path}"
        elif provenance.sha256(path)[0] != file["sha256"]:
            whole = False
            yield f"changed: {path} is not the file that was written"
    if _further(entry) and name is None and not _own(entry, _further(entry)):
        yield from _sum_of_further(folder, entry)
    found = {}
    for given in entry["inputs"]:
        path = _input(folder, given["path"])
        if path is None:
            yield f"missing: the input {given['path']}"
        elif provenance.sha256(path)[0] != given["sha256"]:
            yield f"changed: the input {path} is not the file that was read"
        else:
            found[given["path"]] = str(path)
    if whole:
        yield f"same: {len(entry['files'])} files of {verb} are as they were written"
    if not recompute or len(found) < len(entry["inputs"]):
        return
    if not entry["command"] or entry["verb"] not in (entry["command"][0], _further_verb(entry)):
        inside = entry["command"][0] if entry["command"] else "a program or a window"
        with_it = any(s["verb"] == inside and s["command"] == entry["command"] for s in sets)
        yield f"note: {verb}: made within {inside}, {'computed again with it' if with_it else 'not computed again'}"
        return
    within = [s for s in sets if s["command"] == entry["command"] and s["verb"] != entry["verb"]]
    files = [*entry["files"], *(file for s in within for file in s["files"])]
    yield from _again(folder, entry | {"files": files}, name, found)


def _input(folder: Path, path: str) -> Path | None:
    """Where an input is now: as it was named, from here or from the folder of the results, or beside them."""
    outer = folder.absolute().parent
    for place in (Path(path), folder / path, outer / path, folder / Path(path).name, outer / Path(path).name):
        if place.is_file():
            return place
    return None


def _again(folder: Path, entry: dict, name: str | None, found: dict[str, str]):
    """Run the command again and say what differs."""
    from sensworkbench.formats import comparison, manifest

    from ..program import main

    older = entry["made_by"] != manifest.MADE_BY
    words = [_with_inputs(word, found) for word in entry["command"]]
    further = _further(entry)
    with tempfile.TemporaryDirectory(prefix="sens-verify-") as place:
        out = Path(place, "out") if name is None or further else Path(place, name)
        if further:  # what is verified is never written over
            to = (out if name is None and _own(entry, further) else Path(place)) / Path(further).name
            words = _with_further(words, str(to))
        said = io.StringIO()
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said):
            status = main([words[0], f"--out={out}", *words[1:]])
        if status != common.DONE:
            yield f"differs: the command is now refused: {said.getvalue().strip()[:200]}"
            return
        alike = 0
        for file in entry["files"]:
            now = (out if name is None else Path(place)) / file["name"]
            before = folder / file["name"]
            if not before.is_file():
                continue
            if before.suffix.lower() in comparison.NOT_COMPARED:
                yield f"note: {file['name']}: its sum alone was compared; its numbers stand in the tables beside it"
                continue
            if not now.is_file():
                yield f"differs: {file['name']} is not written any more"
                continue
            sentences = list(without_manifest.compared(before, now, file["name"], older))
            alike += not any(w.startswith("differs:") for w in sentences)
            yield from sentences
        written = _input(folder, further) if further and name is None and not _own(entry, further) else None
        if written is not None:
            yield from without_manifest.compared(written, to, str(written), older)
        extra = sorted(p.name for p in out.iterdir()) if name is None else []
        known = {f["name"] for f in entry["files"]} | {"manifest.json"}
        for new in (n for n in extra if n not in known and not (out / n).is_dir()):
            yield f"differs: {new} is new"
        yield f"same: {alike} files of {entry['verb']} come out the same again"


def _further(entry: dict) -> str:
    """The further file that the command of a set writes, as it was named, or ""."""
    option, found = FURTHER.get(entry["command"][0] if entry["command"] else ""), ""
    for word, after in zip(entry["command"], [*entry["command"][1:], ""]):
        if option and (word == option or word.startswith(option + "=")):
            found = after if word == option else word[len(option) + 1 :]
    return found


def _further_verb(entry: dict) -> str:
    """The name of the set of that file; "" without one."""
    return f"{entry['command'][0]} {FURTHER[entry['command'][0]]}" if _further(entry) else ""


def _own(entry: dict, further: str) -> bool:
    """Whether that file was written into the folder of the results, and is a file of the set."""
    return Path(further).name in {f["name"] for f in entry["files"]}


def _with_further(words: list[str], to: str) -> list[str]:
    """The command line with `to` in place of that file."""
    option, kept = FURTHER[words[0]], []
    for at, word in enumerate(words):
        if word.startswith(option + "="):
            word = f"{option}={to}"
        elif at and words[at - 1] == option:
            word = to
        kept.append(word)
    return kept


def _sum_of_further(folder: Path, entry: dict):
    """Say whether that file is there, and as the same command wrote it."""
    from sensworkbench.formats import manifest, provenance

    path = _input(folder, _further(entry))
    if path is None:
        yield f"missing: {_further(entry)}"
        return
    stated = path.with_name(manifest.name_of(path.name))
    if not stated.is_file():
        yield f"missing: {stated}"
        return
    for other in manifest.load(stated)["sets"]:
        if other["verb"] != _further_verb(entry):
            continue
        if other["command"] != entry["command"] or other["inputs"] != entry["inputs"]:
            yield f"changed: {path} is of another run"
        elif any(provenance.sha256(path)[0] != f["sha256"] for f in other["files"] if f["name"] == path.name):
            yield f"changed: {path} is not the file that was written"


def _with_inputs(word: str, found: dict[str, str]) -> str:
    """A word of the command with the place where the input, or the folder of inputs, that it names is now."""
    for path, now in found.items():
        if word == path or word.endswith("=" + path):
            return word.removesuffix(path) + os.path.abspath(now)
    for path, now in found.items():
        rest = path.removeprefix(word)
        if rest.startswith(("/", os.sep)) and now != path and now.endswith(rest):
            return now.removesuffix(rest)
    return word
