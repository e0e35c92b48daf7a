"""Frames, lexical units and servers of the running graph."""

import queue
from typing import Iterator, Tuple

import rosgraph
import rospy
from roboframenet_msgs.msg import FrameCatalogue, FrameServers, Lexicon, StageEvent
from roboframenet_msgs.msg import World as WorldMessage

from command_server.settings import Settings as CommandServerSettings
from frame_registrar.node import Settings as FrameRegistrarSettings
from offline_pipeline.knowledge import Knowledge, load_texts
from offline_pipeline.pipeline import Parameters
from roboframenet_ros.parameters import ParameterError
from roboframenet_ros.ros_node import read_parameters
from roboframenet_ros.ros_waiting import wait_for_message
from semantic_framer.settings import Settings as SemanticFramerSettings
from semantic_frames.ros_server_profile import profile_from_message
from world_model import World
from world_model.ros_messages import world_from_message


def is_master_up() -> bool:
    """Whether a ROS master answers."""
    return bool(rosgraph.is_master_online())


def live_world(*, timeout_s: float) -> World:
    """Read the latched snapshot of what the robot knows; it knows of nothing where nobody publishes one.

    Args:
        timeout_s: how long to wait for it, seconds
    """
    _join()
    name = rospy.resolve_name("world")
    if name not in (topic for topic, _ in rospy.get_published_topics()):
        return World()
    try:
        return world_from_message(wait_for_message(name, WorldMessage, timeout_s))
    except rospy.ROSException:
        return World()


def live_knowledge(*, timeout_s: float) -> Knowledge:
    """Read the latched catalogue, servers and lexicon.

    Args:
        timeout_s: how long to wait for each, seconds
    Raises:
        LookupError: there is no master, or nothing publishes them
    """
    if not is_master_up():
        raise LookupError("no ROS master answers: start the pipeline, or omit --live")
    try:
        _join()
        catalogue = wait_for_message("frame_catalogue", FrameCatalogue, timeout_s)
        servers = wait_for_message("frame_servers", FrameServers, timeout_s)
        lexicon = wait_for_message("lexicon", Lexicon, timeout_s)
    except rospy.ROSException as error:
        raise LookupError(f"the pipeline is not up: {error}") from error
    knowledge = load_texts(
        [(file.path, lambda file=file: file.text) for file in catalogue.files],
        [(file.path, lambda file=file: file.text) for file in lexicon.files],
    )
    for callback in servers.callbacks:
        if callback.is_alive:
            profile = profile_from_message(callback.profile)
            knowledge.graph.register(callback.frame_name, callback.callback_topic, profile)
    return knowledge


def _join() -> None:
    if not rospy.core.is_initialized():
        rospy.init_node("rfn", anonymous=True, disable_signals=True)


def live_parameters() -> Parameters:
    """Read the parameters of the running nodes; a missing parameter has its default.

    Raises:
        LookupError: a value that the node would refuse
    """
    try:
        framer = read_parameters(SemanticFramerSettings, prefix="semantic_framer/")
        return Parameters(
            max_text_length=read_parameters(CommandServerSettings, prefix="command_server/").max_text_length,
            policy=framer.policy,
            max_candidates=read_parameters(FrameRegistrarSettings, prefix="frame_registrar/").max_candidates,
            arguments=framer.arguments,
            questions=framer.questions,
        )
    except ParameterError as error:
        raise LookupError(f"a parameter of the running graph is wrong: {error}") from error


def live_traces() -> Iterator[str]:
    """Yield the events of the stages about each command, as they come.

    Raises:
        LookupError: there is no master
    """
    if not is_master_up():
        raise LookupError("no ROS master answers: start the pipeline, or give a sentence and omit --live")
    _join()
    events: queue.Queue[StageEvent] = queue.Queue()
    subscriber = rospy.Subscriber("stage_events", StageEvent, events.put, queue_size=100)
    try:
        while not rospy.is_shutdown():
            try:
                yield describe_event(events.get(timeout=1.0))
            except queue.Empty:
                continue
    except KeyboardInterrupt:
        return
    finally:
        subscriber.unregister()


def describe_event(event: StageEvent) -> str:
    """Return the event of a stage as text, with the lines of its trace."""
    lines = [f'"{event.command.text}" {event.stage}: {event.sentence}']
    return "\n".join(lines + [f"  {line}" for line in event.trace.splitlines()])


#: Topics to which a PR2 subscribes, real or simulated; a robot that takes velocities and has no such arm counts as a
#: Turtlebot.
_ARM_GOAL = "r_arm_controller/joint_trajectory_action/goal"


def robots_up() -> Tuple[str, ...]:
    """Return the robots in the running graph, found by the subscriptions in each namespace."""
    _, subscribers, _ = rosgraph.Master("/rfn").getSystemState()
    topics = [topic for topic, nodes in subscribers if nodes]
    arms = {topic[: -len(_ARM_GOAL)] for topic in topics if topic.endswith("/" + _ARM_GOAL)}
    bases = {topic[: -len("cmd_vel")] for topic in topics if topic.endswith("/cmd_vel")}
    return ("turtlebot",) * len(bases - arms) + ("pr2",) * len(arms)
