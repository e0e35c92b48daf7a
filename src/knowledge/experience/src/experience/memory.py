"""What the node remembers: the trials, what is known from them, and the rules."""

import uuid
from collections import deque
from dataclasses import replace
from typing import Deque, Dict, Iterable, List, Optional, Sequence, Tuple

from experience.known import Experience, learned_from
from experience.rules import Rule, RuleKind
from experience.store import MOST_RULES
from experience.trial import Judgement, Outcome, Trial


class Memory:
    """The trials and rules; one thread uses it.

    Attributes:
        experience: what is known of servers
        trials: the last ones, oldest first
    """

    def __init__(self, trials: Iterable[Trial] = (), rules: Iterable[Rule] = (), *, most_trials: int = 10_000) -> None:
        """
        Args:
            trials: oldest first
            rules: oldest first
            most_trials: that are remembered
        """
        self.trials: Deque[Trial] = deque(trials, maxlen=most_trials)
        self.experience: Experience = learned_from(self.trials)
        self._rules: Dict[str, Rule] = {rule.rule_id: rule for rule in rules}

    @property
    def rules(self) -> Tuple[Rule, ...]:
        """The rules, oldest first."""
        return tuple(self._rules.values())

    def hear(self, trial: Trial) -> Tuple[str, ...]:
        """Count a trial; returns the ids of rules that held once, and were followed by it."""
        self.trials.append(trial)
        self.experience.hear(trial)
        done = tuple(
            rule.rule_id
            for rule in self._rules.values()
            # The frame alone: the arguments are not kept.
            if rule.is_once and rule.frame in ("", trial.frame) and rule.names(trial.server)
        )
        for name in done:
            del self._rules[name]
        return done

    def last_deed(self) -> Tuple[Trial, ...]:
        """Return the trials of the last command that tried something."""
        if not self.trials:
            return ()
        command_id = self.trials[-1].command_id
        found: List[Trial] = []
        for trial in reversed(self.trials):
            if trial.command_id != command_id:
                break
            found.append(trial)
        return tuple(reversed(found))

    def judge(self, judgement: Judgement) -> Tuple[Trial, ...]:
        """Count what a person says of the last command: of what succeeded in it. Returns these trials."""
        deed = self.last_deed()
        judged = tuple(trial for trial in deed if trial.outcome is Outcome.SUCCEEDED)
        if judged:
            for _ in deed:
                self.trials.pop()
            for trial in deed:
                is_judged = trial.outcome is Outcome.SUCCEEDED
                self.trials.append(replace(trial, judgement=judgement) if is_judged else trial)
            self.experience = learned_from(self.trials)
        return judged

    def teach(
        self,
        kind: RuleKind,
        server: str,
        *,
        frame: str = "",
        thing: str = "",
        is_once: bool = False,
        said: str = "",
        now_s: float = 0.0,
    ) -> Optional[Rule]:
        """Add a rule, in place of one that says the same; returns it, None when there are too many."""
        rule = Rule(uuid.uuid4().hex[:8], kind, server, frame, thing, is_once, said, now_s)
        same = [one for one in self._rules.values() if one.sentence == rule.sentence]
        if same:
            return same[0]
        if len(self._rules) >= MOST_RULES:
            return None
        self._rules[rule.rule_id] = rule
        return rule

    def take_back(self, rules: Sequence[Rule]) -> None:
        """Drop rules."""
        for rule in rules:
            self._rules.pop(rule.rule_id, None)
