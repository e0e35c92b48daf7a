"""What the robot did, and what comes next: replies, and the machine that runs."""

import threading
from collections import deque
from datetime import datetime
from typing import Deque, Dict, List, Tuple

import rospy
from roboframenet_msgs.msg import CommandPlan, PlanNode, Reply, TriedFrame
from smach_msgs.msg import SmachContainerStatus, SmachContainerStructure

from question_answering.deed_log import DeedLog, PlanKinds, PlannedNode, TriedClause, TriedOnce
from question_answering.robot_knowledge import Deed, Outcome, steps_behind
from typed_arguments.ros_messages import frame_that_was_tried, frames_from_messages, from_message

#: Commands that are remembered.
_MOST_DEEDS = 20
#: Codes of replies to sentences that asked for nothing to be done.
_NO_DEEDS = frozenset(["TALK", "QUESTION", "EMPTY_TEXT", "DECLINED"])
_KINDS = PlanKinds(PlanNode.DO, PlanNode.CONDITION, PlanNode.PARALLEL, PlanNode.REPEAT, PlanNode.WAIT)
#: Stages whose replies are about no deed: those to questions, and those to cries.
_ANSWERS, _CRIES = "question_answering", "stop_server"


class History:
    """Remembers how commands ended.

    Subscribes:
        reply (Reply), tried_frames (TriedFrame), running_plan (CommandPlan),
        executor/smach/container_structure, executor/smach/container_status (smach_msgs)
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._deeds: Deque[Deed] = deque(maxlen=_MOST_DEEDS)
        self._log = DeedLog(_KINDS)
        self._children: Dict[str, Tuple[str, ...]] = {}
        self._active: Dict[str, Tuple[str, ...]] = {}
        self._subscribers = [
            rospy.Subscriber("reply", Reply, self._on_reply, queue_size=20),
            rospy.Subscriber("tried_frames", TriedFrame, self._on_tried, queue_size=100),
            rospy.Subscriber("running_plan", CommandPlan, self._on_plan, queue_size=20),
            rospy.Subscriber(
                "executor/smach/container_structure", SmachContainerStructure, self._on_structure, queue_size=50
            ),
            rospy.Subscriber("executor/smach/container_status", SmachContainerStatus, self._on_status, queue_size=50),
        ]

    @property
    def deeds(self) -> Tuple[Deed, ...]:
        """The commands that have ended, the last one last."""
        with self._lock:
            return tuple(self._deeds)

    @property
    def next_steps(self) -> Tuple[str, ...]:
        """What comes after what runs: the steps behind the active one in the outermost machine that has steps."""
        with self._lock:
            for path in sorted(self._children, key=len):
                found = steps_behind(self._children[path], self._active.get(path, ()))
                if found:
                    return found
        return ()

    @property
    def tried(self) -> Tuple[TriedClause, ...]:
        """The clauses that were tried, the last one last."""
        with self._lock:
            return self._log.clauses

    @property
    def running_and_planned(self) -> Tuple[Tuple[PlannedNode, ...], Tuple[PlannedNode, ...]]:
        """The clauses that run now, and those that come later."""
        with self._lock:
            return self._log.running_and_planned()

    def _on_tried(self, message: TriedFrame) -> None:
        try:
            frame = frame_that_was_tried(message)
        except ValueError as error:
            rospy.logwarn("I forget a deed of %s: %s", message.command.id, error)
            return
        once = TriedOnce(
            frame,
            is_done=message.outcome == TriedFrame.SUCCEEDED,
            reason=message.reason,
            ended=datetime.now(),
            took_s=message.took.to_sec(),
        )
        with self._lock:
            self._log.add_tried(message.command.id, message.command.text, message.clause, once)

    def _on_plan(self, message: CommandPlan) -> None:
        try:
            nodes = planned_nodes(message)
        except ValueError as error:
            rospy.logwarn("I do not know what the plan of %s is: %s", message.command.id, error)
            return
        with self._lock:
            self._log.add_plan(message.command.id, nodes)

    def _on_reply(self, reply: Reply) -> None:
        with self._lock:
            self._log.end(reply.command.id)
        if reply.stage == _ANSWERS or reply.code in _NO_DEEDS:
            return
        with self._lock:
            self._deeds.append(
                Deed(reply.command.text, Outcome(reply.outcome), reply.sentence, is_stop=reply.stage == _CRIES)
            )

    def _on_structure(self, message: SmachContainerStructure) -> None:
        with self._lock:
            is_known = message.path in self._children
            if not is_known and not any(message.path.startswith(f"{path}/") for path in self._children):
                self._children, self._active = {}, {}
            self._children[message.path] = tuple(message.children)

    def _on_status(self, message: SmachContainerStatus) -> None:
        with self._lock:
            self._active[message.path] = tuple(message.active_states)


def planned_nodes(message: CommandPlan) -> Tuple[PlannedNode, ...]:
    """Return the nodes of a plan, with the frames of the first candidate of each clause, and their numbers."""
    nodes = message.plan.nodes
    numbers: Dict[int, int] = {}
    waiting: List[int] = [0] if nodes else []
    while waiting:
        position = waiting.pop()
        if position not in numbers:
            numbers[position] = len(numbers)
            waiting += reversed(nodes[position].children)
    found = []
    for position, node in enumerate(nodes):
        shared = [from_message(argument) for argument in node.arguments]
        first = node.candidates[:1]
        frames = tuple(frame for one in first for frame in frames_from_messages(one.frames, shared, one.arguments))
        children = tuple(node.children)
        found.append(PlannedNode(node.kind, children, numbers.get(position, 0), node.label, frames))
    return tuple(found)
