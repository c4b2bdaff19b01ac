# SPDX-License-Identifier: LGPL-2.1-or-later
"""manifest.json: which files of a folder belong together, what they were made from, and the sum of each.

{"format": "sens-manifest", "version": 1, "sets": [{"verb", "made_by", "command", "seed", "conventions", "inputs":
[{"path", "sha256", "bytes"}], "files": [{"name", "sha256", "bytes"}]}]}, one set per verb that wrote to the folder.  A
single result file NAME has the manifest NAME.manifest.json in the same folder.
"""

from __future__ import annotations

import json
import os
import re
from pathlib import Path, PurePosixPath

from sensworkbench import __version__
from sensworkbench.core.refusal import Refused

from . import files, json_text, operations, provenance

FORMAT, VERSION, NAME = "sens-manifest", 1, "manifest.json"
CONVENTIONS = {
    "errors": "actual - commanded, tool relative to workpiece",
    "standards": "ISO 230-1:2012, ISO 230-7, ISO 841",
    "units": "mm, rad, s and kelvin from 20 degC inside; um and urad in results",
}
MADE_BY = f"Sens Workbench {__version__}"
_SUM = re.compile(r"[0-9a-f]{64}")
_LIMIT = 2**22


def name_of(result: str | None) -> str:
    """Name of the manifest of a folder (None), or of a single result file in it."""
    if result is None:
        return NAME
    return (result if len(os.fsencode(result)) <= 240 else result[:50]) + "." + NAME


def is_plain(name: str) -> bool:
    """Whether a name with / between folders stays in its folder and is none of the hidden ones."""
    parts = PurePosixPath(name).parts
    bad = any(p in ("..", ".") or p.startswith(files.MARK) or any(c in p for c in "\\:\0") for p in parts)
    return bool(parts) and not bad and not name.startswith("/")


def made(verb: str, folder: Path, names: list[str], result: str | None) -> dict:
    """The manifest of a new set in `folder`, with the sets that a part of the run made there already (a demonstration).

    names : of the set's files.  result : name of the single result, or None.
    """
    own = name_of(result)
    inner = load(folder / own)["sets"] if own in names else []
    taken = {file["name"] for entry in inner for file in entry["files"]}
    run = provenance.current()
    rows = []
    for name in names:
        if name != own and name not in taken:
            digest, count = provenance.sha256(folder / name)
            rows.append({"name": name, "sha256": digest, "bytes": count})
    entry = {
        "verb": verb,
        "made_by": MADE_BY,
        "command": list(run.command) if run else [],
        "seed": run.seed if run else None,
        "conventions": CONVENTIONS,
        "inputs": [{"path": i.path, "sha256": i.sha256, "bytes": i.bytes} for i in run.inputs.values()] if run else [],
        "files": rows,
    }
    sets = [s for s in inner if s["verb"] != verb] + ([entry] if rows or not inner else [])
    return {"format": FORMAT, "version": VERSION, "sets": sets}


def merged(folder: Path, new: dict, result: str | None) -> tuple[dict, list[str]]:
    """(manifest of `folder` with the new sets in it, names of files that earlier sets of these verbs leave behind).

    A file that was changed since it was written is nobody's rubbish and stays.
    """
    path = folder / name_of(result)
    before = load(path)["sets"] if operations.kind(path) == "file" else []
    verbs = {s["verb"] for s in new["sets"]}
    names = {f["name"] for s in new["sets"] for f in s["files"]}
    kept, stale = [], []
    for entry in before:
        if entry["verb"] in verbs:
            stale += [f["name"] for f in entry["files"] if f["name"] not in names and _unchanged(folder, f)]
        else:  # another verb's set: a file that has been written over is no longer its own
            rest = [f for f in entry["files"] if f["name"] not in names]
            over = sorted({f["name"] for f in entry["files"]} & names | set(entry.get("written_over", ())))
            kept.append(entry | {"files": rest} | ({"written_over": over} if over else {}))
    others = {f["name"] for s in kept for f in s["files"]}
    return {**new, "sets": kept + new["sets"]}, [s for s in stale if s not in others]


def _unchanged(folder: Path, file: dict) -> bool:
    path = folder / file["name"]
    try:
        return operations.kind(path) == "file" and provenance.sha256(path)[0] == file["sha256"]
    except OSError:
        return False


def dumps(stated: dict) -> str:
    """The text of a manifest."""
    return json.dumps(stated, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def load(path) -> dict:
    """A manifest, checked; refuses what is none, and names that reach out of the folder."""
    return loads(files.read_bytes(path, _LIMIT, note=False).decode("utf-8", "replace"), str(path))


def loads(text: str, name: str = NAME) -> dict:
    """The manifest in `text`."""
    top = json_text.parse(text, name)
    if not isinstance(top.value, dict) or top.value.get("format") != FORMAT:
        raise Refused("manifest-not-one", name)
    top.keys(("format", "version", "sets"), ("version", "sets"))
    if isinstance(top.value["version"], bool) or top.value["version"] != VERSION:
        raise Refused("manifest-version", top["version"].where, version=json_text.short(top.value["version"]))
    for entry in top["sets"].elements():
        keys = ("verb", "made_by", "command", "seed", "conventions", "inputs", "files", "written_over")
        entry.keys(keys, ("verb", "made_by", "command", "inputs", "files"))
        entry["verb"].string()
        entry["made_by"].string()
        for word in entry["command"].elements():
            word.string()
        if "seed" in entry and entry["seed"].value is not None:
            entry["seed"].integer(-(2**63), 2**63)
        for _, stated in entry["conventions"].members() if "conventions" in entry else ():
            stated.string()
        for group, key in (("inputs", "path"), ("files", "name")):
            for file in entry[group].elements():
                file.keys((key, "sha256", "bytes"), (key, "sha256", "bytes"))
                stated = file[key].string()
                if group == "files" and not is_plain(stated):
                    raise Refused("manifest-name", file[key].where, name=json_text.short(stated))
                if not _SUM.fullmatch(file["sha256"].string()):
                    raise Refused("manifest-sum", file["sha256"].where)
                file["bytes"].integer(0, 2**53)
        for over in entry["written_over"].elements() if "written_over" in entry else ():
            over.string()
    return top.value
