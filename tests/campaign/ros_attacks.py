"""Attacks on a running robot: odd words, killed nodes, preemption, stops, storms, a long day, a lost master."""

import os
import random
import signal
import threading
import time
from contextlib import ExitStack
from typing import Any, Dict, List, Sequence

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from roboframenet_testing import comes_true, wait_until

from .demand import DAY, Demand, Figure, Trial, all_of, at_most, none_of, quantile, values
from .ros_robot import NODES, STAGES, Robot, running_robot, suspended
from .words import odd_text

_REPLY_S = 30.0


class OnRobot(Demand):
    """A demand whose trials share one running robot."""

    arguments: Sequence[str] = ()

    def running(self) -> ExitStack:
        """Start the robot and wait until it obeys."""
        with ExitStack() as opening:
            self.robot: Robot = opening.enter_context(running_robot(*self.arguments))
            self.robot.wait_until_ready()
            self.robot.wait_until_settled()
            return opening.pop_all()

    def be_ready(self) -> None:
        """Let the robot stand and every node run, whatever the last trial left behind."""
        self.robot.say("Stop.")
        wait_until(lambda: len(self.robot.pids()) == len(NODES), 60.0, "a node does not come back")
        self.robot.stand()
        for text in ("Ping.", "Turn left 1 degree."):
            wait_until(lambda text=text: self.robot.outcome_of(text, 5.0) == "DONE", 60.0, f"not done: {text}")
        # What comes later would count for the trial.
        comes_true(self.robot.is_all_answered, _REPLY_S)
        self.robot.forget()


