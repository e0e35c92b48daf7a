#!/usr/bin/python3
"""Nodes start with the parameters that are set, end with a sentence when one is wrong, and wait for nobody for ever."""

import enum
import itertools
import socket
import subprocess
import sys
import threading
import time
import unittest
from dataclasses import dataclass
from typing import Any, Dict, List, Set, Tuple
from unittest import mock

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.client import Client
from rospy.exceptions import TransportInitError
from rospy.impl import registration, tcpros_base
from rospy.impl.tcpros_base import TCPROSTransport
from std_msgs.msg import String
from std_srvs.srv import Trigger, TriggerResponse

from roboframenet_ros import ros_connection_threads
from roboframenet_ros.health import Health, Level
from roboframenet_ros.parameters import ParameterError, Parameters, parameter
from roboframenet_ros.ros_diagnostics import Diagnostics
from roboframenet_ros.ros_kept_value import KeptValue
from roboframenet_ros.ros_live_parameters import LiveParameters
from roboframenet_ros.ros_log import log_from_threads
from roboframenet_ros.ros_master import MasterError, TimedMaster
from roboframenet_ros.ros_missed_publishers import connect_missed_publishers
from roboframenet_ros.ros_node import read_parameters
from roboframenet_ros.ros_publishing import publish
from roboframenet_ros.ros_service import ServiceError, call_service
from roboframenet_testing import wait_until

NODE = """
import enum
import sys
from dataclasses import dataclass
import rospy
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters, run_node

class Voice(enum.Enum):
    LOUD = "loud"
    LOW = "low"

@dataclass(frozen=True)
class Settings(Parameters):
    timeout_s: float = parameter(2.0, least=0.1, most=60.0)
    name: str = parameter("nobody")
    voice: Voice = parameter(Voice.LOUD)
    greeting: str = parameter("hello")
    count: int = 0

def start():
    settings = read_parameters(Settings, defaults=Settings(greeting="hi"))
    if settings.name == "nobody":
        raise StartError("nobody is there")
    print(settings.timeout_s, settings.name, settings.voice.name, settings.greeting, settings.count, flush=True)
    rospy.Timer(rospy.Duration(0.1), lambda _: rospy.signal_shutdown("read"), oneshot=True)

run_node("reader", start)
"""

#: Ctrl-C comes while the main thread holds a lock that a hook of the shutdown needs, and so does a thread it joins.
INTERRUPTED = """
import os, signal, threading, time
import rospy
from roboframenet_ros.ros_node import run_node

lock = threading.Lock()

def close():
    with lock:
        print("closed", flush=True)

def start():
    rospy.on_shutdown(close)
    with lock:
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(0.2)

run_node("interrupted", start)
print("ended", flush=True)
"""


#: Ctrl-C comes in another thread than the main one, which waits until a hook of the shutdown has run.
INTERRUPTED_ELSEWHERE = """
import os, signal, threading
import rospy
from roboframenet_ros.ros_node import run_node

closed = threading.Event()

def start():
    rospy.on_shutdown(closed.set)
    # The thread that started before takes the signal.
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])

def work(_node):
    os.kill(os.getpid(), signal.SIGINT)
    print("closed" if closed.wait(30.0) else "not closed", flush=True)

run_node("interrupted", start, work=work)
"""


class LateMaster:
    """The master, which answers a subscription as if nobody published anything yet."""

    def __init__(self, master: Any) -> None:
        self._master = master

    def __getattr__(self, name: str) -> Any:
        return getattr(self._master, name)

    def registerSubscriber(self, *arguments: str) -> Tuple[int, str, List[str]]:  # noqa: N802
        self._master.registerSubscriber(*arguments)
        return 1, "", []


def run(*arguments: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        [sys.executable, "-c", NODE, *arguments], capture_output=True, text=True, timeout=120, check=False
    )


class Volume(enum.Enum):
    LOUD = "loud"
    LOW = "low"
    WHISPER = "whisper"


@dataclass(frozen=True)
class Tunable(Parameters):
    speed_m_per_s: float = parameter(1.0, above=0.0, is_live=True)
    count: int = parameter(3, least=1, most=9, is_live=True)
    is_loud: bool = parameter(True, is_live=True)
    voice: Volume = parameter(Volume.LOUD, is_live=True)
    name: str = parameter("fixed")

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.voice is Volume.WHISPER and self.count > 5:
            raise ParameterError("~voice whisper is for at most 5 words")


