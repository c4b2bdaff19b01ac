# SPDX-License-Identifier: LGPL-2.1-or-later
"""`Refused` under the name by which every layer imports it; see `sensworkbench.messages`."""

from ..messages import Refused

__all__ = ["Refused"]
