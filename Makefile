# SPDX-License-Identifier: LGPL-2.1-or-later
# make demo    an example machine: parts, coloured document, pictures, report, traced readings, in build/demo/
# make test    all tests on this machine's FreeCAD; the tiers, each named for what it needs:
# make test-style     nothing but the source: linter and format
# make test-plain     Python and numpy: everything that does not touch FreeCAD
# make test-portable  FreeCAD's own Python and numpy: golden numbers, readers, command line
# make test-freecad   FreeCAD without a window
# make test-window    FreeCAD in a window (under Xvfb)
# make test-install   a clone of the last commit, installed as an add-on
# make test-matrix    test-style and test-plain once, the others on FreeCAD 0.20, 1.0 and 1.1 (chroots, as root)
# One test: .venv/bin/python -m pytest FILE::NAME, or .venv/bin/python tests/run_in_freecad.py [--gui] FILE::NAME
# make bench   time and memory of the indices beside OpenTURNS, SALib and the memory floor; change to repaint
# make translations  collect the texts of the window, compile German and Korean (checked by lrelease where installed)
# make fuzz    half a million changed files, each read or refused; the count is printed (FUZZ_INPUTS=N, FUZZ_SEED=N); then
#              100,000 inputs led by the branches that they reach, where atheris is installed in .venv (FUZZ_RUNS=N)
# make coverage  branches of core and of the rest that the plain tests take, file by file
# make mutation  small faults made one at a time: how many the tests find (LAYER=core|closedloop, SAMPLE=N, MINUTES=N)
# make screens  a picture of every panel on each FreeCAD that is there: three sizes of screen, light and dark, in build/screens/
# make pictures  the pictures of docs/guide.md, as the window shows them now
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

.PHONY: coverage mutation fuzz help system venv demo test test-style test-plain test-portable test-freecad test-window test-install \
        test-matrix bench translations screens pictures clean

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

# tests that need FreeCAD, a window or an installation are in these folders; all others are plain
NEED_FREECAD := tests/document tests/gui tests/install
# what differs between versions of Python and numpy
PORTABLE := $(shell cat tests/portable.txt)
# processes that share the plain tests
WORKERS ?= 2

test: test-style test-plain test-portable test-freecad test-window test-install

test-style: venv
	$(VENV_PYTHON) -m ruff check .
	$(VENV_PYTHON) -m ruff format --check .

test-plain: export OMP_NUM_THREADS = 1
test-plain: export OPENBLAS_NUM_THREADS = 1
test-plain: venv
	$(VENV_PYTHON) -m pytest -n $(WORKERS) --dist loadfile $(NEED_FREECAD:%=--ignore=%) tests

test-portable: system venv
	$(SYSTEM_PYTHON) tests/run_with.py $(VENV) $(PORTABLE)

test-freecad: system venv
	$(VENV_PYTHON) tests/run_in_freecad.py tests/document

test-window: system venv
	$(VENV_PYTHON) tests/run_in_freecad.py --gui tests/gui

test-install: system venv
	$(VENV_PYTHON) -m pytest tests/install

test-matrix:
	tools/freecad-matrix.sh test

bench: venv
	$(VENV_PYTHON) benchmarks/indices.py
	$(VENV_PYTHON) benchmarks/recolour.py

fuzz: venv
	$(VENV_PYTHON) tests/fuzz/run.py --inputs $(or $(FUZZ_INPUTS),500000) --seed $(or $(FUZZ_SEED),0)
	$(VENV_PYTHON) tests/fuzz/covered.py --runs $(or $(FUZZ_RUNS),100000) --seed $(or $(FUZZ_SEED),0)

coverage: export OMP_NUM_THREADS = 1
coverage: export OPENBLAS_NUM_THREADS = 1
coverage: venv
	$(VENV_PYTHON) -m coverage run --branch --source sensworkbench --data-file build/.coverage -m pytest -q -n0 \
	    $(NEED_FREECAD:%=--ignore=%) $(or $(COVERAGE_TESTS),tests)
	$(VENV_PYTHON) -m coverage report --data-file build/.coverage --skip-covered --include 'sensworkbench/core/*'
	$(VENV_PYTHON) -m coverage report --data-file build/.coverage --skip-covered \
	    --omit 'sensworkbench/core/*,sensworkbench/document/*,sensworkbench/gui/*'

mutation: venv
	$(VENV_PYTHON) tools/mutation.py $(or $(LAYER),core) $(SAMPLE:%=--sample %) $(MINUTES:%=--minutes %)

translations:
	$(PYTHON) resources/translations/update.py

pictures: system venv
	$(VENV_PYTHON) tests/run_in_freecad.py --gui -q tests/gui/guide_pictures.py

screens: system venv
	tools/screens.sh

clean:
	rm -rf build
