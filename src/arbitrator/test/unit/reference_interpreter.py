"""What a plan means, said a second time: an interpreter without threads and without SMACH.

At each instant it asks the tree from the root down, the first child first, until nothing changes any more; then it
goes to the next instant at which something may change. Whoever is cancelled begins nothing more.

What happens at the same instant has an order: of all parts that can go on, the first one in the tree goes on first. So
when a branch decides, the branches before it end what they can end at that instant, and then the node around them goes
on, before a later branch begins anything.
"""

import math

from arbitrator import plan as p
from arbitrator.waiting_states import SHORTEST_ROUND_S


class Task:
    """A part that runs: a generator that pauses where it waits, and returns its outcome."""

    def __init__(self, interpreter, make):
        self.interpreter, self.is_cancelled, self.end = interpreter, False, None
        self.generator = make(self)

    def ask(self, is_cancelled):
        if is_cancelled and not self.is_cancelled:
            self.is_cancelled = self.interpreter.has_changed = True
        if self.end is None:
            try:
                next(self.generator)
            except StopIteration as stop:
                self.end, self.interpreter.has_changed = stop.value, True
        return self.end


class Watched:
    """A condition from now on: what its sources have said by then."""

    def __init__(self, interpreter, condition):
        self.interpreter, self.condition = interpreter, condition
        self.values, self.fault, self.was, self.has_begun = {}, "", set(), False
        self.news = []
        for place, leaf in enumerate(part for part in p.walk(condition) if isinstance(part, p.Condition)):
            source = interpreter.world.source(leaf.candidates[0].frames[0].name)
            answer_s = interpreter.now_s + source.answer_s
            self.news.append((answer_s, place, source.at(answer_s)))
            self.news += [(at_s, place, value) for at_s, value in source.changes if at_s > answer_s]
        self.news.sort(key=lambda one: one[:2])
        self.read()

    def read(self):
        while self.news and self.news[0][0] <= self.interpreter.now_s and not self.fault:
            _, place, value = self.news.pop(0)
            if isinstance(value, str):
                self.fault = value
            elif value is not None:
                self.values[place] = value
                holds = self.holds()
                self.has_begun |= holds is True and False in self.was
                self.was.add(holds)
        self.interpreter.wakes.update(at_s for at_s, _, _ in self.news)
        return self

    def holds(self):
        places = iter(range(1000))

        def truth(part):
            if isinstance(part, p.Condition):
                value = self.values.get(next(places))
            else:
                values = [truth(child) for child in part.children]
                pick = min if isinstance(part, p.AllOf) else max
                value = {0.0: False, 0.5: None, 1.0: True}[pick(0.5 if one is None else float(one) for one in values)]
            return None if value is None else value != part.is_negated

        return truth(self.condition)

    @property
    def has_triggered(self):
        return self.has_begun if self.condition.trigger is p.Trigger.BEGINS else True in self.was


