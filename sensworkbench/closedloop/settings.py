# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every threshold of a trace, in one place: value, unit, and why it is what it is.  `plan` uses the same values.

A plan promises what a trace will decide, so neither has a limit of its own.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields


def _setting(default, unit: str, reason: str):
    return field(default=default, metadata={"unit": unit, "reason": reason})


CHI2, SHARE, NOISE, NATS, POINTS, COUNT = "chi-square", "share", "of one reading's noise", "nats", "points", "number"


@dataclass(frozen=True)
class TraceSettings:
    """The limits of a trace.  `table()` lists them with unit and reason."""

    # what counts as structure, and as proof
    floor: float = _setting(0.2, NOISE, "structure below it is reported and never named: no table would be cut for it")
    alpha: float = _setting(0.01, "probability", "family-wise chance of a name where there is nothing")
    power: float = _setting(0.9, "probability", "chance that a plan gives an effect of the size it states")
    held_out: float = _setting(2.0, "standard errors", "gain on blocks left out that an effect must show")
    selection: float = _setting(0.8, SHARE, "of half-samples of blocks that must choose the effect or its equals")
    halves: int = _setting(100, COUNT, "half-samples: the share is then known to about .04")
    rival: float = _setting(9.0, CHI2, "what loses less after a refit is a rival (three standard errors)")
    rival_range: float = _setting(16.0, CHI2, "beyond it 'within two standard errors over blocks' says nothing")
    class_range: float = _setting(25.0, CHI2, "candidates so near are one class where half-samples vote")
    detectable: float = _setting(6.0, NATS, "evidence of a surface below it is no structure (odds of 400)")
    certain: float = _setting(25.0, NATS, "evidence far beyond a choice among some thousand surfaces")
    visible: float = _setting(0.05, SHARE, "of a candidate that must show beside the declared model to be claimed")
    same: float = _setting(0.95, "cosine", "a plan calls candidates alike that are closer; with readings rivals decide")
    # names
    beyond_score: float = _setting(3.7, "standard deviations", "a free form that gains more beats the name (p 1e-4)")
    beyond_size: float = _setting(0.1, NOISE, "and is larger than this: less would change no prediction")
    line_ratio: float = _setting(4.0, "ratio", "a screw stands out of the other waves so much; roughness is many waves")
    piece: float = _setting(0.4, SHARE, "of its gain that a name must keep beside a free form of what was refused")
    largest_um: float = _setting(500.0, "um", "rms of an effect that is plausible on a machine that was measured in um")
    # how many
    least_readings: int = _setting(12, COUNT, "readings below which nothing can be fitted and tested")
    least_dof: int = _setting(5, COUNT, "degrees of freedom below which noise is not known")
    most_effects: int = _setting(4, COUNT, "effects added before the data are asked for more")
    tries: int = _setting(3, COUNT, "drivers tried per round before it is given up")
    leaders: int = _setting(3, COUNT, "of each shape that are tried as the first of two")
    scanned: int = _setting(4000, POINTS, "that a scan looks at; every fit takes all")
    # noise
    remembers: float = _setting(0.3, "correlation", "of successive residuals from which the noise is taken to remember")
    memory_least: float = _setting(0.2, "correlation", "of successive residuals in one direction; less is not modelled")
    memory_score: float = _setting(3.0, "standard errors", "that it must be above zero to be modelled")
    differencing: float = _setting(0.9, "correlation", "of successive residuals up to which they are always whitened")
    block_memory: float = _setting(0.25, SHARE, "of a long block that memory may last to be whitened; else it drifts")
    drift: float = _setting(0.05, SHARE, "of the readings: residuals alike over so many are a drift, and no noise")
    drift_score: float = _setting(4.0, "standard errors", "that their correlation must be above zero")
    short_blocks: int = _setting(30, COUNT, "blocks of readings where the noise does not remember")
    long_blocks: int = _setting(10, COUNT, "blocks where it does: they must be longer than its memory")
    misfit: float = _setting(0.01, "probability", "of chi-square, below which the stated u is contradicted")
    tilt: float = _setting(0.01, "probability", "of the runs' tilts, below which each run is aligned on its own")
    # signs of the directions of sensing
    sign_gain: float = _setting(25.0, NATS, "of log-likelihood that turning a sign must gain")
    sign_share: float = _setting(0.05, "nats per reading", "the same in long tables, where every small misfit adds up")
    # motion that nobody logged
    unlogged_clip: float = _setting(3.0, NOISE, "residuals are drawn in to this, so that a few points make no motion")
    unlogged_margin: float = _setting(1.25, "ratio", "above the largest of the null: its name can be checked by nobody")

    @classmethod
    def table(cls) -> list[tuple[str, object, str, str]]:
        """(name, value, unit, reason) of every setting."""
        return [(f.name, f.default, f.metadata["unit"], f.metadata["reason"]) for f in fields(cls)]


DEFAULT = TraceSettings()
