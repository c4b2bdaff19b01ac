# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who does work that consists of independent parts: this process, several processes, or a Dask cluster."""

from __future__ import annotations

import contextlib

from sensworkbench.core.refusal import Refused

from . import common

MOST_WORKERS = 256


def add_workers(parser, of: str) -> None:
    """Add --workers and --scheduler.  of : what the workers do, for --help."""
    parser.add_argument("--workers", metavar="N", type=common.whole, default=1, help=f"processes that {of} (default 1)")
    text = f"{of} on a Dask cluster instead (needs sensworkbench[cluster])"
    parser.add_argument("--scheduler", metavar="ADDRESS", help=text)


def check_workers(arguments) -> None:
    """Refuse a number of workers that is out of range."""
    if not 1 <= arguments.workers <= MOST_WORKERS:
        raise Refused("sweep-workers", "--workers", count=arguments.workers, most=MOST_WORKERS)


@contextlib.contextmanager
def executor(arguments):
    """(executor or None, number of workers) that the arguments of `add_workers` ask for."""
    if arguments.scheduler:
        try:
            from distributed import Client
        except ImportError:
            raise Refused("cluster-missing", "--scheduler") from None
        try:
            client = Client(arguments.scheduler, timeout="10s")
        except (OSError, ValueError):
            raise Refused("cluster-silent", "--scheduler", address=arguments.scheduler[:80]) from None
        with client:
            yield client.get_executor(pure=False), max(1, len(client.scheduler_info()["workers"]))
    elif arguments.workers > 1 and common.in_freecad():  # which cannot start further Pythons of its own kind
        common.say("inside FreeCAD one process does the work; run with a Python that has numpy to use --workers")
        yield None, 1
    elif arguments.workers > 1:
        import multiprocessing
        from concurrent.futures import ProcessPoolExecutor

        context = multiprocessing.get_context("spawn")
        with ProcessPoolExecutor(arguments.workers, mp_context=context) as pool:
            yield pool, arguments.workers
    else:
        yield None, 1
