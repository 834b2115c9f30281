"""Spaces for the planners of OMPL, the Open Motion Planning Library (`pip install ompl`).

OMPL's states are those of its SE2StateSpace: x, y and a yaw from -π to π. Between two of them it goes straight, and turns the
shorter way. States and motions are checked exactly: no motion is sampled.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import BLOCKED
from ._errors import Error
from ._optional import optional
from ._results import Plan
from ._space import ContactSpace

base: Any = optional("ompl.base")
geometric: Any = optional("ompl.geometric")

# What OMPL calls the verdicts that leave nothing to look for.
_STATUS = base.PlannerStatus
_PROVED = {"no-path": _STATUS.INFEASIBLE, "from-blocked": _STATUS.INVALID_START, "to-blocked": _STATUS.INVALID_GOAL}


def _reach(space: ContactSpace) -> float:
    """The largest distance of the moving part's box from its origin."""
    x0, y0, x1, y1 = space.moving.bounds
    return math.hypot(max(-x0, x1), max(-y0, y1))


def _check(space: ContactSpace) -> None:
    if space.pair_class in ("fixed-axes", "lower"):
        raise Error(f"the pair is {space.pair_class}: OMPL's SE2StateSpace is that of two parts that move freely, in x, y and theta")


def _configuration(space: ContactSpace, state: Any) -> tuple[float, float, float] | None:
    """The configuration of a state, or None outside the window of orientations."""
    theta = state.getYaw()
    if space.window is not None:
        lo, hi = space.window
        theta = lo + (theta - lo) % math.tau
        if theta > hi:
            return None
    return state.getX(), state.getY(), theta


def state_space(space: ContactSpace, *configurations: ArrayLike, bounds: Sequence[float] | None = None) -> Any:
    """An SE2StateSpace of OMPL for positions in `bounds`, (x, y, x, y).

    Without bounds it is for all positions in which the parts can touch, for as far again, and for those of the configurations.
    """
    _check(space)
    if bounds is None:
        far = 2 * _reach(space)
        x0, y0, x1, y1 = space.fixed.bounds
        places = np.array([(x0 - far, y0 - far, 0), (x1 + far, y1 + far, 0), *configurations], dtype=np.float64)
        bounds = *places.min(axis=0)[:2], *places.max(axis=0)[:2]
    box = base.RealVectorBounds(2)
    for axis, (lo, hi) in enumerate(zip(bounds[:2], bounds[2:])):
        if not lo < hi:
            raise Error(f"`bounds` is {bounds!r}, which is empty: give the smallest x and y, and then the largest")
        box.setLow(axis, float(lo))
        box.setHigh(axis, float(hi))
    states = base.SE2StateSpace()
    states.setBounds(box)
    return states


class StateValidityChecker(base.StateValidityChecker):
    """Tells OMPL which states are valid: those that are free or in contact, exactly."""

    def __init__(self, si: Any, space: ContactSpace) -> None:
        super().__init__(si)
        _check(space)
        self.space = space

    def isValid(self, state: Any) -> bool:
        """Whether a state is free or in contact, and in the window of orientations."""
        at = _configuration(self.space, state)
        return at is not None and self.space.classify(at) != BLOCKED


class MotionValidator(base.MotionValidator):
    """Tells OMPL which straight motions are valid: those that are free all the way, exactly. They may begin and end in contact."""

    def __init__(self, si: Any, space: ContactSpace) -> None:
        super().__init__(si)
        _check(space)
        self.space = space

    def checkMotion(self, first: Any, second: Any) -> bool:
        """Whether the straight motion between two states is free; it turns the shorter way."""
        if (start := _configuration(self.space, first)) is None:
            return False
        turn = math.remainder(second.getYaw() - first.getYaw(), math.tau)
        by = second.getX() - first.getX(), second.getY() - first.getY(), turn
        moved = self.space.move(start, by)
        if moved.outcome == "contact":
            # It ends in contact, up to what is known of contacts.
            travel = math.hypot(*by[:2]) + _reach(self.space) * abs(turn)
            return (1 - moved.fraction) * travel <= self.space.resolution
        return moved.outcome == "free"


@dataclass(frozen=True)
class Planned:
    """OMPL's status, the planner's path n×3 if it has found one, and the answer of `space.plan`, which has a path of its own."""

    status: Any
    path: NDArray[np.float64] | None
    exact: Plan


def plan(
    space: ContactSpace, start: ArrayLike, goal: ArrayLike, seconds: float = 10.0, planner: Any = None, bounds: Any = None
) -> Planned:
    """A path by a planner of OMPL; where `space.plan` proves that there is none, nothing is sampled, and the status is INFEASIBLE.

    `planner` makes a planner of OMPL's space information: a class such as `ompl.geometric.RRTstar`; RRTConnect without. It is given
    at most `seconds`, and looks at positions in `bounds`, as `state_space` has them.
    """
    _check(space)
    exact = space.plan(start, goal)
    if exact.verdict in _PROVED:
        return Planned(_PROVED[exact.verdict], None, exact)
    states = state_space(space, start, goal, bounds=bounds)
    setup = geometric.SimpleSetup(states)
    si = setup.getSpaceInformation()
    si.setStateValidityChecker(StateValidityChecker(si, space))
    si.setMotionValidator(MotionValidator(si, space))
    given = np.array([start, goal], dtype=np.float64)
    ends = [states.allocState() for _ in given]
    for end, (x, y, theta) in zip(ends, given.tolist()):
        end.setX(x)
        end.setY(y)
        end.setYaw(math.remainder(theta, math.tau))
    setup.setStartAndGoalStates(*ends)
    setup.setPlanner((planner or geometric.RRTConnect)(si))
    solved = setup.solve(seconds)
    path = None
    if setup.haveExactSolutionPath():
        path = np.array([(s.getX(), s.getY(), s.getYaw()) for s in setup.getSolutionPath().getStates()])
        # Orientations run on, the shorter way from one to the next, and begin with the one that was given.
        path[:, 2] = np.unwrap([given[0, 2], *path[:, 2]])[1:]
    return Planned(solved.getStatus(), path, exact)
