"""Defines policies, which order the candidates of a clause.

A policy decides how the robot *does* something, and never how the framer *reads* it: it orders the candidates of one
reading at a time, the likeliest reading first. Within a reading, candidates that account for a larger share of the
words come first under every policy.
"""

import abc
import importlib
import itertools
import random
from typing import Callable, Dict, List, Optional, Sequence, Tuple, TypeVar, Union

from arbitrator.plan import Candidate, Plan, with_candidates
from arbitrator.standing import AnyOrder
from experience.ordering import Judge, reason_of
from experience.rules import Rule, forbidden, wanted
from experience.snapshot import Snapshot

AnyPlan = TypeVar("AnyPlan", bound=Union[Plan, AnyOrder])


class Policy(abc.ABC):
    """Orders candidates of one reading. Subclass it for a policy of your own.

    The constructor takes no argument but ``seed``.
    """

    def __init__(self, *, seed: Optional[int] = None) -> None:
        """Keep what the policy needs.

        Args:
            seed: of random policies: the same seed gives the same orders; None for a new seed each time
        """
        self.seed = seed

    def learn(self, known: Snapshot) -> None:  # noqa: B027 (most policies do not learn)
        """Hear what is known of servers now. Policies that do not learn ignore it."""

    def reason(self) -> str:
        """Return why the last order began with its first candidate, for a person; empty for no reason."""
        return ""

    @abc.abstractmethod
    def order(self, candidates: Sequence[Candidate]) -> List[Candidate]:
        """Return the same candidates, each once, in the order in which they are to be tried."""


class RandomPolicy(Policy):
    """A new random order for every command, as in 2012."""

    def __init__(self, *, seed: Optional[int] = None) -> None:
        super().__init__(seed=seed)
        self._random = random.Random(seed)

    def order(self, candidates: Sequence[Candidate]) -> List[Candidate]:
        """Shuffle."""
        shuffled = list(candidates)
        self._random.shuffle(shuffled)
        return shuffled


class InOrderPolicy(Policy):
    """The order in which the registrar found them."""

    def order(self, candidates: Sequence[Candidate]) -> List[Candidate]:
        """Leave them as they are."""
        return list(candidates)


class FewestStepsPolicy(Policy):
    """The shortest sequence first: fewer servers can fail."""

    def order(self, candidates: Sequence[Candidate]) -> List[Candidate]:
        """Sort by the number of frames; equal ones stay in the order of the registrar."""
        return sorted(candidates, key=lambda candidate: len(candidate.frames))


class LearnedPolicy(Policy):
    """What is likely to succeed soon comes first, by what was tried; with nothing known, the order of the registrar."""

    def __init__(self, *, seed: Optional[int] = None) -> None:
        super().__init__(seed=seed)
        self._known = Snapshot()
        self._reason = ""

    def learn(self, known: Snapshot) -> None:
        """Judge by this from now on."""
        self._known = known

    def order(self, candidates: Sequence[Candidate]) -> List[Candidate]:
        """Sort by the expected success and time. Nothing is drawn: the same knowledge gives the same order."""
        judged = Judge(self._known).judge([candidate.frames for candidate in candidates])
        ranked = sorted(judged, key=lambda one: -one.worth)
        self._reason = reason_of(ranked[0], judged, self._known) if ranked else ""
        return [candidates[one.position] for one in ranked]

    def reason(self) -> str:
        """Return what speaks for the first candidate of the last order."""
        return self._reason


# Coverage orders the tiers of every policy; most_coverage keeps the order inside each tier too.
POLICIES: Dict[str, Callable[..., Policy]] = {
    "random": RandomPolicy,
    "in_order": InOrderPolicy,
    "most_coverage": InOrderPolicy,
    "fewest_steps": FewestStepsPolicy,
    "learned": LearnedPolicy,
}


class PolicyError(ValueError):
    """A policy cannot be loaded, or does not return the candidates that it was given."""


def load_policy(name: str, *, seed: Optional[int] = None) -> Policy:
    """Make a policy.

    Args:
        name: a key of `POLICIES`, or ``package.module:ClassName`` of a subclass of `Policy`
        seed: seed for the policy

    Raises:
        PolicyError: no such policy, or it cannot be imported or made; the text says why and what exists
    """
    if name in POLICIES:
        return POLICIES[name](seed=seed)
    known = ", ".join(sorted(POLICIES))
    module_name, separator, class_name = name.partition(":")
    if not (separator and module_name and class_name):
        raise PolicyError(f"unknown policy {name!r}: expected one of {known}, or package.module:ClassName")
    try:
        module = importlib.import_module(module_name)
    except Exception as error:  # boundary: a module of a user may raise anything when it is imported
        raise PolicyError(f"policy {name!r}: cannot import {module_name!r}: {type(error).__name__}: {error}") from error
    policy_class = getattr(module, class_name, None)
    if policy_class is None:
        raise PolicyError(f"policy {name!r}: module {module_name!r} has no {class_name!r}")
    if not (isinstance(policy_class, type) and issubclass(policy_class, Policy)):
        raise PolicyError(f"policy {name!r}: {class_name!r} is not a subclass of arbitrator.policy.Policy")
    try:
        return policy_class(seed=seed)
    except Exception as error:  # boundary: a user's class may be abstract, or its constructor may raise anything
        raise PolicyError(f"policy {name!r} cannot be made: {type(error).__name__}: {error}") from error


