# SPDX-License-Identifier: LGPL-2.1-or-later
"""The add-on's manifest, licence, versions and the files that make and integration call."""

from __future__ import annotations

import ast
import datetime
import os
import re
from xml.etree import ElementTree

from sensworkbench import __version__

from .support import ROOT

NS = "{https://wiki.freecad.org/Package_Metadata}"


def manifest() -> ElementTree.Element:
    return ElementTree.parse(ROOT / "package.xml").getroot()


def test_it_has_all_that_the_addon_manager_asks_for():
    root = manifest()
    assert (root.tag, root.attrib["format"]) == (f"{NS}package", "1")
    for name in ("name", "version", "date", "description", "maintainer", "license", "icon", "content"):
        assert root.find(NS + name) is not None, name
    assert "@" in root.find(f"{NS}maintainer").attrib["email"]
    datetime.date.fromisoformat(root.findtext(f"{NS}date"))
    assert 3 <= len(root.findall(f"{NS}tag")) <= 7
    assert all(t.text == t.text.lower() for t in root.findall(f"{NS}tag"))


def test_every_kind_of_url_is_given():
    urls = {u.attrib["type"]: u for u in manifest().findall(f"{NS}url")}
    assert set(urls) == {"website", "bugtracker", "repository", "readme", "documentation", "discussion"}
    assert urls["repository"].attrib["branch"]
    readme = urls["readme"].text.rpartition("/")[2]
    assert (ROOT / readme).exists()


def test_the_files_it_names_exist():
    root = manifest()
    for icon in root.iter(f"{NS}icon"):
        assert (ROOT / icon.text).read_text(encoding="utf-8").lstrip().startswith("<")
    licence = root.find(f"{NS}license")
    assert licence.text == "LGPL-2.1-or-later"
    text = (ROOT / licence.attrib["file"]).read_text(encoding="utf-8")
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in text and "Version 2.1, February 1999" in text
    assert "END OF TERMS AND CONDITIONS" in text


def test_the_class_it_names_is_in_initgui():
    workbench = manifest().find(f"{NS}content/{NS}workbench")
    tree = ast.parse((ROOT / "InitGui.py").read_text(encoding="utf-8"))
    classes = {n.name for n in ast.walk(tree) if isinstance(n, ast.ClassDef)}
    assert workbench.findtext(f"{NS}classname") in classes
    assert workbench.findtext(f"{NS}subdirectory") == "./"


def test_one_version_stands_everywhere():
    root = manifest()
    assert root.findtext(f"{NS}version") == __version__
    project = re.search(r'^version = "(.+)"', (ROOT / "pyproject.toml").read_text(encoding="utf-8"), re.MULTILINE)
    assert project.group(1) == __version__
    newest = re.search(r"^## (\S+) \((\S+)\)", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert newest.groups() == (__version__, root.findtext(f"{NS}date"))


def test_depends_only_on_what_freecad_can_bring():
    depends = {d.text: d.attrib for d in manifest().findall(f"{NS}depend")}
    python = {name for name, a in depends.items() if a["type"] == "python"}
    assert python == {"numpy", "matplotlib"}
    assert depends["matplotlib"]["optional"] == "true"


def test_scripts_can_be_run():
    for name in (".ci/run", "tools/prepare.sh"):
        assert os.access(ROOT / name, os.X_OK), name
    assert "make test" in (ROOT / ".ci/run").read_text(encoding="utf-8")


def test_every_picture_and_page_of_the_readme_exists():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    links = re.findall(r"\]\(([^)#]+)\)", text)
    assert links
    for link in links:
        assert link.startswith("https://") or (ROOT / link).exists(), link
    first_screen = text[:2200]
    assert "make demo" in first_screen and "make test" in first_screen and "docs/images/" in first_screen
