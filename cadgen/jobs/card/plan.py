"""Plan of a card: the cam with its checks, and for each spacing the best setting, driven and checked."""

from dataclasses import dataclass

from cadgen.car.course.layout import Draw
from cadgen.car.draws.drawn_spacing import DrawnSpacing
from cadgen.design import cam_model, draw_model
from cadgen.design.schema import Design
from cadgen.jobs.cam.cam_plan import CamPlan, plan_cam
from cadgen.jobs.card.maker import TRIES, Maker
from cadgen.messages import Message
from cadgen.progress import Progress, silent


@dataclass(frozen=True)
class CardPlan:
    """Cam with the settings for every spacing that can be drawn.

    Attributes:
        cam: the cam, with its checks at the stated spacing.
        draw: the spacings.
        drawn: the settings, in the order of the spacings.
    """

    cam: CamPlan
    draw: Draw
    drawn: tuple[DrawnSpacing, ...]

    @property
    def design(self) -> Design:
        """Design of the cam."""
        return self.cam.car.design

    @property
    def passed(self) -> bool:
        """Whether the cam passes its checks, and keeps the course at every spacing."""
        return self.cam.passed and not any(each.failed for each in self.drawn)

    @property
    def worst(self) -> DrawnSpacing:
        """Spacing with the greatest remaining error."""
        return max(self.drawn, key=lambda each: each.error)


def plan_card(design: Design, profile: str | None = None, progress: Progress = silent) -> CardPlan:
    """Plan the cam of a design, and what to set for each spacing that can be drawn.

    Args:
        design: loaded design.
        profile: code of a profile; the default one of the design if left out.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the course has no range of spacing, the design does not say what can be set, or the settings
            cannot reach the range; or as `plan_cam`.
        CheckError: no profile keeps the limits of [optimize].
    """
    draw = draw_model.draw(design)
    draw_model.settings(design)
    rod = cam_model.rod(design, "a card of settings")
    draw_model.refuse_range(design, draw, cam_model.track(design), rod)
    return card_of(plan_cam(design, profile, progress), draw, progress)


def card_of(cam: CamPlan, draw: Draw, progress: Progress = silent, *, tries: int = TRIES) -> CardPlan:
    """Settings for every spacing with a cam that is planned.

    Args:
        cam: plan of the cam.
        draw: the spacings.
        progress: function that is called with a few words on each step.
        tries: settings that are sought for a spacing at which the course is not kept.
    """
    maker = Maker(cam, draw, tries)
    rows = []
    for spacing in draw.spacings:
        progress(Message("settings for posts {spacing:g} mm apart", spacing=spacing))
        rows.append(maker.drawn(spacing))
    return CardPlan(cam, draw, tuple(rows))
