# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prices of tolerances in a panel: a file of them is asked for, read, and named beside its button."""

from __future__ import annotations

from pathlib import Path

from ..core.refusal import Refused
from ..formats import costs_csv
from . import messages
from .qt import translate


class Prices:
    """For a panel with `core`, a label `prices` and `forget()`: `costs`, and `costs_path`, the file of them."""

    costs_path = ""

    def ask_costs(self, *_) -> None:
        """Ask for a file of prices and read it."""
        path = messages.ask_open(translate("Sens", "Prices of tolerances"), "CSV (*.csv)")
        if path:
            self.load_costs(path)

    def load_costs(self, path) -> None:
        """Take the prices of a file; a refusal is shown, and the prices stay."""
        try:
            self.costs = costs_csv.load(path, self.core)
        except Refused as error:
            messages.show(messages.words(error))
            return
        self.costs_path = str(path)
        self.prices.setText(Path(path).name)
        self.prices.setToolTip(str(path))
        self.forget()
