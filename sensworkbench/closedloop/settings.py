# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every threshold of a trace, in one place: value, unit, and why it is what it is.  `plan` uses the same values.

A plan promises what a trace will decide, so neither has a limit of its own.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields


def _setting(default, unit: str, reason: str):
    return field(default=default, metadata={"unit": unit, "reason": reason})


CHI2, SHARE, NOISE, NATS, POINTS, COUNT = "chi-square", "share", "of one reading's noise", "nats", "points", "number"
ERRORS, PROBABILITY, RATIO = "standard errors", "probability", "ratio"


@dataclass(frozen=True)
class TraceSettings:
    """The limits of a trace.  `table()` lists them with unit and reason."""

    # what counts as structure, and as proof
    floor: float = _setting(0.2, NOISE, "structure below it is reported and never named: no table would be cut for it")
    alpha: float = _setting(0.01, PROBABILITY, "family-wise chance of a name where there is nothing")
    power: float = _setting(0.9, PROBABILITY, "chance that a plan gives an effect of the size it states")
    held_out: float = _setting(2.0, ERRORS, "gain on blocks left out that an effect must show")
    as_good: float = _setting(0.5, ERRORS, "of error on blocks left out within which candidates predict equally well")
    selection: float = _setting(0.8, SHARE, "of half-samples of blocks that must choose the effect or its equals")
    halves: int = _setting(100, COUNT, "half-samples: the share is then known to about .04")
    rival: float = _setting(9.0, CHI2, "what loses less after a refit is a rival (three standard errors)")
    rival_range: float = _setting(16.0, CHI2, "beyond it 'within two standard errors over blocks' says nothing")
    rival_errors: float = _setting(2.0, ERRORS, "of error on blocks left out within which a rival predicts as well")
    tolerance_margin: float = _setting(4.0, CHI2, "that the tolerances must prefer an equal explanation by to name it")
    class_range: float = _setting(25.0, CHI2, "candidates so near are one class where half-samples vote")
    detectable: float = _setting(6.0, NATS, "evidence of a surface below it is no structure (odds of 400)")
    certain: float = _setting(25.0, NATS, "evidence far beyond a choice among some thousand surfaces")
    suspicion: float = _setting(0.05, PROBABILITY, "of chance, below which more is looked for; it proves nothing")
    suspicion_score: float = _setting(4.0, "-log10 of p", "of one free form, above which more is looked for")
    visible: float = _setting(0.05, SHARE, "of a candidate that must show beside the declared model to be claimed")
    scan_visible: float = _setting(0.02, SHARE, "of a candidate that must show to be scanned: less is a fit of noise")
    same: float = _setting(0.95, "cosine", "a plan calls candidates alike that are closer; with readings rivals decide")
    pair_differs: float = _setting(1e-3, SHARE, "of two columns of a shape that must differ for both to be fitted")
    # names
    beyond_score: float = _setting(3.7, "standard deviations", "a free form that gains more beats the name (p 1e-4)")
    beyond_size: float = _setting(0.1, NOISE, "and is larger than this: less would change no prediction")
    line_ratio: float = _setting(4.0, RATIO, "a screw stands out of the other waves so much; roughness is many waves")
    piece: float = _setting(0.4, SHARE, "of its gain that a name must keep beside a free form of what was refused")
    largest_um: float = _setting(500.0, "um", "rms of an effect that is plausible on a machine that was measured in um")
    slow: float = _setting(0.05, SHARE, "of a column's variance that its steps have, below which time could replace it")
    slow_least: int = _setting(20, POINTS, "from which that can be said")
    # free forms: fine enough for what a machine does smoothly, few enough to be determined
    free_line: int = _setting(9, "order", "of a free form of one column")
    free_plane: int = _setting(6, "order", "of one of two columns that a name is compared with")
    free_more: int = _setting(4, "order", "of one of several columns, and of those that test a remainder")
    free_time: int = _setting(12, "order", "of a smooth function of time, in place of a slow column")
    free_time_factor: int = _setting(10, "order", "of one that multiplies other columns")
    free_refused: int = _setting(8, "order", "of one that stands for a refused effect")
    free_shown: float = _setting(1e-3, SHARE, "of a direction of a free form that must show beside the declared model")
    free_kept: float = _setting(1e-4, SHARE, "the same beside the model that holds the name: it may rest on less")
    harmonics: int = _setting(24, COUNT, "most waves of the free form of a period")
    levels_per_wave: int = _setting(3, COUNT, "places that each of them needs")
    points_per_wave: int = _setting(25, POINTS, "that each of them needs")
    waves_left: float = _setting(0.05, PROBABILITY, "of chance, below which the waves that are left are roughness")
    # surfaces, which locate what has no name
    bumps_coarse: int = _setting(8, COUNT, "of a column where all pairs of columns are compared; twice that for one")
    bumps: tuple[int, ...] = _setting((5, 8, 13, 20), COUNT, "of a column among which the evidence chooses")
    bumps_fine: int = _setting(30, COUNT, "the finest, for one column, and where the noise is known")
    bumps_most: int = _setting(200, COUNT, "in all while it is located: a fit is then quick")
    bumps_sharp: int = _setting(300, COUNT, "in all when it is drawn again, with the noise known")
    profile_bumps: tuple[int, ...] = _setting((8, 15, 28), COUNT, "of each of two profiles that are multiplied")
    profile_settled: float = _setting(1e-3, SHARE, "of chi-square that a further round of the profiles must gain")
    located: int = _setting(4, COUNT, "of the coarse surfaces that are refined")
    located_share: float = _setting(0.5, SHARE, "of the best one's evidence that they must have")
    located_components: int = _setting(6, COUNT, "that are searched: the shifts, and those of the leading free forms")
    few_levels: int = _setting(4, COUNT, "of values of a column that has no course between them, such as a load")
    # how many
    least_readings: int = _setting(12, COUNT, "readings below which nothing can be fitted and tested")
    least_dof: int = _setting(5, COUNT, "degrees of freedom below which noise is not known")
    least_direction: int = _setting(3, COUNT, "degrees of freedom of one direction of sensing that is judged alone")
    least_repeats: int = _setting(5, COUNT, "places that were read again, from which repeats give the noise")
    most_effects: int = _setting(4, COUNT, "effects added before the data are asked for more")
    tries: int = _setting(3, COUNT, "drivers tried per round before it is given up")
    leaders: int = _setting(3, COUNT, "of each shape that are tried as the first of two")
    rounds: int = _setting(3, COUNT, "of settling effects beside each other; they settle in one or two")
    settled_last: float = _setting(0.2, SHARE, "of the session, at its end, in which a warm-up must have settled")
    settled_range: float = _setting(0.15, SHARE, "of its range that it may still change there, to be held beyond")
    settled: float = _setting(1.0, CHI2, "a gain below it changes no decision, and ends the settling")
    polished: float = _setting(0.5, CHI2, "the same when final parameters are fitted")
    smooth_most: int = _setting(3, COUNT, "unnamed surfaces that a prediction may hold")
    smooth_floor: float = _setting(0.5, SHARE, "of the floor that the remainder must have for another one")
    scanned: int = _setting(4000, POINTS, "that a scan looks at; every fit takes all")
    pool: int = _setting(40, COUNT, "candidates that half-samples and blocks left out choose from")
    found: int = _setting(60, COUNT, "candidates that a search returns")
    found_second: int = _setting(10, COUNT, "the same beside each leader of a pair")
    found_range: float = _setting(60.0, CHI2, "behind the best that they may be")
    found_share: float = _setting(0.3, SHARE, "of the best score that they may be behind it, where that is more")
    found_least: float = _setting(12.0, CHI2, "gain of a candidate that is worth a fit of its own")
    found_components: int = _setting(12, COUNT, "on which the shapes that are not in the bank are tried")
    refined: int = _setting(30, COUNT, "candidates whose unknown parameters are refined")
    advice: int = _setting(6, COUNT, "further measurements that are proposed")
    # readings, their noise, and those that are none
    least_noise: float = _setting(1e-6, "mm", "of a reading: products of errors, which the model leaves out, reach it")
    same_tool: float = _setting(1e-3, "mm", "offsets of a tool that are nearer are the same tool, as files are written")
    outlier: float = _setting(5.0, "standard deviations", "a studentised residual beyond it is a gross outlier")
    least_free: float = _setting(0.05, SHARE, "of a reading that its leverage leaves, at least, in that test")
    biweight: float = _setting(6.0, "standard deviations", "beyond which Tukey's biweight counts a reading for nothing")
    crowd: float = _setting(0.1, SHARE, "of the points: more that are flagged are no gross outliers but structure")
    crowd_least: int = _setting(5, POINTS, "that are flagged, from which they can crowd in a column")
    crowd_flagged: float = _setting(1 / 3, SHARE, "of the readings of a stretch that are flagged: more are structure")
    crowd_stretch: float = _setting(0.5, SHARE, "of all readings: a longer stretch is no crowd")
    streak: int = _setting(3, POINTS, "flagged one after another that are structure")
    remembers: float = _setting(0.3, "correlation", "of successive residuals from which the noise is taken to remember")
    memory_least: float = _setting(0.2, "correlation", "of successive residuals in one direction; less is not modelled")
    memory_most: float = _setting(0.995, "correlation", "that is modelled: beyond it a difference is all that is left")
    memory_score: float = _setting(3.0, ERRORS, "that it must be above zero to be modelled")
    memory_rows: int = _setting(8, COUNT, "rows of one direction from which an uncertainty takes a correlation")
    memory_negative: float = _setting(-0.6, "correlation", "lowest that an uncertainty takes: alternation is rare")
    negative_score: float = _setting(2.5, ERRORS, "that a negative correlation must be below zero to count")
    memory_negligible: float = _setting(0.02, "correlation", "that changes no uncertainty by more than 2 %")
    other_weight: float = _setting(0.005, SHARE, "of another name, below which it changes no uncertainty")
    crowded: float = _setting(2.0, "per parameter", "degrees of freedom below which a candidate takes noise along")
    doubtful: float = _setting(0.2, PROBABILITY, "of chance, below which weights come from the fit without it, too")
    doubtless: float = _setting(2.0, RATIO, "to the largest of the null, from which no choice of weights matters")
    differenced: float = _setting(0.9999, "correlation", "at which rows are all but the steps from reading to reading")
    nearly: float = _setting(0.99, SHARE, "of the gain of a term: what explains so much explains all but the same")
    differencing: float = _setting(0.9, "correlation", "of successive residuals up to which they are always whitened")
    endless: float = _setting(0.9999, "correlation", "beyond which any number of readings count as one")
    block_memory: float = _setting(0.25, SHARE, "of a long block that memory may last to be whitened; else it drifts")
    drift: float = _setting(0.05, SHARE, "of the readings: residuals alike over so many are a drift, and no noise")
    drift_least: int = _setting(5, COUNT, "readings that this is at least")
    drift_score: float = _setting(4.0, ERRORS, "that their correlation must be above zero")
    wander_score: float = _setting(2.5, "standard errors", "of it from which names must show from reading to reading")
    short_blocks: int = _setting(30, COUNT, "blocks of readings where the noise does not remember")
    long_blocks: int = _setting(10, COUNT, "blocks where it does: they must be longer than its memory")
    misfit: float = _setting(0.01, PROBABILITY, "of chi-square, below which the stated u is contradicted")
    misfit_ratio: float = _setting(1.21, RATIO, "of chi-square, below which a stated u is right enough: a tenth of it")
    repeats_ratio: float = _setting(1.3, RATIO, "of residuals to repeats, above which something is not modelled")
    tilt: float = _setting(0.01, PROBABILITY, "of the runs' tilts, below which each run is aligned on its own")
    all_exchanges: int = _setting(120, COUNT, "exchanges of runs up to which all are made: those of five runs")
    # signs of the directions of sensing
    sign_gain: float = _setting(25.0, NATS, "of log-likelihood that turning a sign must gain")
    sign_share: float = _setting(0.05, "nats per reading", "the same in long tables, where every small misfit adds up")
    # motion that nobody logged
    unlogged_clip: float = _setting(3.0, NOISE, "residuals are drawn in to this, so that a few points make no motion")
    unlogged_margin: float = _setting(1.25, RATIO, "above the largest of the null: its name can be checked by nobody")
    unlogged_near: float = _setting(0.05, PROBABILITY, "that is stated where it comes nearer to the null than that")
    unlogged_least: int = _setting(30, COUNT, "readings of a direction, from which their spread is compared")
    unlogged_shows: float = _setting(0.05, SHARE, "of the strongest direction's lever: less says nothing there")
    unlogged_must: float = _setting(0.3, SHARE, "of it, from which a direction must follow the lever")
    unlogged_follows: float = _setting(0.02, PROBABILITY, "of chance, below which a direction follows the lever")
    unlogged_other: float = _setting(0.05, PROBABILITY, "of chance, below which the spread follows the places too")
    # words
    null_named: float = _setting(0.02, SHARE, "of the largest parameter of a combination that another has to be named")
    unsensed: float = _setting(1e-3, SHARE, "of the best sensed direction of space, below which one was not sensed")
    next_clear: float = _setting(4.0, NOISE, "difference from which a measurement separates; the cheapest is proposed")
    next_least: float = _setting(0.5, NOISE, "difference below which no reading at the tool separates")
    next_better: float = _setting(1.5, RATIO, "of the difference that a less simple measurement must bring")
    aliases: int = _setting(8, COUNT, "periods that are listed beside the one that is named")
    alias_shortest: float = _setting(0.5, "mm", "period that a machine can have")
    regular: float = _setting(0.02, SHARE, "of the pitch that places may vary by: every fold of a grid is an alias")
    # plans
    plan_simple: float = _setting(1.0, CHI2, "of cost: the candidates that an effect's name means, before all others")
    plan_periods: int = _setting(8, COUNT, "places along an axis, from which a period can be planned for")
    plan_levels: int = _setting(3, COUNT, "places along an axis, from which its periods are looked at")
    plan_constant: float = _setting(0.25, "periods", "over the travel: an alias that turns less looks constant")
    plan_worth: float = _setting(0.8, SHARE, "of itself that a number must fall below for an advice to be worth it")

    @classmethod
    def table(cls) -> list[tuple[str, object, str, str]]:
        """(name, value, unit, reason) of every setting."""
        return [(f.name, f.default, f.metadata["unit"], f.metadata["reason"]) for f in fields(cls)]


DEFAULT = TraceSettings()
