"""The robot of the server for agents: topics to values, and calls to topics."""

import time
from typing import Any, Callable, Dict, List, Mapping, Optional

import rospy
from actionlib_msgs.msg import GoalID
from roboframenet_msgs.msg import (
    Clause,
    Command,
    CommandLexicalUnits,
    EmergencyStop,
    ExecuteCommandActionGoal,
    ExecuteCommandGoal,
    FilledFrameElement,
    FilledLexicalUnit,
    FrameCatalogue,
    FrameServers,
    LexicalUnitReading,
    Plan,
    Reply,
    StageEvent,
    TriedFrame,
)
from roboframenet_msgs.msg import World as WorldMessage

from agent_server.agent_names import who_asked
from agent_server.deeds import Deed, DeedLog
from agent_server.filled_call import FilledCall
from agent_server.frame_tool import FrameTool, Server, frame_tools
from agent_server.own_tools import LONGEST_SENTENCE
from agent_server.robot import NEEDS_INFORMATION, Answer, Progress
from agent_server.words import OpenQuestion
from command_server.open_commands import Outcome
from roboframenet_ros.bounded_text import one_line
from semantic_frames import load_frame
from semantic_frames.frame import SemanticFrame
from semantic_frames.read_once import ReadOnce
from semantic_frames.ros_server_profile import profile_from_message
from typed_arguments.ros_messages import to_message
from world_model import World
from world_model.ros_messages import world_from_message

_OUTCOMES: Mapping[int, str] = {one.value: one.name for one in Outcome}
_RESULTS: Mapping[int, str] = {TriedFrame.SUCCEEDED: "succeeded", TriedFrame.FAILED: "failed"}


