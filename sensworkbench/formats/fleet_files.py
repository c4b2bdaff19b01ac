# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a fleet: a folder per machine is read; fleet.json, fleet.csv and a page are written."""

from __future__ import annotations

import csv
import datetime
import io
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from sensworkbench import __version__
from sensworkbench.core.refusal import Refused
from sensworkbench.core.units import um
from sensworkbench.studies.fleet import FleetEffect, FleetResult, Member, Recurring, median_um

from . import html, json_text, machine_json, provenance, readings_csv
from .files import neutral
from .trace_json import said
from .words import Words

FORMAT, VERSION = "sens-fleet", 1
MACHINE, MEASURED = "machine.json", "measured.csv"
MOST_MEMBERS = 10_000
MOST_COLUMNS = 8  # effects that the table of the page shows beside each other


def members(folder) -> list[str]:
    """Names of the folders in `folder` that hold a machine or readings, in alphabetical order.

    Refuses a folder without any, and one with too many.
    """
    place = Path(folder)
    if not place.is_dir():
        raise Refused("fleet-no-folder", str(folder))
    found = sorted(
        p.name for p in place.iterdir() if p.is_dir() and ((p / MACHINE).is_file() or (p / MEASURED).is_file())
    )
    if not found:
        raise Refused("fleet-empty", str(folder))
    if len(found) > MOST_MEMBERS:
        raise Refused("fleet-too-many", str(folder), count=len(found), most=MOST_MEMBERS)
    return found


@dataclass(frozen=True)
class Reader:
    """Reads the machine and the readings of one folder in `folder`; can be sent to a worker."""

    folder: str

    def __call__(self, name: str):
        place = Path(self.folder) / name
        machine = machine_json.load(place / MACHINE)
        return machine, readings_csv.load(place / MEASURED, None, machine.joints)

    def note_inputs(self, names: Sequence[str]) -> None:
        """Record the files of the members as inputs, for workers that read them elsewhere."""
        for name in names:
            for path in (Path(self.folder) / name / MACHINE, Path(self.folder) / name / MEASURED):
                if path.is_file():
                    provenance.note_file(path)


# -- results -----------------------------------------------------------------------------------------------------------
def to_dict(result: FleetResult) -> dict:
    """fleet.json as plain data."""
    return {
        "format": FORMAT,
        "version": VERSION,
        "rate": result.rate,
        "p_limit": result.limit,
        "permutations": result.permutations,
        "seed": result.seed,
        "machines": [_member(m) for m in result.members],
        "recurring": [_recurring(r) for r in result.recurring],
    }


def _member(member: Member) -> dict:
    if member.refused:
        return {"name": member.name, "status": "refused", "message": member.refused}
    return {
        "name": member.name,
        "status": "done",
        "verdict": member.verdict,
        "held_out_rms_um": {"declared": member.declared, "augmented": member.augmented},
        "effects": [_effect(e) for e in member.effects],
    }


def _effect(effect: FleetEffect) -> dict:
    return {
        "component": effect.component,
        "driver": effect.driver,
        "shape": effect.shape,
        **said("title", effect.title),
        "p": effect.p,
        "amplitude_um": um(effect.amplitude),
        "held": effect.held,
    }


def _recurring(effect: Recurring) -> dict:
    return {
        "component": effect.component,
        "driver": effect.driver,
        "shape": effect.shape,
        **said("title", effect.title),
        "machines": list(effect.machines),
        "amplitude_um": [um(a) for a in effect.amplitudes],
        "median_amplitude_um": median_um(effect),
    }


COLUMNS = (
    "machine", "status", "verdict", "component", "driver", "shape", "p", "held", "amplitude_um",
    "declared_held_out_um", "augmented_held_out_um", "message",
)  # fmt: skip


def fleet_csv(result: FleetResult) -> str:
    """One line per effect of each machine; one line for a machine without any."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(COLUMNS)
    for m in result.members:
        if m.refused:
            writer.writerow([neutral(m.name), "refused", *[""] * 9, neutral(m.refused)])
            continue
        errors = [f"{m.declared:.6g}", f"{m.augmented:.6g}", ""]
        for e in m.effects:
            cells = [e.component, neutral(e.driver), e.shape, f"{e.p:.6g}", "yes" if e.held else "no"]
            writer.writerow([neutral(m.name), "done", m.verdict, *cells, f"{um(e.amplitude):.6g}", *errors])
        if not m.effects:
            writer.writerow([neutral(m.name), "done", m.verdict, *[""] * 6, *errors])
    return stream.getvalue()


def report(result: FleetResult, language: str = "en") -> str:
    """The page: which effect stands on how many machines, and every machine with its effects."""
    words = Words(language)
    traced = [m for m in result.members if not m.refused]
    shown = result.recurring[:MOST_COLUMNS]
    tiles = [
        (str(len(result.members)), words("fleet-machines")),
        (str(sum(any(e.held for e in m.effects) for m in traced)), words("fleet-with-effect")),
        (str(len(result.members) - len(traced)), words("fleet-refused")),
    ]
    causes = [_cause(words, r) for r in result.recurring]
    heads = [words("fleet-effect"), words("fleet-cause"), f"#{words('fleet-count')}", f"#{words('fleet-median')}"]
    heads.append(words("fleet-machines"))
    largest = max((a for r in shown for a in r.amplitudes), default=1.0)
    matrix = [
        [m.name, words(f"tr-verdict-{m.verdict.replace('_', '-')}"), *(_cell(r, m.name, largest) for r in shown)]
        for m in traced
    ]
    columns = [words("fleet-machine"), words("fleet-verdict"), *(f"{r.component} · {r.driver}" for r in shown)]
    parts = [html.tiles(tiles)]
    lead = words("fleet-lead", rate=100 * result.rate, limit=result.limit, permutations=result.permutations)
    parts.append(html.paragraph(lead, lead=True))
    if causes:
        parts.append(html.section(words("fleet-recurring"), html.table(heads, causes)))
    if traced:
        parts.append(html.section(words("fleet-picture"), html.table(columns, matrix)))
    refused = [(m.name, m.refused) for m in result.members if m.refused]
    if refused:
        columns = [words("fleet-machine"), words("fleet-why")]
        parts.append(html.section(words("fleet-not-traced"), html.table(columns, refused)))
    footer = words("report-footer", version=__version__, date=datetime.date.today().isoformat())
    return html.page(words("fleet-title"), words("fleet-subtitle"), *parts, footer=footer, language=language)


def _cause(words: Words, effect: Recurring) -> tuple:
    cause, size = f"{effect.component} · {effect.driver}", f"{median_um(effect):.3g} µm"
    return words.of(effect.title), cause, len(effect.machines), size, ", ".join(effect.machines)


def _cell(effect: Recurring, name: str, largest: float):
    """A bar as long as the effect is large on this machine; nothing where it does not stand."""
    if name not in effect.machines:
        return ""
    size = effect.amplitudes[effect.machines.index(name)]
    return html.join([html.meter(size, size, largest), f"{um(size):.3g} µm"])


def files(result: FleetResult, language: str = "en") -> dict[str, str]:
    """Name -> text of every file of the set."""
    return {
        "fleet.json": json_text.dumps(to_dict(result)),
        "fleet.csv": fleet_csv(result),
        "report.html": report(result, language),
    }
