"""What servers stated about themselves when they registered."""

import json
from typing import Callable, Dict, FrozenSet, Optional, Tuple

import rospy
from roboframenet_msgs.msg import FrameServers, ServerProfile

from executor.driver_settings import Setting, SettingsError, Value
from semantic_frames.server_profile import NOTHING
from typed_arguments import FilledFrame


class ServerProfiles:
    """Keeps from the latched topic what the executor needs to know of servers; any thread may ask."""

    def __init__(
        self, on_change: Callable[[FrozenSet[str]], None] = lambda _: None, *, default_silence_s: float
    ) -> None:
        """
        Args:
            on_change: called with the servers that live, from a thread of rospy, when a server was added or is gone
            default_silence_s: for how long a condition may be silent whose server states nothing
        """
        self._on_change = on_change
        self._default_silence_s = default_silence_s
        self._profiles: Dict[Tuple[str, str], ServerProfile] = {}
        self._subscriber: Optional[rospy.Subscriber] = None

    def start(self) -> None:
        """Listen to the registrar."""
        self._subscriber = rospy.Subscriber("frame_servers", FrameServers, self._hear, queue_size=1)

    def longest_silence_s(self, frame: FilledFrame) -> float:
        """Return for how long the source of a condition may be silent."""
        return self._profile(frame).longest_silence.to_sec() or self._default_silence_s

    def longest_goal_s(self, frame: FilledFrame, most_s: float) -> float:
        """Return how long a goal may take.

        Args:
            frame: the goal
            most_s: limit for every goal
        """
        return min(self._profile(frame).longest_goal.to_sec() or most_s, most_s)

    def resources(self, frame: FilledFrame) -> Optional[FrozenSet[str]]:
        """Return what a goal occupies: base, arms, voice; None for everything."""
        occupies = self._profile(frame).occupies
        return frozenset(occupies) - {NOTHING} if occupies else None

    def settings(self, frame: FilledFrame) -> Tuple[Setting, ...]:
        """Return the settings of other nodes that a goal needs.

        Raises:
            SettingsError: a value is no JSON scalar
        """
        return tuple(
            Setting(setting.node, setting.name, _value(setting.name, setting.value))
            for setting in self._profile(frame).settings
        )

    def _profile(self, frame: FilledFrame) -> ServerProfile:
        return self._profiles.get((frame.name, frame.server)) or ServerProfile()

    def _hear(self, message: FrameServers) -> None:
        self._profiles = {
            (callback.frame_name, callback.callback_topic): callback.profile for callback in message.callbacks
        }
        self._on_change(
            frozenset(one.callback_topic for one in message.callbacks if one.is_alive and one.callback_topic)
        )


def _value(name: str, text: str) -> Value:
    try:
        value = json.loads(text)
    except ValueError:
        value = None
    if not isinstance(value, (bool, int, float, str)):
        raise SettingsError(f"{name}: expected a JSON scalar, found {text!r}")
    return value