class GraphRobot:
    """What the graph tells of the robot. Its attributes are for the thread of the event loop.

    Subscribes: ``frame_catalogue``, ``frame_servers``, ``world``, ``emergency_stop``, ``reply``, ``stage_events``,
    ``tried_frames``. Publishes: ``called_frames``, ``called_frames/cancel``, ``command/goal``, ``command/cancel``.
    """

    def __init__(
        self, call_soon: Callable[..., object], *, hear: Callable[[object], None], on_tools: Callable[[], None]
    ) -> None:
        """Connect.

        Args:
            call_soon: calls a function in the thread of the event loop, from any thread
            hear: called with each `Progress` and `Answer`, in that thread
            on_tools: called when other frames can be carried out, or other arguments are heeded, in that thread
        """
        self._call_soon = call_soon
        self._hear = hear
        self._on_tools = on_tools
        self.tools: Mapping[str, FrameTool] = {}
        self.world = World()
        self.question: Optional[OpenQuestion] = None
        self.emergency = ""
        self.deeds = DeedLog()
        self._emergency_number = -1
        self._files: ReadOnce[SemanticFrame] = ReadOnce(load_frame)
        self._frames: List[SemanticFrame] = []
        self._servers: Dict[str, List[Server]] = {}
        self._called: Dict[str, bool] = {}
        self._calls = rospy.Publisher("called_frames", CommandLexicalUnits, queue_size=100)
        self._call_cancels = rospy.Publisher("called_frames/cancel", GoalID, queue_size=100)
        self._goals = rospy.Publisher("command/goal", ExecuteCommandActionGoal, queue_size=100)
        self._goal_cancels = rospy.Publisher("command/cancel", GoalID, queue_size=100)
        self._subscribers = [
            rospy.Subscriber("reply", Reply, self._later(self._on_reply), queue_size=100),
            rospy.Subscriber("stage_events", StageEvent, self._later(self._on_event), queue_size=1000),
            rospy.Subscriber("tried_frames", TriedFrame, self._later(self._on_tried), queue_size=100),
            rospy.Subscriber("emergency_stop", EmergencyStop, self._later(self._on_emergency), queue_size=10),
            rospy.Subscriber("world", WorldMessage, self._on_world, queue_size=1),
            rospy.Subscriber("frame_catalogue", FrameCatalogue, self._on_catalogue, queue_size=1),
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
        ]

    def call(self, command_id: str, call: FilledCall, *, asked_by: str) -> bool:
        """Call a frame; return whether somebody listens."""
        if self._calls.get_num_connections() == 0:
            return False
        self._called[command_id] = True
        text = one_line(f"{asked_by}: {call.words}")[:LONGEST_SENTENCE]
        unit = FilledLexicalUnit(
            frame_name=call.frame_name,
            frame_elements=[FilledFrameElement(name=one.name, argument=one.text) for one in call.arguments],
        )
        reading = LexicalUnitReading(
            lexical_unit=unit, arguments=[to_message(one) for one in call.arguments], coverage=1.0
        )
        self._calls.publish(
            CommandLexicalUnits(
                command=Command(id=command_id, stamp=rospy.Time.now(), text=text),
                clauses=[Clause(readings=[reading], words=call.words[:LONGEST_SENTENCE])],
                plan=Plan(beginning=getattr(Plan, call.beginning)),
            )
        )
        return True

    def say(self, command_id: str, text: str) -> bool:
        """Say a sentence, as programs do; return whether somebody listens."""
        if self._goals.get_num_connections() == 0:
            return False
        self._called[command_id] = False
        now = rospy.Time.now()
        goal = ExecuteCommandActionGoal(goal_id=GoalID(stamp=now, id=command_id), goal=ExecuteCommandGoal(text=text))
        goal.header.stamp = now
        self._goals.publish(goal)
        return True

    def cancel(self, command_id: str) -> None:
        """Cancel a command that this server gave; nothing for any other."""
        is_call = self._called.pop(command_id, None)
        if is_call is not None:
            (self._call_cancels if is_call else self._goal_cancels).publish(GoalID(id=command_id))

    def note(self, asked_by: str, what: str) -> None:
        """Write a line about a call into the log of the node."""
        rospy.loginfo("%s: %s", asked_by, one_line(what))

    @property
    def is_connected(self) -> bool:
        """Whether the command server hears calls and sentences."""
        return self._calls.get_num_connections() > 0 and self._goals.get_num_connections() > 0

    def _later(self, take: Callable[[Any], None]) -> Callable[[Any], None]:
        return lambda message: self._call_soon(take, message)

    def _on_reply(self, reply: Reply) -> None:
        command_id = reply.command.id
        self._called.pop(command_id, None)
        outcome = _OUTCOMES.get(reply.outcome, "FAILED")
        is_question = outcome == NEEDS_INFORMATION
        self.question = OpenQuestion(command_id, reply.code, time.monotonic()) if is_question else None
        asked_by = who_asked(command_id)
        tried = self.deeds.take_tried(command_id)
        self.deeds.add(Deed(asked_by, reply.command.text, outcome, reply.code, reply.sentence, time.time(), tried))
        self._hear(Answer(command_id, outcome, reply.stage, reply.code, reply.sentence))

    def _on_event(self, event: StageEvent) -> None:
        if not event.is_final:
            self._hear(Progress(event.command.id, event.stage, event.sentence))

    def _on_tried(self, tried: TriedFrame) -> None:
        servers = ", ".join(tried.frame.action_server_topics)
        result = _RESULTS.get(tried.outcome, "was ended by others")
        self.deeds.add_tried(tried.command.id, f"{tried.frame.name} by {servers} {result}")

    def _on_emergency(self, state: EmergencyStop) -> None:
        # Of several messages, the one with the highest number counts.
        if state.number >= self._emergency_number:
            self._emergency_number = state.number
            self.emergency = state.sentence if state.is_engaged else ""

    def _on_world(self, message: WorldMessage) -> None:
        world = world_from_message(message)
        self._call_soon(setattr, self, "world", world)

    def _on_catalogue(self, message: FrameCatalogue) -> None:
        # Reading takes a moment, so it is done in the thread of the subscriber.
        frames, refused = self._files.contents((file.path, file.text) for file in message.files)
        for reason in refused:
            rospy.logwarn("a frame of the catalogue cannot be read, so it is no tool: %s", reason)
        self._call_soon(self._know, frames, None)

    def _on_servers(self, message: FrameServers) -> None:
        servers: Dict[str, List[Server]] = {}
        for callback in message.callbacks:
            if not callback.is_alive or callback.profile.robot:
                continue
            try:
                profile = profile_from_message(callback.profile)
            except ValueError as error:
                rospy.logwarn("the server %s is no tool: %s", callback.callback_topic, error)
                continue
            servers.setdefault(callback.frame_name, []).append(Server(callback.callback_topic, profile))
        self._call_soon(self._know, None, servers)

    def _know(self, frames: Optional[List[SemanticFrame]], servers: Optional[Dict[str, List[Server]]]) -> None:
        if frames is not None:
            self._frames = frames
        if servers is not None:
            self._servers = servers
        tools = frame_tools(self._frames, self._servers)
        if tools != self.tools:
            self.tools = tools
            self._on_tools()
