"""How Python, the C library and dask keep house in a process that computes: less often than they do by themselves.

Python and the C library look after memory at a pace that suits small objects. A plan of a cam makes some 300 000 pages
of large arrays and drops them again; handed back to the system each time, as dask has its workers do by
`MALLOC_TRIM_THRESHOLD_`, and as the C library does with more than some megabytes, they take half as long again as the
computation itself. And a worker of dask looks a hundred times a second where its computation is, for its dashboard:
where processes lost 1 % of their time, dask lost 6.5 %, and with a tenth of the looks 4 %.
"""

import ctypes
import gc
import sys
from contextlib import suppress
from functools import cache

# A process lives for seconds and makes few circles of objects: looking for them at Python's usual pace takes a tenth of
# its time.
_CIRCLES = 50_000, 20, 50
# Parameters of `mallopt` and bytes: memory below is taken from the process's own, and as much of it is kept when freed.
_TRIM, _MAP = (-1, 128 << 20), (-3, 32 << 20)
_LOOK_MS = 100  # between two looks of a dask worker at its computation; of itself it takes 10


@cache
def keep_pace() -> None:
    """Let this process compute without handing memory back and forth; it is for processes that are this program's."""
    gc.set_threshold(*_CIRCLES)
    _keep_memory()


def look_no_more() -> None:
    """Leave all objects as they are in a process that ends: Python would look for circles among them once more."""
    gc.freeze()


def compute_undisturbed() -> None:
    """Let a process that computes for others keep the memory that it has freed, and a worker of dask look seldom."""
    _keep_memory()
    distributed = sys.modules.get("distributed")
    if distributed is not None:
        with suppress(ValueError, AttributeError, KeyError):  # no worker, or one that does not look
            distributed.get_worker().periodic_callbacks["profile"].callback_time = _LOOK_MS


@cache
def _keep_memory() -> None:
    """Let this process keep up to 128 MB of what it has freed; only on Linux with the GNU C library."""
    if sys.platform == "linux":
        with suppress(OSError, AttributeError):  # another C library has no such function
            library = ctypes.CDLL(None)
            for parameter, size in (_MAP, _TRIM):
                library.mallopt(parameter, size)
