"""``rfn record``: writes what is said to a running robot, and what comes of it."""

import argparse
import sys
import threading
from collections import OrderedDict
from typing import TextIO, Tuple

import rosgraph
import rospy
from roboframenet_msgs.msg import CommandLexicalUnits, LexicalUnitReading, Reply

from roboframenet_tools.recording import Frame, Record, record_to_json
from roboframenet_tools.saying import Outcome

EXAMPLES = """examples:
  rfn record said.jsonl
  rfn record said.jsonl & rfn say "Turn left."
  rfn replay said.jsonl

One JSON object for each reply, until Ctrl-C. Exit status: 0, 2 wrong usage, 6 no master
"""
_NO_MASTER = 6
#: Commands whose reply is awaited, at most; the oldest are forgotten.
_MAX_OPEN = 1000
#: Stages behind the framer: what they reply to has frames.
_BEHIND_THE_FRAMER = ("frame_registrar", "arbitrator", "executor")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn record``."""
    parser.epilog = EXAMPLES
    parser.add_argument("file", nargs="?", default="-", help="file to append to (default: standard output)")


def run(arguments: argparse.Namespace) -> int:
    """Record until the end of the node; return the exit status."""
    if not rosgraph.is_master_online():
        print(f"rfn record: no ROS master at {rosgraph.get_master_uri()}", file=sys.stderr)
        return _NO_MASTER
    if arguments.file == "-":
        return _record(sys.stdout)
    try:
        with open(arguments.file, "a", encoding="utf-8") as file:
            return _record(file)
    except OSError as error:
        print(f"rfn record: {error}", file=sys.stderr)
        return 2


def _record(file: TextIO) -> int:
    rospy.init_node("rfn_record", anonymous=True)
    recorder = Recorder(file)
    rospy.spin()
    recorder.close()
    return 0


class Recorder:
    """Writes a line for each reply.

    Subscribes:
        command_lexical_units (CommandLexicalUnits), reply (Reply)
    """

    def __init__(self, file: TextIO) -> None:
        self._file = file
        self._lock = threading.Lock()
        self._frames: OrderedDict[str, Tuple[Frame, ...]] = OrderedDict()
        self._subscribers = (
            rospy.Subscriber("command_lexical_units", CommandLexicalUnits, self._on_units, queue_size=100),
            rospy.Subscriber("reply", Reply, self._on_reply, queue_size=100),
        )

    def close(self) -> None:
        """Write no more."""
        for subscriber in self._subscribers:
            subscriber.unregister()

    def _on_units(self, message: CommandLexicalUnits) -> None:
        frames = tuple(_frame(min(clause.readings, key=lambda one: one.preference)) for clause in message.clauses)
        with self._lock:
            self._frames[message.command.id] = frames
            while len(self._frames) > _MAX_OPEN:
                self._frames.popitem(last=False)

    def _on_reply(self, reply: Reply) -> None:
        with self._lock:
            if reply.stage in _BEHIND_THE_FRAMER and reply.command.id not in self._frames:
                # The command was said before both topics were connected: its frames were not heard.
                return
            record = Record(
                text=reply.command.text,
                frames=self._frames.pop(reply.command.id, ()),
                outcome=Outcome(reply.outcome).name,
                code=reply.code,
                sentence=reply.sentence,
            )
            print(record_to_json(record), file=self._file, flush=True)


def _frame(reading: LexicalUnitReading) -> Frame:
    unit = reading.lexical_unit
    return unit.frame_name, tuple(sorted((one.name, one.argument) for one in unit.frame_elements if one.argument))
