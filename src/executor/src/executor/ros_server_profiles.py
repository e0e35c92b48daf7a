"""What servers stated about themselves when they registered."""

from typing import Dict, Optional, Tuple

import rospy
from roboframenet_msgs.msg import FrameCatalogue

from typed_arguments import FilledFrame


class ServerProfiles:
    """Keeps from the latched catalogue what the executor needs to know of servers; any thread may ask."""

    def __init__(self, *, default_silence_s: float) -> None:
        """
        Args:
            default_silence_s: for how long a condition may be silent whose server states nothing
        """
        self._default_silence_s = default_silence_s
        self._silences: Dict[Tuple[str, str], float] = {}
        self._subscriber: Optional[rospy.Subscriber] = None

    def start(self) -> None:
        """Listen to the catalogue."""
        self._subscriber = rospy.Subscriber("frame_catalogue", FrameCatalogue, self._hear, queue_size=1)

    def longest_silence_s(self, frame: FilledFrame) -> float:
        """Return for how long the source of a condition may be silent."""
        return self._silences.get((frame.name, frame.server)) or self._default_silence_s

    def _hear(self, catalogue: FrameCatalogue) -> None:
        self._silences = {
            (callback.frame_name, callback.callback_topic): callback.profile.longest_silence.to_sec()
            for callback in catalogue.callbacks
        }
