"""The node of the world model: keeps what the robot knows, and tells everybody."""

import os
import threading
import time
from dataclasses import dataclass, replace
from typing import Dict, Optional, Tuple, Union

import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from roboframenet_msgs.msg import FileProblem, KnownName, KnownNames, World, WorldUpdate
from roboframenet_msgs.srv import UpdateWorld, UpdateWorldRequest, UpdateWorldResponse
from std_srvs.srv import Trigger, TriggerRequest, TriggerResponse

from checked_files import FileRefused, Problem
from checked_files.source_files import read_text
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_publishing import publish
from roboframenet_ros.sqlite_file import StoreError
from world_model.knowledge import Change, Knowledge, Refused
from world_model.names import known_names
from world_model.ros_messages import pose_from_message, update_from_message, world_to_message
from world_model.store import Store, default_memory_file, forgotten_in_words
from world_model.world import snapshot
from world_model.world_file import load_world_file
from world_model.world_object import ROBOT_ID, Pose, Sort, WorldObject


@dataclass(frozen=True)
class Settings(Parameters):
    """The private parameters, after validation.

    Attributes:
        world_file: what the robot knows from the start; empty for nothing
        memory_file: where it keeps what it learned; empty for ``world.sqlite`` in the ROS home folder, ":memory:" to
            forget it with the end of the run
        snapshot_period_s: the snapshot is published at most so often, seconds
        robot_step_m: the pose of the robot is published again when it has moved so far, metres

    Raises:
        ParameterError: a value is not allowed
    """

    world_file: str = parameter("")
    memory_file: str = parameter("")
    snapshot_period_s: float = parameter(0.2, least=0.01, most=60.0)
    robot_step_m: float = parameter(0.5, least=0.01, most=100.0)


