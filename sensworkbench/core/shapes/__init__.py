# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an error depends on its driver: one class per shape, all of them in `SHAPES` (see `base`)."""

from .base import SHAPES, Regressor, Shape, Varying, register, shape_class
from .functions import bump_features, hysteresis, lag, legendre, periods, to_domain
from .memory import Hysteresis, Lag
from .plain import MAX_DEGREE, Approach, Linear, Periodic, Polynomial, Power, Reversal, Step
from .smooth import Smooth

__all__ = [
    "MAX_DEGREE", "SHAPES", "Approach", "Hysteresis", "Lag", "Linear", "Periodic", "Polynomial", "Power", "Regressor",
    "Reversal", "Shape", "Smooth", "Step", "Varying", "bump_features", "hysteresis", "lag", "legendre", "periods",
    "register", "shape_class", "to_domain",
]  # fmt: skip