class NodeTest(unittest.TestCase):
    def test_topic_that_closes_at_shutdown_is_no_error_and_any_other_is(self) -> None:
        publisher = rospy.Publisher("closing", String, queue_size=1)
        publish(publisher, String("open"))
        publisher.unregister()
        with self.assertRaises(rospy.ROSException):
            publish(publisher, String("closed"))
        # rospy closes topics while is_shutdown() is still false.
        with mock.patch.object(rospy.core, "is_shutdown_requested", lambda: True):
            publish(publisher, String("closed"))

    def test_parameters_are_read(self) -> None:
        ended = run("_timeout_s:=7", "_name:=somebody", "_voice:=low", "_count:=3")
        self.assertEqual((0, "7 somebody LOW hi 0"), (ended.returncode, ended.stdout.splitlines()[0]), ended.stderr)

    def test_wrong_parameter_ends_the_node_with_a_sentence(self) -> None:
        ended = run("_timeout_s:=100", "_name:=somebody")
        self.assertEqual(1, ended.returncode)
        self.assertIn("reader: ~timeout_s must be 0.1 to 60 s, got 100", ended.stderr)
        self.assertNotIn("Traceback", ended.stderr)

    def test_node_that_cannot_start_ends_with_a_sentence(self) -> None:
        ended = run()
        self.assertEqual(1, ended.returncode)
        self.assertIn("reader: nobody is there", ended.stderr)
        self.assertNotIn("Traceback", ended.stderr)

    def test_node_that_is_interrupted_with_a_lock_in_its_hand_ends(self) -> None:
        # It waited for itself, and roslaunch killed it after 15 s.
        ended = subprocess.run(
            [sys.executable, "-c", INTERRUPTED], capture_output=True, text=True, timeout=60, check=False
        )
        self.assertEqual((0, ["closed", "ended"]), (ended.returncode, ended.stdout.split()), ended.stderr)

    def test_node_ends_although_its_main_thread_does_not_hear_of_the_interrupt(self) -> None:
        # It ended up to 5 s late, when the main thread looked by itself.
        ended = subprocess.run(
            [sys.executable, "-c", INTERRUPTED_ELSEWHERE], capture_output=True, text=True, timeout=60, check=False
        )
        self.assertEqual((0, ["closed"]), (ended.returncode, ended.stdout.split()), ended.stderr)

    def test_subscriber_is_connected_to_a_publisher_of_whom_rospy_has_not_heard(self) -> None:
        publisher = rospy.Publisher("missed", String, queue_size=1, latch=True)
        publisher.publish(String("here"))
        connect_missed_publishers()
        heard: List[str] = []
        real = registration.xmlrpcapi
        with mock.patch.object(registration, "xmlrpcapi", lambda uri: LateMaster(real(uri))):
            subscriber = rospy.Subscriber("missed", String, lambda message: heard.append(message.data))
        wait_until(lambda: heard == ["here"])
        subscriber.unregister()
        publisher.unregister()

    def test_subscriber_is_connected_to_a_publisher_that_refused_it_once(self) -> None:
        publisher = rospy.Publisher("refusing", String, queue_size=1, latch=True)
        publisher.publish(String("here"))
        connect_missed_publishers()
        heard: List[str] = []
        real, refused = TCPROSTransport._validate_header, []

        def refuse_once(transport: Any, header: Dict[str, str]) -> None:
            if header.get("topic") == publisher.resolved_name and not refused:
                refused.append(transport)
                transport.socket.shutdown(socket.SHUT_RDWR)
                raise TransportInitError("remote error reported: not a publisher")
            real(transport, header)

        with mock.patch.object(TCPROSTransport, "_validate_header", refuse_once):
            subscriber = rospy.Subscriber("refusing", String, lambda message: heard.append(message.data))
            wait_until(lambda: heard == ["here"])
        self.assertEqual(1, len(refused))
        subscriber.unregister()
        publisher.unregister()

    def test_subscriber_is_connected_again_when_rospy_has_dropped_its_connection(self) -> None:
        publisher = rospy.Publisher("dropped", String, queue_size=1, latch=True)
        publisher.publish(String("here"))
        connect_missed_publishers()
        heard: List[str] = []
        subscriber = rospy.Subscriber("dropped", String, lambda message: heard.append(message.data))
        wait_until(lambda: heard == ["here"])
        # Longer than the look behind a new subscription.
        time.sleep(3.0)
        for link in list(subscriber.impl.connections):
            link.close()
            subscriber.impl.remove_connection(link)
        wait_until(lambda: heard == ["here", "here"])
        subscriber.unregister()
        publisher.unregister()

    def test_connection_that_says_nothing_keeps_nobody_out_and_is_closed(self) -> None:
        ros_connection_threads.accept_in_threads()
        address = tcpros_base.get_tcpros_server_address()
        served = rospy.Service("served_meanwhile", Trigger, lambda request: TriggerResponse(success=True))
        shortly = mock.patch.object(ros_connection_threads, "_HEADER_TIMEOUT_S", 1.0)
        with shortly, socket.create_connection(address, timeout=30.0) as silent:
            self.assertTrue(call_service("served_meanwhile", Trigger, timeout_s=30.0).success)
            self.assertEqual(b"", silent.recv(1))
        served.shutdown()

    def test_node_says_how_it_is(self) -> None:
        healths = itertools.cycle([Health(values={"verbs": 3}), Health(Level.WARN, "No odometry\nyet."), None])

        def health() -> Health:
            current = next(healths)
            if current is None:
                raise KeyError("frames")
            return current

        heard: Set[Tuple[object, ...]] = set()

        def hear(message: DiagnosticArray) -> None:
            for one in message.status:
                values = tuple((pair.key, pair.value) for pair in one.values)
                heard.add((one.name, one.hardware_id, one.level, one.message, values))

        subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, hear)
        Diagnostics({"somebody": health})
        name = "somebody: state"
        expected = {
            (name, "none", 0, "Runs.", (("verbs", "3"),)),
            (name, "none", 1, "No odometry yet.", ()),
            (name, "none", 2, "Cannot say how it is: KeyError: 'frames'", ()),
        }
        wait_until(lambda: expected <= heard)
        subscriber.unregister()

    def test_value_outlives_its_node(self) -> None:
        value = [{"id": "a", "stamp_ns": 1_700_000_000_000_000_000, "text": "say \x07 it"}]
        first = KeptValue("~kept")
        self.assertIsNone(first.load())
        first.save(value)
        first.close()
        second = KeptValue("~kept")
        self.assertEqual(value, second.load())
        second.save([])
        second.close()
        self.assertIsNone(KeptValue("~kept").load())

    def test_value_under_another_master_is_not_found(self) -> None:
        KeptValue("~kept_here").save([1])
        rospy.delete_param("~kept_here")
        self.assertIsNone(KeptValue("~kept_here").load())

    def test_name_of_a_file_that_the_master_gives_is_no_path(self) -> None:
        rospy.set_param("~kept_there", "../../etc/passwd")
        self.assertIsNone(KeptValue("~kept_there").load())
        self.assertRegex(rospy.get_param("~kept_there"), "^[0-9a-f]{32}$")

    def test_log_asks_the_master_for_its_parameter_once(self) -> None:
        name = "/rosout_disable_topics_generation"
        log_from_threads()
        wait_until(lambda: rospy.has_param(name))
        self.assertIs(False, rospy.get_param(name))
        self.assertIs(False, rospy.get_param_cached(name))
        with mock.patch.object(rospy.client._param_server, "target", None):
            self.assertIs(False, rospy.get_param_cached(name))

    def test_live_parameter_is_changed_and_a_wrong_value_changes_nothing(self) -> None:
        rospy.set_param("~speed_m_per_s", 2)
        changes: List[Tunable] = []
        live = LiveParameters(read_parameters(Tunable), changes.append)
        client = Client(rospy.get_name(), timeout=60.0)
        described = {one["name"]: one for one in client.get_parameter_descriptions(timeout=60.0)}
        self.assertEqual({"speed_m_per_s", "count", "is_loud", "voice"}, set(described))
        self.assertEqual(
            (0.0, 1, 9), (described["speed_m_per_s"]["min"], described["count"]["min"], described["count"]["max"])
        )
        self.assertIn("'low'", described["voice"]["edit_method"])
        self.assertEqual(2.0, client.get_configuration(timeout=60.0)["speed_m_per_s"])
        client.update_configuration({"speed_m_per_s": 0.5, "count": 4, "is_loud": False, "voice": "low"})
        self.assertEqual([Tunable(0.5, 4, False, Volume.LOW, "fixed")], changes)
        self.assertEqual(("low", 4), (rospy.get_param("~voice"), rospy.get_param("~count")))
        # A whisper contradicts more than five words; and out of its range a number is the nearest that is allowed.
        self.assertEqual(4, client.update_configuration({"voice": "whisper", "count": 6})["count"])
        self.assertEqual("low", rospy.get_param("~voice"))
        self.assertEqual(9, client.update_configuration({"count": 10})["count"])
        self.assertEqual(2, len(changes))
        client.close()
        del live

    def test_service_answers(self) -> None:
        service = rospy.Service("~ready", Trigger, lambda _: TriggerResponse(success=True, message="yes"))
        self.assertEqual("yes", call_service(service.resolved_name, Trigger, timeout_s=60.0).message)

    def test_service_that_hangs_or_fails_or_is_missing_is_named(self) -> None:
        may_end = threading.Event()
        hanging = rospy.Service("~hanging", Trigger, lambda _: may_end.wait(60.0) and TriggerResponse())
        failing = rospy.Service("~failing", Trigger, lambda _: None)
        for name, timeout_s, fault in (
            (hanging.resolved_name, 0.5, "did not answer within 0.5 s"),
            (failing.resolved_name, 60.0, "failed: "),
            ("nowhere", 0.5, "is not available (waited 0.5 s)"),
        ):
            with self.assertRaises(ServiceError) as raised:
                call_service(name, Trigger, timeout_s=60.0 if name != "nowhere" else 0.5, answer_timeout_s=timeout_s)
            self.assertIn(fault, str(raised.exception))
        may_end.set()

    def test_master_knows_this_node_and_no_stranger(self) -> None:
        master = TimedMaster(timeout_s=60.0)
        self.assertEqual(rospy.get_node_uri(), master.uri_of(rospy.get_name()))
        self.assertIn("/rosout", master.system_state().publishers)
        with self.assertRaises(MasterError):
            master.uri_of("/nobody")


if __name__ == "__main__":
    rospy.init_node("test_node")
    rostest.rosrun("roboframenet_ros", "node", NodeTest)
