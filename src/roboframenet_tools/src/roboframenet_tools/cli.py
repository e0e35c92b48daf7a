"""The command line ``rfn``: one subcommand for each thing a person asks of the system."""

import argparse
import importlib
import os
import select
import sys
from typing import List, Optional, Sequence

#: Subcommand, module that implements it, and the line that ``rfn --help`` shows. A module offers
#: ``add_arguments(parser)`` and ``run(arguments) -> exit status``; it is imported only when it is asked for, so that
#: a subcommand that needs no ROS works without ROS, and ``rfn --help`` is quick.
COMMANDS = (
    ("say", "roboframenet_tools.ros_say", "say a sentence to the robot and see what comes of it"),
    ("explain", "roboframenet_tools.explain", "show how a sentence is understood, without running it"),
    ("passes", "roboframenet_tools.passes", "list the rules that rewrite a sentence, and what each does to a corpus"),
    ("check", "roboframenet_tools.check", "check frame and lexical unit files"),
    (
        "list",
        "roboframenet_tools.listing",
        "count domains, frames, lexical units and what is grounded, beside the paper",
    ),
    ("graph", "roboframenet_tools.graph", "draw the graph of semantic frames"),
    ("new", "roboframenet_tools.new", "make the files of a new frame: frame, lexical unit, RFNServer, test"),
    ("port", "roboframenet_tools.port", "show or make the one-line change from an action server to an RFNServer"),
    ("doctor", "roboframenet_tools.doctor", "look for what keeps the system from working"),
    ("learn", "frame_learning.learn_command", "learn lexical units from annotated sentences"),
    ("score", "frame_learning.score_command", "score the understanding of a public corpus"),
    ("completion", "roboframenet_tools.completion", "print the completion of rfn for bash"),
)
#: Exit status when whoever read the output has gone ("rfn score ... | head"): that of a program ended by SIGPIPE.
OUTPUT_CLOSED = 128 + 13


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Run one subcommand.

    Args:
        argv: the words behind ``rfn``; None for those of the process
    Returns:
        exit status: 0 when what was asked for is done, 2 for wrong usage, ``OUTPUT_CLOSED`` when nobody reads it
    """
    try:
        try:
            return _run(list(sys.argv[1:] if argv is None else argv))
        finally:
            sys.stdout.flush()
    except BrokenPipeError:
        if not _is_output_closed():
            raise
        # What is still to be written goes nowhere, or the interpreter would complain of it when it ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return OUTPUT_CLOSED


def _is_output_closed() -> bool:
    """Whether nobody reads the standard output any more; another pipe or socket may have broken."""
    poll = select.poll()
    poll.register(sys.stdout.fileno(), 0)
    return any(event & select.POLLERR for _, event in poll.poll(0))


def _run(words: List[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="rfn", description="RoboFrameNet from the command line.", epilog="'rfn COMMAND --help' tells more of each."
    )
    subparsers = parser.add_subparsers(dest="command", metavar="COMMAND")
    for name, module, line in COMMANDS:
        subparser = subparsers.add_parser(
            name,
            help=line,
            description=line[0].upper() + line[1:] + ".",
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        if words[:1] == [name]:
            importlib.import_module(module).add_arguments(subparser)
    arguments = parser.parse_args(words)
    if arguments.command is None:
        parser.print_help()
        return 2
    module = next(module for name, module, _ in COMMANDS if name == arguments.command)
    status: int = importlib.import_module(module).run(arguments)
    return status
