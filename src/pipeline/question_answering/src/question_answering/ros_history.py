"""What the robot did, and what comes next: replies, and the machine that runs."""

import threading
from collections import deque
from typing import Deque, Dict, Tuple

import rospy
from roboframenet_msgs.msg import Reply
from smach_msgs.msg import SmachContainerStatus, SmachContainerStructure

from question_answering.robot_knowledge import Deed, Outcome, steps_behind

#: Commands that are remembered.
_MOST_DEEDS = 20
#: Codes of replies to sentences that asked for nothing to be done.
_NO_DEEDS = frozenset(["TALK", "QUESTION", "EMPTY_TEXT", "DECLINED"])
#: Stages whose replies are about no deed: those to questions, and those to cries.
_ANSWERS, _CRIES = "question_answering", "stop_server"


class History:
    """Remembers how commands ended.

    Subscribes:
        reply (Reply), executor/smach/container_structure, executor/smach/container_status (smach_msgs)
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._deeds: Deque[Deed] = deque(maxlen=_MOST_DEEDS)
        self._children: Dict[str, Tuple[str, ...]] = {}
        self._active: Dict[str, Tuple[str, ...]] = {}
        self._subscribers = [
            rospy.Subscriber("reply", Reply, self._on_reply, queue_size=20),
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

    def _on_reply(self, reply: Reply) -> None:
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