class WorldModel:
    """Keeps what the robot knows.

    Subscribes:
        world_updates (WorldUpdate), amcl_pose (PoseWithCovarianceStamped): where the robot is
    Publishes:
        world (World, latched), known_names (KnownNames, latched), file_problems (FileProblems, latched)
    Services:
        update_world (UpdateWorld), forget_world (std_srvs/Trigger): forget everything that was learned
    Parameters: see :class:`Settings`.
    """

    def __init__(self, settings: Settings, place: Place) -> None:
        """
        Args:
            settings: its own
            place: where it runs
        Raises:
            StartError: there is no memory, not even a new one
        """
        self._settings = settings
        self._changed = threading.Condition()
        path = os.path.expanduser(settings.memory_file or default_memory_file())
        try:
            self._store = Store(path)
            learned = self._store.load()
            self._version = self._store.next_version()
        except StoreError as error:
            raise StartError(str(error)) from error
        for problem in self._store.problems:
            rospy.logerr("%s", problem)
        of_file, problems = read_file(settings.world_file)
        self._knowledge = Knowledge(of_file, learned)
        self._robot_pose: Optional[Pose] = None
        self._is_new = True
        self._worlds = rospy.Publisher("world", World, queue_size=1, latch=True)
        self._names = rospy.Publisher("known_names", KnownNames, queue_size=1, latch=True)
        self._told_names: Optional[KnownNames] = None
        place.problems.advertise()
        if settings.world_file:
            place.problems.publish("world_model", [to_message(problem) for problem in problems])
        self._thread = threading.Thread(target=self._tell, name="tell the world", daemon=True)
        self._thread.start()
        rospy.on_shutdown(self._close)
        self._services = [
            rospy.Service("update_world", UpdateWorld, self._on_request),
            rospy.Service("forget_world", Trigger, self._on_forget),
        ]
        self._subscribers = [
            rospy.Subscriber("world_updates", WorldUpdate, self._on_update, queue_size=100),
            rospy.Subscriber("amcl_pose", PoseWithCovarianceStamped, self._on_pose, queue_size=1),
        ]
        rospy.loginfo("ready: %d objects, %d problems, %s", len(self._knowledge.objects), len(problems), settings)

    def _on_request(self, request: UpdateWorldRequest) -> UpdateWorldResponse:
        answer = self._update(request.update)
        if isinstance(answer, str):
            return UpdateWorldResponse(success=True, version=answer)
        return UpdateWorldResponse(
            success=False,
            refused=[one.position for one in answer if one.position is not None],
            errors=[one.reason for one in answer],
            version=self._version,
        )

    def _on_forget(self, _: TriggerRequest) -> TriggerResponse:
        with self._changed:
            change = self._knowledge.forget()
            problem = self._take(change)
        if problem:
            return TriggerResponse(success=False, message=problem)
        rospy.loginfo("everything that was learned is forgotten: %d entries", len(change.forgotten))
        return TriggerResponse(success=True, message=forgotten_in_words(len(change.forgotten)))

    def _take(self, change: Change) -> str:
        """Store a change and know it from then on; returns why it was not stored. Called with the lock."""
        try:
            self._version = self._store.write(change)
        except StoreError as error:
            rospy.logerr_throttle(10.0, str(error))
            return str(error)
        self._knowledge.apply(change)
        self._is_new = True
        self._changed.notify_all()
        return ""

    def _on_update(self, message: WorldUpdate) -> None:
        answer = self._update(message)
        if not isinstance(answer, str):
            source = message._connection_header.get("callerid", "somebody")
            rospy.logerr_throttle(1.0, f"an update of {source} is refused: {answer[0].reason}")

    def _update(self, message: WorldUpdate) -> Union[str, Tuple[Refused, ...]]:
        """Store an update; returns the version that contains it, or why it was refused."""
        try:
            update = update_from_message(message)
        except ValueError as error:
            return (Refused(None, str(error)),)
        with self._changed:
            change = self._knowledge.plan(update, rospy.Time.now().to_sec(), time.time())
            if isinstance(change, tuple):
                return change
            problem = "" if change.is_empty else self._take(change)
            return (Refused(None, problem),) if problem else self._version

    def _on_pose(self, message: PoseWithCovarianceStamped) -> None:
        pose = pose_from_message(PoseStamped(header=message.header, pose=message.pose.pose))
        with self._changed:
            before = self._robot_pose
            is_near = before and pose and before.distance_m(pose) < self._settings.robot_step_m
            if pose is None or is_near:
                return
            # Where the robot is now is not worth a disk: after a restart it is localised anew.
            try:
                self._version = self._store.next_version()
            except StoreError as error:
                rospy.logerr_throttle(10.0, str(error))
                return
            self._robot_pose, self._is_new = pose, True
            self._changed.notify_all()

    def _tell(self) -> None:
        """Publish the newest snapshot, at most once in each period."""
        while not rospy.is_shutdown():
            with self._changed:
                if not self._is_new:
                    self._changed.wait(1.0)
                    continue
                self._is_new = False
                world = snapshot(self._version, self._with_robot())
            publish(self._worlds, world_to_message(world, rospy.Time.now().to_sec()))
            names = KnownNames([KnownName(name, list(types)) for name, types in known_names(world)])
            if names != self._told_names and (names.names or self._told_names is not None):
                self._told_names = names
                publish(self._names, names)
            self._pause()

    def _pause(self) -> None:
        """Wait for the period on the monotonic clock, also while ROS time stands still."""
        threading.Event().wait(self._settings.snapshot_period_s)

    def _with_robot(self) -> Dict[str, WorldObject]:
        known = dict(self._knowledge.objects)
        if self._robot_pose is not None:
            robot = known.get(ROBOT_ID, WorldObject(ROBOT_ID, Sort.ROBOT))
            left = tuple(relation for relation in robot.relations if relation not in robot.places)
            known[ROBOT_ID] = replace(robot, pose=self._robot_pose, relations=left)
        return known

    def _close(self) -> None:
        self._thread.join(2.0)
        with self._changed:
            self._store.close()


def read_file(path: str) -> Tuple[Tuple[WorldObject, ...], Tuple[Problem, ...]]:
    """Return the objects of the file of the world, or its problems; nothing for an empty path."""
    if not path:
        return (), ()
    try:
        return load_world_file(read_text(path), path), ()
    except FileRefused as refused:
        for problem in refused.problems:
            rospy.logerr("refused: %s", problem)
        return (), refused.problems


def to_message(problem: Problem) -> FileProblem:
    """Convert a problem."""
    return FileProblem(**{name: getattr(problem, name) for name in FileProblem.__slots__})


def start(place: Place) -> WorldModel:
    """Start the node.

    Raises:
        ParameterError: a parameter is wrong
        StartError: there is no memory
    """
    return WorldModel(read_parameters(Settings, prefix=place.private), place)


def main() -> None:
    """Run the node until ROS shuts down; exit with a message if it cannot start."""
    run_node("world_model", lambda: start(Place()))
