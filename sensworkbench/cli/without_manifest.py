# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results that have no manifest, because an older version wrote them or it was lost: computed again and compared.

A result file states its settings; what it was made from has to be named.  What an older version did not write is no
difference.
"""

from __future__ import annotations

import contextlib
import io
import tempfile
from pathlib import Path

from sensworkbench.core.refusal import Refused

from . import common

FILES = ("sensitivity.json", "trace.json", "predicted.csv")


def check(result: Path, inputs: list[str]):
    """Say, sentence by sentence, what of a result file, or of those in a folder, comes out the same from `inputs`."""
    if not result.exists():
        raise Refused("verify-nothing", str(result))
    files = [result] if result.is_file() else [result / n for n in FILES if (result / n).is_file()]
    if not files:
        raise Refused("verify-not-known", str(result), known=list(FILES))
    for file in files:
        yield f"note: {file}: without manifest, so that its sum is not known"
        yield from _again(file, command(file, inputs))


def command(file: Path, inputs: list[str]) -> list[str]:
    """The command line, without --out, that a result file says it was made by."""
    if file.suffix == ".csv":
        return ["predict", *_given(file, inputs, 2)]
    from sensworkbench.formats import json_text
    from sensworkbench.formats.files import read_text

    place = json_text.parse(read_text(file), str(file))
    data = place.value if isinstance(place.value, dict) else {}
    if data.get("format") == "sens-sensitivity" and isinstance(data.get("settings"), dict):
        return ["sensitivity", *_given(file, inputs, 1), *_settings(data)]
    if data.get("format") == "sens-trace":
        stated = [f"--{k}={data[k]}" for k in ("seed", "permutations") if k in data]
        return ["trace", *_given(file, inputs, 2), *stated]
    raise Refused("verify-not-known", str(file), known=list(FILES))


def _given(file: Path, inputs: list[str], count: int) -> list[str]:
    if len(inputs) != count:
        raise Refused("verify-inputs", str(file), count=count, given=len(inputs))
    return inputs


def _settings(data: dict) -> list[str]:
    """The options that sensitivity.json states."""
    settings, points = data["settings"], data.get("points")
    listed = ",".join(map(str, points if isinstance(points, list) else [points]))
    options = [f"--{str(data.get('aggregate')).replace('_', '-')}={listed}"]
    judged = settings.get("judged") or {"name": "signed" if settings.get("signed") else "mean_square"}
    fields = {k: v for k, v in judged.items() if k not in ("name", "output", "weights")}
    named = judged["name"] + (":" + ",".join(f"{k}={v}" for k, v in fields.items()) if fields else "")
    options.append(f"--objective={named}")
    options += [f"--output={settings['output']}", "--weights=" + ",".join(map(str, settings["weights"]))]
    if "squareness" in settings:
        options.append(f"--squareness={settings['squareness']}")
    if any(isinstance(e, dict) and e.get("unit") == "arcsec" for e in data.get("errors", ())):
        options.append("--angle-unit=arcsec")
    return options


def _again(file: Path, words: list[str]):
    from .program import main

    with tempfile.TemporaryDirectory(prefix="sens-verify-") as place:
        out = Path(place, "out") if file.suffix == ".json" else Path(place, file.name)
        said = io.StringIO()
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said):
            status = main([words[0], f"--out={out}", *words[1:]])
        if status != common.DONE:
            yield f"differs: {' '.join(words)[:120]} is refused: {said.getvalue().strip()[:200]}"
            return
        name = {"sensitivity": "sensitivity.json", "trace": "trace.json"}.get(words[0])
        sentences = list(compared(file, out / name if name else out, file.name, older=True))
        yield from sentences
        if not any(w.startswith("differs:") for w in sentences):
            yield f"same: {file.name} comes out the same again"


def compared(before: Path, now: Path, name: str, older: bool):
    """Say what differs; where the result is of an older version, what this one adds is a note."""
    from sensworkbench.formats import comparison

    added = 0
    for words in comparison.differences(before, now, most=1000 if older else 5):
        if older and words.endswith("is new"):
            added += 1
        else:
            yield f"differs: {name}: {words}"
    if added:
        yield f"note: {name}: {added} entries that the older version did not write"
