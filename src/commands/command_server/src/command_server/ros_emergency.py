"""The emergency stop at the command server: commands are refused, and a person's words release it."""

import threading
import time
from dataclasses import dataclass
from typing import Callable, Mapping, Optional

import rospy
from roboframenet_msgs.msg import EmergencyStop
from std_srvs.srv import Trigger

from command_server.emergency_words import NOT_A_PERSON, is_emergency_stop
from command_server.open_commands import OWN_STAGE, STOP_STAGE, CommandText, Ending, Outcome
from roboframenet_ros.health import Health, Level
from roboframenet_ros.ros_service import ServiceError, call_service
from roboframenet_ros.suspension import SuspensionWatch
from robot_stop.emergency import CODE, engaged
from robot_stop.ros_brake import Brake
from robot_stop.ros_emergency import RELEASE, TOPIC, EmergencyWatch, emergency_file, emergency_to_message

#: Right after a suspension, what is heard may have been said long before, seconds.
_JUST_AWAKE_S = 0.5
#: For the service to exist, and for its answer, which the disk may delay; seconds.
_SERVICE_TIMEOUT_S, _ANSWER_TIMEOUT_S = 2.0, 6.0
#: How long the news of a release may take from the stop server to this node, seconds.
_NEWS_TIMEOUT_S = 1.0
#: How long a release may take in all, seconds.
RELEASE_TIMEOUT_S = _SERVICE_TIMEOUT_S + _ANSWER_TIMEOUT_S + _NEWS_TIMEOUT_S + 1.0


@dataclass(frozen=True)
class Released:
    """The answer of the stop server to words that release."""

    ending: Ending


class EmergencyGate:
    """Keeps commands out while the emergency stop holds, and holds the robot while the stop server is dead.

    Subscribes: ``emergency_stop``. Publishes: ``emergency_stop`` (latched), only when the stop server is silent. Calls:
    ``emergency_stop/release``.
    """

    def __init__(self, brake: Brake, *, on_released: Callable[[Released], None]) -> None:
        """
        Args:
            brake: holds the robot
            on_released: called with the answer to a release, from any thread; must not block
        """
        self._on_released = on_released
        self._file = emergency_file()
        self._publisher = rospy.Publisher(TOPIC, EmergencyStop, queue_size=10, latch=True)
        self._watch = EmergencyWatch(lambda state: brake.hold(state.is_engaged))
        brake.hold(self._watch.state.is_engaged)

    @property
    def sentence(self) -> str:
        """Why nothing moves, and how that ends; empty when the emergency stop does not hold."""
        return self._watch.state.sentence

    def refusal(self, command: CommandText) -> Optional[Ending]:
        """Return the ending of a command that is to begin now; None when the emergency stop does not hold."""
        held = self.sentence
        return Ending(command, Outcome.REFUSED, OWN_STAGE, CODE, held) if held else None

    def health(self, values: Mapping[str, object]) -> Health:
        """How the node is, with these values."""
        held = self.sentence
        return Health(Level.WARN, held, values) if held else Health(values=values)

    def stop_in_place(self, text: str) -> None:
        """The stop server is silent: engage what a cry asks for, and write it down.

        Args:
            text: of the cry
        """
        if not is_emergency_stop(text):
            return
        by, now_s = f'"{text.strip()}"', time.time()
        self._watch.know(engaged(self._watch.state, by=by, now_s=now_s))
        try:
            self._watch.know(self._file.update(self._watch.state, lambda known: engaged(known, by=by, now_s=now_s)))
        except OSError as error:
            rospy.logerr("%s cannot be written, a restart would forget the emergency stop: %s", self._file.path, error)
        self._publisher.publish(emergency_to_message(self._watch.state))

    def release(self, command: CommandText, *, is_played: bool, suspension: SuspensionWatch) -> None:
        """Ask the stop server to release it, for a person; returns at once.

        Args:
            command: the words
            is_played: whether they come from a bag
            suspension: of this process; behind one, they may be old
        """
        if is_played or suspension.is_just_awake(within_s=_JUST_AWAKE_S):
            sentence = f"{NOT_A_PERSON} {self.sentence}".strip()
            self._on_released(Released(Ending(command, Outcome.REFUSED, OWN_STAGE, CODE, sentence)))
            return
        threading.Thread(target=self._release, args=(command,), name="emergency_release", daemon=True).start()

    def _release(self, command: CommandText) -> None:
        try:
            answer = call_service(RELEASE, Trigger, timeout_s=_SERVICE_TIMEOUT_S, answer_timeout_s=_ANSWER_TIMEOUT_S)
        except ServiceError as error:
            sentence = f"The emergency stop is not released: {error}."
            self._on_released(Released(Ending(command, Outcome.FAILED, STOP_STAGE, "STAGE_SILENT", sentence)))
            return
        outcome, code = (Outcome.DONE, "DONE") if answer.success else (Outcome.REFUSED, CODE)
        # What is said right behind the reply must not be refused.
        end_s = time.monotonic() + _NEWS_TIMEOUT_S
        while answer.success and self.sentence and time.monotonic() < end_s:
            time.sleep(0.01)
        self._on_released(Released(Ending(command, outcome, STOP_STAGE, code, answer.message)))
