# SPDX-License-Identifier: LGPL-2.1-or-later
"""`python -m sensworkbench`."""

from __future__ import annotations

import sys

if __name__ == "__main__":
    try:
        from sensworkbench.cli import main

        status = main(sys.argv[1:])
    except KeyboardInterrupt:  # while the program was still being imported
        status = 130
    sys.exit(status)
