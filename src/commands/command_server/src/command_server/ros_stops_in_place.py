"""Stops that the stop server does not carry out: this node does."""

from typing import Dict, Iterator

import rospy

from command_server.open_commands import STOP_STAGE, CommandText, Ending, ending_of_silent_stop
from command_server.pending_stops import PendingStops
from command_server.ros_emergency import EmergencyGate
from command_server.ros_events import Braking
from robot_stop.braking import Finding, StopOrder
from robot_stop.ros_brake import Brake, Braked


class StopsInPlace:
    """Carries them out, and finds out how the robot stands. One thread owns it."""

    def __init__(
        self,
        stops: PendingStops,
        brake: Brake,
        emergency: EmergencyGate,
        *,
        timeout_s: float,
        brake_answer_s: float,
        limit_s: float,
    ) -> None:
        """
        Args:
            stops: that were said
            brake: stops the robot
            emergency: engages the emergency stop
            timeout_s: how long the stop server has
            brake_answer_s: how long the brake may take to find out who obeys
            limit_s: longest time for which zero velocity is repeated
        """
        self._stops, self._brake, self._emergency = stops, brake, emergency
        self._timeout_s, self._brake_answer_s, self._limit_s = timeout_s, brake_answer_s, limit_s
        self._brakings: Dict[str, Braking] = {}

    @property
    def is_busy(self) -> bool:
        """Whether a stop is being carried out here."""
        return bool(self._brakings)

    def turn(self) -> Iterator[Ending]:
        """Carry out what the stop server does not, and yield how that ended."""
        for stop in self._stops.take_silent(brake_s=self._brake_answer_s):
            self._brakings[stop.command_id] = Braking()
            self._brake.stop(StopOrder(key=stop.command_id, stamp_ns=stop.stamp_ns))
            self._emergency.stop_in_place(stop.text)
            rospy.logerr("cmd=%s %s does not answer: this node stops the robot", stop.command_id, STOP_STAGE)
        for stop in self._stops.take_overdue():
            braking = self._brakings.pop(stop.command_id, Braking())
            standing = f"{braking.standing(stop.text, limit_s=self._limit_s)} {self._emergency.sentence}".strip()
            command = CommandText(command_id=stop.command_id, stamp_ns=stop.stamp_ns, text=stop.text)
            yield ending_of_silent_stop(command, timeout_s=self._timeout_s, standing=standing)

    def drop(self, stop_id: str) -> None:
        """The stop server carries it out after all."""
        self._brake.release(stop_id)
        self._brakings.pop(stop_id, None)

    def hear_braked(self, braked: Braked) -> None:
        """The brake has stopped the robot."""
        if braked.order.key in self._brakings:
            self._brakings[braked.order.key] = Braking(braked=braked)

    def hear_finding(self, finding: Finding) -> None:
        """The brake reports who obeys."""
        key = finding.order.key
        if key in self._brakings:
            self._brakings[key] = Braking(braked=self._brakings[key].braked, finding=finding)