def _tier(candidate: Candidate) -> Tuple[int, float]:
    return candidate.preference, -candidate.coverage


def _same_candidates(one: Sequence[Candidate], other: Sequence[Candidate]) -> bool:
    return sorted(map(id, one)) == sorted(map(id, other))


class Forbidden(ValueError):
    """A person has forbidden every way to carry a clause out as it was meant; the text is a sentence for the person."""


def arbitrate(
    plan: AnyPlan, policy: Policy, rules: Sequence[Rule] = (), *, trace: Optional[List[str]] = None
) -> AnyPlan:
    """Order the candidates of each clause of a plan by :func:`order`, as far as people have not said otherwise.

    Args:
        plan: with all candidates
        policy: orders the candidates of each tier
        rules: what people said of servers, oldest first: a server is no candidate, or comes first in its tier
        trace: gets a line for each rule that changed something, and for each reason of the policy

    Raises:
        PolicyError: like :func:`order`
        Forbidden: the rules leave no candidate of the likeliest reading of a clause
    """
    lines: List[str] = [] if trace is None else trace

    def change(candidates: Tuple[Candidate, ...]) -> Tuple[Candidate, ...]:
        allowed = _allowed(candidates, rules, lines)
        return _wanted_first(order(allowed, policy, trace=lines), rules, lines)

    arbitrated: AnyPlan = with_candidates(plan, change)
    return arbitrated


def _allowed(candidates: Tuple[Candidate, ...], rules: Sequence[Rule], trace: List[str]) -> Tuple[Candidate, ...]:
    verdicts = [(candidate, forbidden(candidate.frames, rules)) for candidate in candidates]
    broken = {rule.rule_id: rule for _, rule in verdicts if rule is not None}
    found = tuple(candidate for candidate, rule in verdicts if rule is None)
    likeliest = min(candidate.preference for candidate in candidates)
    if all(candidate.preference > likeliest for candidate in found):
        # What is left was not meant: a rule says how a thing is done, and does not make it another thing.
        said = "; ".join(rule.said or rule.sentence for rule in broken.values())
        raise Forbidden(f'I have no other way to do that, and you said: "{said}"')
    trace += [f"rule: {rule.sentence}: {len(candidates)} -> {len(found)} candidates" for rule in broken.values()]
    return found


def _wanted_first(candidates: Tuple[Candidate, ...], rules: Sequence[Rule], trace: List[str]) -> Tuple[Candidate, ...]:
    wishes = {id(candidate): wanted(candidate.frames, rules) for candidate in candidates}
    found = tuple(sorted(candidates, key=lambda one: (_tier(one), wishes[id(one)] is None)))
    rule = wishes[id(found[0])]
    if rule is not None:
        servers = ", ".join(frame.server.lstrip("/") for frame in found[0].frames)
        trace.append(f'rule: I asked {servers} first: you said "{rule.said or rule.sentence}"')
    return found


def order(
    candidates: Sequence[Candidate], policy: Policy, *, trace: Optional[List[str]] = None
) -> Tuple[Candidate, ...]:
    """Order the candidates of a clause by reading, then by coverage; the policy orders those that are equal.

    Args:
        candidates: of one clause
        policy: orders the candidates of each tier
        trace: gets the reason of the policy for the first candidate

    Raises:
        PolicyError: the policy raised, or returned other candidates than it was given
    """
    # sorted() is stable, so the policy sees each tier in the order of the registrar.
    ranked = sorted(candidates, key=_tier)
    ordered: List[Candidate] = []
    for _, members in itertools.groupby(ranked, key=_tier):
        tier = tuple(members)
        try:
            answer = list(policy.order(tier))
            why = policy.reason() if trace is not None and not ordered else ""
        except Exception as error:  # boundary: the policy of a user may raise anything
            raise PolicyError(f"policy {type(policy).__name__} failed: {type(error).__name__}: {error}") from error
        if not _same_candidates(tier, answer):
            raise PolicyError(
                f"policy {type(policy).__name__} must return each of the {len(tier)} candidates once, got {len(answer)}"
            )
        if why and trace is not None:
            trace.append(f"policy: {why}")
        ordered.extend(answer)
    return tuple(ordered)
