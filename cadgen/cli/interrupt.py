"""Handling of signals: clear away the unfinished run, print one sentence, and end the process.

No exception is raised for it, since many a library swallows one or takes it for a fault of its own.
"""

import json
import os
import signal
import sys
from contextlib import suppress
from functools import partial
from types import FrameType

from cadgen.messages import Message, shown
from cadgen.output.files.folder import abandon

INTERRUPTED = 130
_message = Message("interrupted: nothing was written")
_told = str(_message)
_SHOW_CURSOR = "\r\x1b[K\x1b[?25h"  # and wipe the line: progress may be on show


_ENDING = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))


def install() -> None:
    """Handle the signals that end a process, except those that the caller ignores, as `nohup` does.

    The sentence in the chosen language is made here, for a handler reads no catalogue.
    """
    handler = partial(_interrupted, os.getpid())
    for number in _ENDING:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, handler)
    _announce(_message)


def resumable() -> None:
    """Have the sentence say that the results so far are kept."""
    _announce(Message("interrupted: results so far are kept, and the same command goes on where it was"))


def _announce(message: Message) -> None:
    global _message, _told
    _message, _told = message, shown(message)


def ignore() -> None:
    """Let a run that has done everything end with its own exit code.

    Python takes its handlers down before it ends, and from then on a signal would end the process by itself.
    """
    for number in _ENDING:
        signal.signal(number, signal.SIG_IGN)


def _interrupted(main: int, number: int, frame: FrameType | None) -> None:
    if os.getpid() == main:
        if not abandon():
            return
        # They would wait for work for ever.
        for child in getattr(sys.modules.get("multiprocessing"), "active_children", list)():
            child.kill()
        # Not through `sys.stdout` or `sys.stderr`, which may be amid writing.
        if "--json" in sys.argv:
            _say(1, json.dumps({"error": _message, "exit_code": INTERRUPTED}))
        else:
            plain = os.environ.get("TERM", "dumb") == "dumb" or not os.isatty(2)
            _say(2, f"{'' if plain else _SHOW_CURSOR}cadgen: {_told}")
    os._exit(INTERRUPTED)


def _say(stream: int, text: str) -> None:
    with suppress(OSError):  # nobody listens
        os.write(stream, f"{text}\n".encode())
