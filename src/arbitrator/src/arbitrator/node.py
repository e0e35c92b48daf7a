"""The arbitrator node: candidates in, an ordered procedure out."""
import time
from dataclasses import dataclass
from typing import Optional

import rospy
from roboframenet_msgs.msg import CommandProcedure, CommandSemanticFrames, Procedure, Reply
from roboframenet_ros.ros_log import log_from_threads
from stage_events.ros_stage import Stage

from arbitrator.policy import Policy, PolicyError, arbitrate, load_policy
from arbitrator.ros_messages import candidates_from_message, procedure_to_message

# An executor that is just starting must not miss a command. Shorter than the time that it may be silent.
_LISTENER_TIMEOUT_S = 3.0


@dataclass(frozen=True)
class Settings:
    """Private parameters of the node.

    Attributes:
        policy: name of a policy, or ``package.module:ClassName``
        seed: of the policy; negative for a new one at each start
    """

    policy: str = "random"
    seed: int = -1

    def __post_init__(self) -> None:
        if not isinstance(self.policy, str) or not self.policy:
            raise ValueError(f"~policy must be a name, got {self.policy!r}")
        if isinstance(self.seed, bool) or not isinstance(self.seed, int):
            raise ValueError(f"~seed must be an integer, got {self.seed!r}")

    @property
    def policy_seed(self) -> Optional[int]:
        """The seed as policies take it."""
        return None if self.seed < 0 else self.seed


def read_settings() -> Settings:
    """Read the private parameters.

    Raises:
        ValueError: a parameter is out of its range
    """
    return Settings(policy=rospy.get_param("~policy", "random"), seed=rospy.get_param("~seed", -1))


class ArbitratorNode:
    """Orders the candidates of each command.

    Subscribes: ``command_semantic_frames``. Publishes: ``command_procedure``, ``procedure``, ``stage_events``.
    """

    def __init__(self, policy: Policy) -> None:
        self._policy = policy
        self._command_procedure = rospy.Publisher("command_procedure", CommandProcedure, queue_size=100)
        self._procedure = rospy.Publisher("procedure", Procedure, queue_size=100)
        self._stage = Stage("arbitrator")
        self._subscriber = rospy.Subscriber(
            "command_semantic_frames", CommandSemanticFrames, self._on_candidates, queue_size=100)

    def _on_candidates(self, message: CommandSemanticFrames) -> None:
        if not message.candidates.frame_lists:
            self._stage.ends(message.command, outcome=Reply.REFUSED, code="NO_SERVER",
                             sentence="Nothing that could carry this out is registered.")
            return
        try:
            procedure = arbitrate(candidates_from_message(message), self._policy)
        except (ValueError, PolicyError) as error:
            rospy.logerr("cmd=%s cannot be arbitrated: %s", message.command.id, error)
            self._stage.ends(message.command, outcome=Reply.FAILED, code="STAGE_ERROR",
                             sentence=f"The candidates could not be put in order: {error}.")
            return
        answer = procedure_to_message(procedure)
        ways = len(procedure.sequences)
        first = ", then ".join(f"{frame.name} by {frame.server}" for frame in procedure.sequences[0].frames)
        sentence = f"{ways} {'way' if ways == 1 else 'ways'} to do it; first {first}."
        rospy.loginfo("cmd=%s %s", message.command.id, sentence)
        self._wait_for_executor()
        # The event goes first so that an observer hears the stages in their order.
        self._stage.passes_on(message.command, sentence)
        self._command_procedure.publish(CommandProcedure(command=message.command, procedure=answer))
        self._procedure.publish(answer)

    def _wait_for_executor(self) -> None:
        end_s = time.monotonic() + _LISTENER_TIMEOUT_S
        while self._command_procedure.get_num_connections() == 0 and time.monotonic() < end_s:
            if rospy.is_shutdown():
                return
            time.sleep(0.01)


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    rospy.init_node("arbitrator")
    log_from_threads()
    try:
        settings = read_settings()
        policy = load_policy(settings.policy, seed=settings.policy_seed)
    except ValueError as error:
        rospy.logfatal("%s", error)
        raise SystemExit(f"arbitrator: {error}") from error
    rospy.loginfo("arbitrator: policy=%s seed=%s", settings.policy, settings.policy_seed)
    ArbitratorNode(policy)
    rospy.spin()