class Interpreter:
    """Runs one plan in one world; `run` returns the outcome, and `log` is what happened."""

    def __init__(self, plan, world, *, longest_wait_s=1000.0):
        self.world, self.longest_wait_s = world, longest_wait_s
        self.now_s, self.log, self.attempts = 0.0, [], {}
        self.wakes, self.instants = {world.preempt_s, math.inf}, []
        #: Whether a branch has decided at the instant when the others were to begin: threads may do that in any order.
        self.has_race = False
        self.number = {id(part): number for number, part in enumerate(p.walk(plan))}
        self.root = Task(self, lambda task: self.node(task, plan))

    def run(self):
        while True:
            self.has_changed = True
            while self.has_changed and self.root.end is None:
                self.has_changed = False
                self.root.ask(self.now_s >= self.world.preempt_s)
            if self.root.end is not None:
                return self.root.end
            self.wakes = {at_s for at_s in self.wakes if at_s > self.now_s}
            self.now_s = min(self.wakes)
            self.instants.append(self.now_s)

    def write(self, text):
        self.log.append((self.now_s, text))

    def pause_until(self, task, end_s):
        self.wakes.add(end_s)
        while self.now_s < end_s and not task.is_cancelled:
            yield

    def node(self, task, part):
        if task.is_cancelled:
            return "preempted"
        self.write(f"{self.number[id(part)]} begins")
        limit_s = part.limit.seconds
        if isinstance(part, p.Wait) and part.condition is not None:
            limit_s = limit_s or self.longest_wait_s
        end_s = self.now_s + limit_s if limit_s else math.inf
        self.wakes.add(end_s)
        body = Task(self, lambda inner: getattr(self, type(part).__name__)(inner, part))
        is_late = False
        while body.ask(task.is_cancelled or is_late) is None:
            is_late = is_late or (self.now_s >= end_s and not task.is_cancelled)
            if not (is_late and not body.is_cancelled):
                yield
        outcome, ended_by = body.end if isinstance(body.end, tuple) else (body.end, "work")
        if outcome == "preempted" and is_late and not task.is_cancelled:
            outcome, ended_by = "aborted", "limit"
        self.write(f"{self.number[id(part)]} {outcome} by {ended_by}")
        return outcome

    def child(self, task, part):
        child = Task(self, lambda inner: self.node(inner, part))
        while child.ask(task.is_cancelled) is None:
            yield
        return child.end

    def chain(self, task, parts, goes_on):
        for part in parts:
            outcome = yield from self.child(task, part)
            if outcome != goes_on:
                return outcome
        return goes_on

    def goal(self, task, name):
        if task.is_cancelled:
            return "preempted"
        number = self.attempts[name] = self.attempts.get(name, -1) + 1
        attempt = self.world.attempt(name, number)
        self.write(f"goal {name}")
        outcome, end_s = attempt.outcome, self.now_s + attempt.duration_s
        yield from self.pause_until(task, end_s)
        if self.now_s < end_s:
            if attempt.heeds_cancel:
                outcome, end_s = "preempted", self.now_s + attempt.cancel_s
            self.wakes.add(end_s)
            while self.now_s < end_s:
                yield
        self.write(f"goal {name} {outcome}")
        return outcome

    def Do(self, task, part):  # noqa: N802 - named like the node
        for candidate in part.candidates:
            outcome = "succeeded"
            for frame in candidate.frames:
                outcome = yield from self.goal(task, frame.name)
                if outcome != "succeeded":
                    break
            if outcome != "aborted":
                return outcome
        return "aborted"

    def InSequence(self, task, part):  # noqa: N802
        return (yield from self.chain(task, part.children, "succeeded"))

    def InAnyOrder(self, task, part):  # noqa: N802
        return (yield from self.chain(task, [part.children[place] for place in part.order()], "succeeded"))

    def Fallback(self, task, part):  # noqa: N802
        return (yield from self.chain(task, part.children, "aborted"))

    def InParallel(self, task, part):  # noqa: N802
        children = [Task(self, lambda inner, one=one: self.node(inner, one)) for one in part.children]
        verdict, succeeded, began_s = "", 0, self.now_s
        while any(child.end is None for child in children):
            was = verdict
            for child in children:
                if child.end is None and child.ask(task.is_cancelled or bool(verdict)) and not verdict:
                    succeeded += child.end == "succeeded"
                    is_enough = succeeded == (part.count or len(children))
                    verdict = child.end if child.end != "succeeded" or is_enough else ""
                    self.has_race |= bool(verdict) and self.now_s == began_s and len(children) > 1
                if verdict != was:
                    break  # The first ones end first.
            if verdict == was and any(child.end is None for child in children):
                yield
        return verdict

    def known(self, task, watched):
        while not (watched.read().was & {True, False} or watched.fault or task.is_cancelled):
            yield
        if task.is_cancelled:
            return "preempted"
        return ("aborted", "fault") if watched.fault else None

    def If(self, task, part):  # noqa: N802
        watched = Watched(self, part.condition)
        end = yield from self.known(task, watched)
        if end:
            return end
        chosen = part.child if watched.holds() else part.otherwise
        return ("succeeded", "condition") if chosen is None else (yield from self.child(task, chosen))

    def Wait(self, task, part):  # noqa: N802
        if part.condition is None:
            yield from self.pause_until(task, self.now_s + part.duration_s)
            return "preempted" if task.is_cancelled else ("succeeded", "time")
        watched = Watched(self, part.condition)
        while not (watched.read().has_triggered or watched.fault or task.is_cancelled):
            yield
        if task.is_cancelled:
            return "preempted"
        return ("succeeded", "condition") if watched.has_triggered else ("aborted", "fault")

    def beside(self, task, part, verdict):
        """Carry out the child until `verdict` says how the node ends."""
        child = Task(self, lambda inner: self.node(inner, part.child))
        end = None
        while child.end is None:
            end = end or (None if task.is_cancelled else verdict())
            if child.ask(task.is_cancelled or end is not None) is None:
                yield
        return end or child.end

    def Until(self, task, part):  # noqa: N802
        if part.condition is None:
            end_s = self.now_s + part.duration_s
            self.wakes.add(end_s)
            return (yield from self.beside(task, part, lambda: (self.now_s >= end_s and ("succeeded", "time")) or None))
        return (yield from self.monitored(task, part, lambda watched: watched.has_triggered))

    def While(self, task, part):  # noqa: N802
        return (yield from self.monitored(task, part, lambda watched: False in watched.was))

    def monitored(self, task, part, is_over):
        watched = Watched(self, part.condition)

        def verdict():
            if is_over(watched.read()):
                return "succeeded", "condition"
            return ("aborted", "fault") if watched.fault else None

        end = yield from self.known(task, watched)
        return end or verdict() or (yield from self.beside(task, part, verdict))

    def Repeat(self, task, part):  # noqa: N802
        period_s = part.period_s if part.times else max(part.period_s, SHORTEST_ROUND_S)
        rounds, began_s = 1, self.now_s
        while True:
            outcome = yield from self.child(task, part.child)
            if outcome != "succeeded" or rounds == part.times:
                return outcome
            yield from self.pause_until(task, began_s + period_s)
            if task.is_cancelled:
                return "preempted"
            rounds, began_s = rounds + 1, max(self.now_s, began_s + period_s)
