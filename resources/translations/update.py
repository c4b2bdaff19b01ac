# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collects the texts of the window into the .ts files and compiles them to .qm.

    python3 resources/translations/update.py [--check]

Texts are collected by reading the Python sources: lupdate of Qt 5 reads no Python.  Where Qt's lrelease is installed it
must accept each .ts file and find nothing unfinished; the .qm files are always written here, so that every machine
writes the same bytes.  The .ts files can be edited with Qt Linguist.  --check changes nothing and ends with 1 where a
text is missing, untranslated or not compiled.
"""

from __future__ import annotations

import ast
import shutil
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LANGUAGES = ("de", "ko")
NAMES = ("translate", "QT_TRANSLATE_NOOP")


def texts() -> list[tuple[str, str, str]]:
    """(context, text, file) of every translatable literal, in order, each once."""
    found = {}
    for path in [*sorted((ROOT / "sensworkbench" / "gui").glob("*.py")), ROOT / "InitGui.py"]:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and len(node.args) == 2:
                name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
                if name in NAMES and all(isinstance(a, ast.Constant) for a in node.args):
                    found.setdefault((node.args[0].value, node.args[1].value), path.relative_to(ROOT).as_posix())
    return [(context, text, path) for (context, text), path in sorted(found.items())]


def read(path: Path) -> dict[tuple[str, str], str]:
    """(context, text) -> translation of a .ts file."""
    if not path.exists():
        return {}
    table = {}
    for context in ET.parse(path).getroot().iter("context"):
        name = context.findtext("name") or ""
        for message in context.iter("message"):
            translation = message.find("translation")
            if translation is not None and translation.get("type") != "unfinished" and translation.text:
                table[name, message.findtext("source") or ""] = translation.text
    return table


def ts(language: str, table) -> str:
    """The text of a .ts file."""
    root = ET.Element("TS", version="2.1", language=language, sourcelanguage="en")
    contexts = {}
    for context, text, path in texts():
        if context not in contexts:
            contexts[context] = ET.SubElement(root, "context")
            ET.SubElement(contexts[context], "name").text = context
        message = ET.SubElement(contexts[context], "message")
        ET.SubElement(message, "location", filename=f"../../{path}")
        ET.SubElement(message, "source").text = text
        translation = ET.SubElement(message, "translation")
        if (context, text) in table:
            translation.text = table[context, text]
        else:
            translation.set("type", "unfinished")
    ET.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n' + ET.tostring(root, encoding="unicode") + "\n"


def elf_hash(data: bytes) -> int:
    """The hash by which Qt finds a message."""
    h = 0
    for byte in data:
        h = (h << 4) + byte
        g = h & 0xF0000000
        if g:
            h ^= g >> 24
        h &= ~g & 0xFFFFFFFF
    return h or 1


def qm(table) -> bytes:
    """The compiled file: hashes, then messages with their source and context for the comparison."""
    messages, hashes = b"", []
    for (context, text), translation in sorted(table.items()):
        source, name, words = text.encode(), context.encode(), translation.encode("utf-16-be")
        hashes.append((elf_hash(source), len(messages)))
        messages += struct.pack(">BI", 3, len(words)) + words
        for tag, value in ((8, b""), (6, source), (7, name)):  # comment, source text, context
            messages += struct.pack(">BI", tag, len(value)) + value
        messages += b"\x01"
    magic = bytes.fromhex("3cb86418caef9c95cd211cbf60a1bddd")
    index = b"".join(struct.pack(">II", *pair) for pair in sorted(hashes))
    return magic + struct.pack(">BI", 0x42, len(index)) + index + struct.pack(">BI", 0x69, len(messages)) + messages


def released(path: Path) -> list[str]:
    """What Qt's own lrelease finds wrong with a .ts file; nothing where it is not installed."""
    program = next(filter(None, map(shutil.which, ("lrelease", "lrelease-qt6", "lrelease-qt5"))), None)
    if program is None:
        return []
    with tempfile.TemporaryDirectory() as folder:
        line = [program, str(path), "-qm", str(Path(folder) / "out.qm")]
        found = subprocess.run(line, capture_output=True, text=True, timeout=60, check=False)
    return [] if found.returncode == 0 else [f"{path.name}: {found.stderr.strip()}"]


def main(argv: list[str]) -> int:
    check, wrong = "--check" in argv, []
    for language in LANGUAGES:
        path = HERE / f"SensWorkbench_{language}.ts"
        table = read(path)
        wanted = {(c, t) for c, t, _ in texts()}
        missing = sorted(wanted - set(table))
        wrong += [f"{path.name}: not translated: {t!r}" for _, t in missing]
        table = {k: v for k, v in table.items() if k in wanted}
        outputs = {path: ts(language, table).encode(), path.with_suffix(".qm"): qm(table)}
        for file, content in outputs.items():
            if check:
                if not file.exists() or file.read_bytes() != content:
                    wrong.append(f"{file.name} is not up to date")
            else:
                file.write_bytes(content)
        wrong += released(path)
    sys.stderr.write("".join(line + "\n" for line in wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
