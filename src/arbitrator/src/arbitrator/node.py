"""The arbitrator node: candidates in, an ordered plan out."""

from dataclasses import dataclass
from typing import List, Optional

import rospy
from roboframenet_msgs.msg import CommandPlan, CommandSemanticFrames, Experience, Procedure, Reply

from arbitrator.policy import Forbidden, Policy, PolicyError, arbitrate, load_policy
from arbitrator.procedure import describe
from arbitrator.ros_messages import any_from_message, plan_to_message, procedure_to_message
from arbitrator.standing import STANDING
from experience.ros_messages import snapshot_from_message
from experience.snapshot import Snapshot
from roboframenet_ros.health import Health
from roboframenet_ros.parameters import ParameterError, Parameters, parameter
from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_stage import Stage


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters of the node.

    Attributes:
        policy: name of a policy, or ``package.module:ClassName``
        seed: of the policy; negative for a new one at each start
    """

    policy: str = parameter("random", may_be_empty=False)
    seed: int = parameter(-1)

    @property
    def policy_seed(self) -> Optional[int]:
        """The seed for the policy; None for a random one."""
        return None if self.seed < 0 else self.seed


class ArbitratorNode:
    """Orders the candidates of each clause of a command.

    Subscribes: ``command_semantic_frames``, ``experience``. Publishes: ``command_plan``, ``command_standing_order``,
    ``procedure``, ``stage_events``.
    """

    def __init__(self, policy: Policy) -> None:
        self._policy = policy
        self._known = Snapshot()
        self._command_plan = HandOver("command_plan", CommandPlan)
        self._standing_order = HandOver("command_standing_order", CommandPlan)
        self._procedure = rospy.Publisher("procedure", Procedure, queue_size=100)
        self._stage = Stage("arbitrator")
        self._subscribers = [
            rospy.Subscriber("experience", Experience, self._on_experience, queue_size=1),
            rospy.Subscriber("command_semantic_frames", CommandSemanticFrames, self._on_candidates, queue_size=100),
        ]

    def health(self) -> Health:
        """How the node is."""
        return Health(values={"policy": type(self._policy).__name__})

    def _on_experience(self, message: Experience) -> None:
        try:
            self._known = snapshot_from_message(message)
        except ValueError as error:
            rospy.logerr_throttle(10.0, f"what is known of servers is malformed: {error}")

    def _on_candidates(self, message: CommandSemanticFrames) -> None:
        known = self._known
        trace: List[str] = []
        try:
            self._policy.learn(known)
            plan = arbitrate(any_from_message(message.plan), self._policy, known.rules, trace=trace)
        except Forbidden as reason:
            self._stage.ends(message.command, outcome=Reply.REFUSED, code="FORBIDDEN", sentence=str(reason))
            return
        except (ValueError, PolicyError) as error:
            rospy.logerr("cmd=%s cannot be arbitrated: %s", message.command.id, error)
            self._stage.ends(
                message.command,
                outcome=Reply.FAILED,
                code="STAGE_ERROR",
                sentence=f"The candidates could not be put in order: {error}.",
            )
            return
        topic = self._standing_order if isinstance(plan, STANDING) else self._command_plan
        if topic is self._standing_order and not topic.is_read:
            self._stage.ends(
                message.command,
                outcome=Reply.REFUSED,
                code="NO_SERVER",
                sentence="I can only act at once: nobody keeps standing orders (standing_orders is not running).",
            )
            return
        ordered = plan_to_message(plan)
        ordered.beginning = message.plan.beginning
        # The next stage works while the others are told.
        topic.publish(CommandPlan(command=message.command, plan=ordered))
        sentence = describe(plan)
        self._stage.passes_on(message.command, sentence, trace="\n".join(trace))
        rospy.loginfo("cmd=%s %s", message.command.id, sentence)
        procedure = procedure_to_message(plan)
        if procedure is not None:
            self._procedure.publish(procedure)


def start(place: Place) -> ArbitratorNode:
    """Start the stage.

    Raises:
        ParameterError: a parameter is wrong
    """
    settings = read_parameters(Settings, prefix=place.private)
    try:
        policy = load_policy(settings.policy, seed=settings.policy_seed)
    except PolicyError as error:
        raise ParameterError(str(error)) from error
    rospy.loginfo("arbitrator: policy=%s seed=%s", settings.policy, settings.policy_seed)
    return ArbitratorNode(policy)


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("arbitrator", lambda: start(Place()))