class OddUtterances(OnRobot):
    """R1 on the running robot."""

    name, title = "R1-live", "odd utterances, said"
    counts = (60, 1000, 1000)

    def running(self) -> ExitStack:
        """Start the robot; examples of its units are what is made odd."""
        self._examples = [
            example.text for unit in load_knowledge([shipped_domains()]).lexicon.units for example in unit.examples
        ]
        stack = super().running()
        self._pids = self.robot.pids()
        return stack

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Say one; at the end of the trial every node still runs."""
        self.robot.forget()
        text = odd_text(self._examples, chance)
        since_s = asked_s = self.robot.say(text)
        # What arrives may differ from what was said: characters that are no text are replaced on the way.
        is_answered = comes_true(lambda: bool(self.robot.replies(since_s)), _REPLY_S)
        if not is_answered:
            # "Follow me" goes on until somebody ends it; then it has a reply, beside that of the stop.
            asked_s = self.robot.say("Stop.")
            is_answered = comes_true(lambda: len(self.robot.replies(since_s)) > 1, _REPLY_S)
        time.sleep(0.05)
        dead = sum(self._pids.get(node) != pid for node, pid in self.robot.pids().items()) if number % 20 == 19 else 0
        if dead:
            self._pids = self.robot.pids()
        replies = self.robot.replies(since_s)
        return {
            "unanswered": int(not is_answered),
            "doubled": self.robot.doubled(),
            "broken": sum(reply.code == "STAGE_ERROR" for _, reply in replies),
            "silent": sum(reply.code == "STAGE_SILENT" for _, reply in replies),
            "deaths": dead,
            "answer_s": replies[0][0] - asked_s if replies else None,
        }

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """One reply each, no death."""
        keys = ("unanswered", "doubled", "broken", "silent", "deaths")
        return [none_of(key, trials, key) for key in keys] + [at_most("answer", trials, "answer_s", 15.0)]


class KilledNodes(OnRobot):
    """R2: each node is killed in each phase of a command; replies are counted by text and id."""

    name, title = "R2", "kill -9 of each node in each phase"
    counts = (20, 200, 1000)
    is_without_tests = True
    _PHASES = ("idle", "said", "acting", "preempting", "stopping")

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Kill one node, and measure until the next command is done."""
        robot = self.robot
        node, phase = NODES[number % len(NODES)], self._PHASES[number // len(NODES) % len(self._PHASES)]
        self.be_ready()
        before = robot.pids()
        if phase in ("acting", "preempting", "stopping"):
            robot.drive()
        if phase in ("said", "preempting", "stopping"):
            robot.say({"said": "Turn left 30 degrees.", "preempting": "Turn right 40 degrees."}.get(phase, "Halt."))
            time.sleep(chance.uniform(0.0, 0.06))
        os.kill(before[node], signal.SIGKILL)
        killed_s = time.monotonic()
        done_s = None
        while done_s is None and time.monotonic() - killed_s < 30.0:
            if robot.outcome_of("Ping.", 0.4) == "DONE":
                done_s = time.monotonic() - killed_s
        moves_base = node in ("executor", "move_action_server", "turtlebot_sim", "command_server")
        is_at_rest = robot.stand()
        comes_true(lambda: len(robot.pids()) == len(NODES), 30.0)
        after = robot.pids()
        # A reply may be as late as the deadline of a stage.
        comes_true(robot.is_all_answered, _REPLY_S)
        unanswered, doubled = robot.counts()
        return {
            "node": node,
            "phase": phase,
            "next_done_s": done_s,
            "not_done": int(done_s is None),
            "bystanders": sum(after.get(name) != pid for name, pid in before.items() if name != node),
            "unanswered": unanswered,
            "doubled": doubled,
            "moving": int(not is_at_rest),
            "rest_s": max(0.0, robot.moved_s - killed_s) if phase == "acting" and moves_base else None,
        }

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Back soon, nobody else dies, each command has its one reply, and the base stands."""
        keys = ("not_done", "bystanders", "unanswered", "doubled", "moving")
        figures = [at_most("next command done", trials, "next_done_s", 5.0)]
        parser = [trial for trial in trials if trial["node"] == "stanford_parser_ros"]
        others = [trial for trial in trials if trial["node"] != "stanford_parser_ros"]
        figures += [
            at_most("... the parser, which loads its models", parser, "next_done_s", 5.0),
            at_most("... all others", others, "next_done_s", 5.0),
        ]
        figures += [none_of(key, trials, key) for key in keys]
        return figures + [at_most("at rest after the death of what moved it", trials, "rest_s", 1.0)]


class Preemption(OnRobot):
    """R4: a new command takes the place of one that runs."""

    name, title = "R4", "a command takes the place of another"
    counts = (30, 200, 1000)
    is_without_tests = True

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Drive, and say something else."""
        robot = self.robot
        robot.stand()
        robot.forget()
        robot.drive()
        time.sleep(chance.uniform(0.0, 0.3))
        robot.cancel_s.clear()
        robot.turn_goal_s.clear()
        said_s = robot.say(f"Turn left {chance.randint(5, 30)} degrees.")
        is_seen = comes_true(lambda: bool(robot.cancel_s and robot.turn_goal_s), 20.0)
        comes_true(lambda: len(robot.replies(said_s)) >= 2, 30.0)
        return {
            "missing": int(not is_seen),
            "cancel_s": robot.cancel_s[0] - said_s if robot.cancel_s else None,
            "goal_s": robot.turn_goal_s[0] - said_s if robot.turn_goal_s else None,
            "doubled": robot.doubled(),
        }

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """From the words, parse included."""
        return [
            none_of("missing", trials, "missing"),
            none_of("doubled", trials, "doubled"),
            at_most("words to cancel", trials, "cancel_s", 0.15, share=0.99),
            at_most("words to the new goal", trials, "goal_s", 0.3, share=0.99),
        ]


class Stops(OnRobot):
    """R5: "Stop." while the robot drives, with nodes that hang or have died."""

    name, title = "R5", '"Stop." while nodes hang or are dead'
    counts = (40, 1000, 1000)
    _VICTIMS = (*STAGES, "move_action_server", "ping")

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Drive, harm up to two nodes, and stop."""
        robot = self.robot
        self.be_ready()
        robot.drive()
        time.sleep(chance.uniform(0.0, 0.4))
        harm = chance.choice(("none", "none", "hang", "kill"))
        victims = chance.sample(self._VICTIMS, chance.randint(1, 2)) if harm != "none" else []
        pids = [pid for pid in (robot.pid_of(victim) for victim in victims) if pid]
        with ExitStack() as stack:
            if harm == "hang":
                stack.enter_context(suspended(pids))
            for pid in pids if harm == "kill" else ():
                os.kill(pid, signal.SIGKILL)
            robot.zero_s.clear()
            robot.cancel_s.clear()
            said_s = robot.say("Stop.")
            is_zero = comes_true(lambda: bool(robot.zero_s), 10.0)
            comes_true(lambda: bool(robot.cancel_s), 2.0)
            is_answered = comes_true(lambda: bool(robot.replies(said_s, "Stop.")), 10.0)
            is_standing = robot.stand()
        return {
            "harm": harm,
            "victims": victims,
            "zero_s": robot.zero_s[0] - said_s if is_zero else None,
            "cancel_s": robot.cancel_s[0] - said_s if robot.cancel_s else None,
            "no_zero": int(not is_zero),
            "unanswered": int(not is_answered),
            "moving": int(not is_standing),
            "doubled": robot.doubled(),
            "reply_s": robot.replies(said_s, "Stop.")[0][0] - said_s if is_answered else None,
        }

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Zero velocity and cancel at once, one reply, and the robot stands."""
        return [
            at_most("zero velocity", trials, "zero_s", 0.1, share=0.99),
            at_most("cancel", trials, "cancel_s", 0.1, share=0.99),
            Figure("reply", f"p50 {quantile(values(trials, 'reply_s'), 0.5):.3f} s"),
            *(none_of(key, trials, key) for key in ("no_zero", "moving", "unanswered", "doubled")),
        ]


class Storm(OnRobot):
    """R6: twenty voices at ten sentences a second."""

    name, title = "R6", "a storm: 20 voices, 10 sentences a second each"
    counts = (1, 2, 4)
    _TEXTS = ("Ping.", "Turn left 10 degrees.", "Speak.", "Dance a tango.", "Move forward 10 centimetres.", "Stop.", "")
    _SECONDS = 20.0

    def _say_much(self, chance: random.Random) -> int:
        """Let all voices speak; returns the number of sentences."""
        end_s = time.monotonic() + self._SECONDS
        counts = [0] * 20

        def speak(voice: int, words: random.Random) -> None:
            while time.monotonic() < end_s:
                self.robot.say(words.choice(self._TEXTS))
                counts[voice] += 1
                time.sleep(0.1)

        voices = [
            threading.Thread(target=speak, args=(voice, random.Random(chance.random()))) for voice in range(len(counts))
        ]
        for voice in voices:
            voice.start()
        for voice in voices:
            voice.join()
        return sum(counts)

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Say thousands of sentences twice, and wait until all are answered.

        The first storm fills what has a limit: the threads, and what a node keeps of the last seconds. The second one
        takes no more memory, unless something is kept for ever.
        """
        robot = self.robot
        self.be_ready()
        said = self._say_much(chance)
        comes_true(lambda: len(robot.replies()) >= said, 60.0)
        before = robot.memory_mb()
        said += self._say_much(chance)
        over_s = time.monotonic()
        comes_true(lambda: len(robot.replies()) >= said, 60.0)
        time.sleep(1.0)
        replies = robot.replies()
        after = robot.memory_mb()
        growth = max(after[node] / before[node] for node in before if node in after)
        return {
            "said": said,
            "unanswered": max(0, said - len(replies)),
            "doubled": robot.doubled(),
            "late_s": max(0.0, max((at_s for at_s, _ in replies), default=over_s) - over_s),
            "growth": growth,
            "next_s": robot.reply_to("Ping.", 10.0) is not None,
        }

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Bounded, each answered, memory stays."""
        growth = max(values(trials, "growth"))
        return [
            Figure("said", str(int(sum(values(trials, "said"))))),
            none_of("unanswered", trials, "unanswered"),
            none_of("doubled", trials, "doubled"),
            at_most("last reply after the last words", trials, "late_s", 2.0),
            Figure("largest growth of memory", f"{100 * (growth - 1):.1f} %", "< 10 %", growth < 1.1),
            all_of("the next command is answered", trials, "next_s"),
        ]


class LongDay(OnRobot):
    """R12: a command every two seconds, and now and then a node dies."""

    name, title = "R12", "a long day: a command every 2 s, a kill now and then"
    # Two hours and eight hours, with the start and the end of the robot.
    counts = (120, 3560, 14360)
    lane = DAY
    _PACE_S = 2.0
    _TEXTS = (
        "Ping.",
        "Turn left 10 degrees.",
        "Turn right 10 degrees.",
        "Speak.",
        "Dance a tango.",
        "What can you do?",
    )

    def running(self) -> ExitStack:
        """Start the robot; its day begins."""
        stack = super().running()
        self._next_s = time.monotonic()
        return stack

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Say one sentence; every 300th trial kills a node, and every 30th looks at the memory.

        The first look comes after a minute: before, nodes still load. A trial that was late does not make the day
        longer: the next ones follow sooner.
        """
        robot = self.robot
        self._next_s += self._PACE_S
        robot.forget()
        text = chance.choice(self._TEXTS)
        found: Dict[str, Any] = {"killed": ""}
        if number % 300 == 299:
            found["killed"] = chance.choice([node for node in NODES if node != "turtlebot_sim"])
            os.kill(robot.pid_of(found["killed"]), signal.SIGKILL)
        found["unanswered"] = int(robot.reply_to(text, _REPLY_S) is None)
        found["doubled"] = robot.doubled()
        if number % 30 == 29:
            found["memory_mb"] = robot.memory_mb()
        time.sleep(max(0.0, self._next_s - time.monotonic()))
        return found

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Each answered; no node grows."""
        looked = [trial["memory_mb"] for trial in trials if trial.get("memory_mb")]
        settled = looked[len(looked) // 10 :] or looked
        first, last = settled[0], settled[-1]
        growth = max((last[node] / first[node] for node in first if node in last), default=1.0)
        return [
            none_of("unanswered", trials, "unanswered"),
            none_of("doubled", trials, "doubled"),
            Figure("kills", str(sum(bool(trial["killed"]) for trial in trials))),
            Figure("largest growth of memory", f"{100 * (growth - 1):.1f} %", "< 10 %", growth < 1.1),
        ]


class LostMaster(Demand):
    """R18: the master is killed or hangs while the robot drives."""

    name, title = "R18", "the master is killed or hangs"
    counts = (2, 10, 20)

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Start a robot in a process of its own, and take its master away."""
        from .ros_lost_master import in_own_process

        return in_own_process("hang" if number % 2 else "kill")

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """A stop works without a master, and every command is answered."""
        return [
            at_most("zero velocity", trials, "zero_s", 0.1),
            *(none_of(key, trials, key) for key in ("moving", "unanswered")),
            Figure("master", ", ".join(str(trial["how"]) for trial in trials)),
        ]
