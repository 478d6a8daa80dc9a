"""A version of a design to compute, and the answer; light to import, for the process that only sends them."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

from cadgen.errors import brief
from cadgen.progress import Progress

Stage = Literal["preview", "whole"]
State = Literal["done", "refused", "superseded", "fault"]


@dataclass(frozen=True)
class Job:
    """A version of a design to compute.

    Attributes:
        revision: number of the version.
        stage: `preview`, the actual cam alone, or `whole`.
        text: TOML.
        file: name of its file, for messages.
    """

    revision: int
    stage: Stage
    text: str
    file: str


@dataclass(frozen=True)
class Result:
    """Answer to a job.

    Attributes:
        state: `done`; `refused`, if the design cannot be computed; `superseded`, if a newer version was asked for
            meanwhile; `fault`, if it failed in a way that is none of the design's.
        body: JSON.
    """

    state: State
    body: bytes = b"{}"


Compute = Callable[[Job, Progress], Result]


def refusal(state: State, sentence: str, **more: Any) -> Result:
    """Result that says in a sentence why there is none."""
    return Result(state, json.dumps({"error": sentence, **more}, ensure_ascii=False).encode())


def fault(error: Exception) -> Result:
    """Result of a computation that failed in a way that is none of the design's."""
    return refusal("fault", fault_sentence(error))


def fault_sentence(error: Exception) -> str:
    """Sentence on an error that no design or request should cause."""
    summary = brief(f"{type(error).__name__}: {error}", 400)
    return f"a fault in cadgen, please report it with your design file ({summary})"
