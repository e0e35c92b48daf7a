"""The command line ``rfn``, with a subcommand for each task."""

import argparse
import difflib
import importlib
import os
import select
import sys
from typing import List, Optional, Sequence

#: Subcommand, module that implements it, and the line that ``rfn --help`` shows. A module defines
#: ``add_arguments(parser)`` and ``run(arguments) -> exit status``. It is imported only when its subcommand runs. So a
#: subcommand that needs no ROS works without ROS, and ``rfn --help`` is quick.
COMMANDS = (
    ("say", "roboframenet_tools.ros_say", "say a sentence to the robot and show what happens"),
    ("explain", "roboframenet_tools.explain", "show how a sentence is understood, without running it"),
    ("passes", "roboframenet_tools.passes", "list the rules that rewrite a sentence, and their effect on a corpus"),
    ("sentences", "roboframenet_tools.sentences", "read many sentences, and count what is done, refused or lost"),
    ("check", "roboframenet_tools.check", "check frame and lexical unit files"),
    (
        "list",
        "roboframenet_tools.listing",
        "count domains, frames, lexical units and grounded frames, beside the paper",
    ),
    ("verbs", "roboframenet_tools.verbs", "propose verbs of WordNet for lexical units, for a person to review"),
    ("graph", "roboframenet_tools.graph", "draw the graph of semantic frames"),
    (
        "new",
        "roboframenet_tools.new",
        "write the files of a new ability: frame, lexical unit, RFNServer, test; or a whole package",
    ),
    ("port", "roboframenet_tools.port", "show or make the one-line change from an action server to an RFNServer"),
    ("bind", "roboframenet_tools.ros_bind", "write a binding for a live action server, service or topic"),
    ("record", "roboframenet_tools.ros_record", "record what is said to the robot, and what comes of it"),
    ("replay", "roboframenet_tools.replay", "read recorded sentences with this version, and show the differences"),
    ("unknown", "roboframenet_tools.unknown", "list what was refused and asked, by the lexical unit that is nearest"),
    (
        "test",
        "roboframenet_tools.sentence_test",
        "read the sentences of a file, and show those that are read in another way",
    ),
    ("voice", "voice_recognition.voice_command", "show what is heard in a sound file, and why"),
    ("doctor", "roboframenet_tools.doctor", "find out why the system does not work"),
    (
        "experience",
        "experience.experience_command",
        "list, explain, reset, export or import what was tried",
    ),
    ("place", "roboframenet_tools.ros_place", "remember where the robot stands, list the places, or write them"),
    ("forget", "roboframenet_tools.ros_forget", "let the robot forget what it has learned of things and places"),
    ("export-learned", "roboframenet_tools.learned", "write what persons taught the robot as a lexical unit file"),
    ("import-learned", "roboframenet_tools.learned_import", "take over what persons taught another robot"),
    ("learn", "frame_learning.learn_command", "learn lexical units from annotated sentences"),
    ("score", "frame_learning.score_command", "score the understanding of a public corpus"),
    ("completion", "roboframenet_tools.completion", "print the completion of rfn for bash"),
)
#: Exit status when the reader of the output has closed it ("rfn score ... | head"): that of a program ended by SIGPIPE.
OUTPUT_CLOSED = 128 + 13


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Run one subcommand.

    Args:
        argv: the words after ``rfn``; None for those of the process
    Returns:
        exit status: 0 for success, 2 for wrong usage, ``OUTPUT_CLOSED`` when the output is closed
    """
    try:
        try:
            return _run(list(sys.argv[1:] if argv is None else argv))
        finally:
            sys.stdout.flush()
    except BrokenPipeError:
        if not _is_output_closed():
            raise
        # Discard the remaining output; otherwise the interpreter reports an error when it ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return OUTPUT_CLOSED


def _is_output_closed() -> bool:
    """Whether the standard output is closed; the error may come from another pipe or socket."""
    poll = select.poll()
    poll.register(sys.stdout.fileno(), 0)
    return any(event & select.POLLERR for _, event in poll.poll(0))


def _run(words: List[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="rfn",
        description="RoboFrameNet from the command line.",
        epilog="'rfn COMMAND --help' says more about each.",
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
    if words[:1] == ["help"]:
        return _run([*words[1:2], "--help"])
    if words and not words[0].startswith("-") and words[0] not in subparsers.choices:
        print(f"rfn: {_no_command(words)}", file=sys.stderr)
        return 2
    arguments = parser.parse_args(words)
    if arguments.command is None:
        parser.print_help()
        return 2
    module = next(module for name, module, _ in COMMANDS if name == arguments.command)
    status: int = importlib.import_module(module).run(arguments)
    return status


def _no_command(words: Sequence[str]) -> str:
    """Return what to do instead, when the first word is no command."""
    near = difflib.get_close_matches(words[0], [name for name, _, _ in COMMANDS], n=1)
    if near:
        return f"there is no command '{words[0]}'. Did you mean '{near[0]}'?"
    said = " ".join(words).replace('"', "'")
    return f"there is no command '{words[0]}'; 'rfn --help' lists them. To say it to the robot: rfn say \"{said}\""
