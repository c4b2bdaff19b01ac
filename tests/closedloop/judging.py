# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a trace of a case with a known answer is judged: its names against the truth, its prediction against a bound.

The truth may be among the rivals that "leave the same trace": then the readings hold no difference.
"""

from __future__ import annotations

LIMIT = 1.2  # times the bound


def triple(entry) -> tuple[str, str, str]:
    """Component, driver, shape; a sign of travel is a reversal or linear in it, as you like."""
    shape = "linear" if entry["shape"] == "reversal" else entry["shape"]
    return entry["component"], "*".join(sorted(entry["driver"].split("*"))), shape


def said(report) -> list[set]:
    """Per finding: its own name and those of the rivals that leave the very same trace."""
    return [{triple(e)} | {triple(r) for r in e["rivals"] if "same trace" in r["why"]} for e in report["effects"]]


def listed(report) -> list[set]:
    """Per finding: its own name and all of its rivals'."""
    return [{triple(e)} | {triple(r) for r in e["rivals"]} for e in report["effects"]]


def names_exactly(sets, truths) -> bool:
    """Does every finding answer to one true effect, and every effect to one finding?"""
    left = [triple(t) for t in truths]
    for names in sets:
        hit = [t for t in left if t in names]
        if not hit:
            return False
        left.remove(hit[0])
    return not left
