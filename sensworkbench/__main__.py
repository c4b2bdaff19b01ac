# SPDX-License-Identifier: LGPL-2.1-or-later
"""`python -m sensworkbench`."""

from __future__ import annotations

import sys

from sensworkbench.cli import main

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
