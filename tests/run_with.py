# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run pytest under a Python that has no pytest of its own, with that of a virtual environment.

    /usr/bin/python3 tests/run_with.py .venv PYTEST-ARGS...

The packages of the environment come last on the path: numpy is the one that this Python has.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def main(environment: str, arguments: list[str]) -> int:
    """Return pytest's exit status."""
    sys.path[0] = str(ROOT)
    sys.path += [str(folder) for folder in Path(environment).glob("lib/python3*/site-packages")]
    import numpy
    import pytest

    print(f"Python {sys.version.split()[0]}, numpy {numpy.__version__}")
    return int(pytest.main(arguments))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
