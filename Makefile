# SPDX-License-Identifier: LGPL-2.1-or-later
# make demo    an example machine: parts, coloured document, pictures, report, traced readings, in build/demo/
# make test    style, the tests without FreeCAD, inside FreeCAD, and in a window under Xvfb
# make test-matrix  all tests on FreeCAD 0.20, 1.0 and 1.1: the machine's own, the others in chroots (as root)
# make bench   time and memory of the indices beside OpenTURNS, SALib and the memory floor; change to repaint
# make translations  collect the texts of the window, compile German and Korean (checked by lrelease where installed)
# make screens  a picture of every panel, light and dark, in build/screens/
# What is missing is installed (Debian: apt, as root or with sudo; test-only packages go into .venv).

SHELL := /bin/bash
PYTHON ?= python3
# the demonstration runs on the numpy that came with FreeCAD
SYSTEM_PYTHON ?= $(firstword $(wildcard /usr/bin/python3) $(PYTHON))
VENV := .venv
VENV_PYTHON := $(VENV)/bin/python
OUT ?= build/demo
export OMP_NUM_THREADS ?= 2
export OPENBLAS_NUM_THREADS ?= 2

.PHONY: help system venv demo test test-style test-core test-document test-gui test-install test-matrix bench translations screens clean

help:
	@grep -E '^# make' Makefile | sed 's/^# //'

system:
	@tools/prepare.sh

$(VENV)/ready: tests/requirements.txt
	@tools/prepare.sh
	$(PYTHON) -m venv $(VENV)
	$(VENV_PYTHON) -m pip install --quiet --disable-pip-version-check -r tests/requirements.txt
	@touch $@

venv: $(VENV)/ready

demo: system
	@mkdir -p $(OUT)
	$(SYSTEM_PYTHON) -m sensworkbench demo --out $(OUT)

test: test-style test-core test-document test-gui test-install

test-style: venv
	$(VENV_PYTHON) -m ruff check .

test-core: venv
	$(VENV_PYTHON) -m pytest --ignore=tests/document --ignore=tests/gui --ignore=tests/install tests

test-document: system venv
	$(VENV_PYTHON) tests/run_in_freecad.py tests/document

test-gui: system venv
	$(VENV_PYTHON) tests/run_in_freecad.py --gui tests/gui

test-install: system venv
	$(VENV_PYTHON) -m pytest tests/install

test-matrix:
	tools/freecad-matrix.sh test

bench: venv
	$(VENV_PYTHON) benchmarks/indices.py
	$(VENV_PYTHON) benchmarks/recolour.py

translations:
	$(PYTHON) resources/translations/update.py

screens: system venv
	$(VENV_PYTHON) tests/run_in_freecad.py --gui -q tests/gui/test_panels.py tests/gui/test_commands.py
	@ls build/screens

clean:
	rm -rf build
