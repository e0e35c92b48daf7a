"""``rfn list``: counts domains, frames and servers, beside the evaluation table of the paper."""

import argparse
import os
import sys
from dataclasses import dataclass
from typing import Dict, List, Optional, Sequence, Tuple

from frame_registrar.graph import FrameGraph
from offline_pipeline.knowledge import Knowledge, load_knowledge, shipped_domains
from roboframenet_ros.sqlite_file import StoreError
from roboframenet_tools.folders import folders_of
from roboframenet_tools.learned import NothingLearned, learned_units, listed
from semantic_frames.server_profile import Purpose

EXAMPLES = """examples:
  rfn list
  rfn list --domains my_domains
  rfn list --learned

--learned lists what persons taught the robot by their answers, with the names by which 'rfn forget' forgets it.

Grounded frames, complete domains and robots are those of the running graph; without a ROS master they are shown as '-'.
"""
#: Thomas and Jenkins, ICRA 2012, section V.
PAPER = (
    ("domains", "10"),
    ("frames", "52"),
    ("lexical units", "-"),
    ("domains with grounded frames", "6"),
    ("grounded frames", "16"),
    ("robots", "2"),
)


@dataclass(frozen=True)
class Domain:
    """The counts of a domain; ``grounded`` is None when no graph runs."""

    name: str
    frames: int
    units: int
    grounded: Optional[int]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn list``."""
    parser.epilog = EXAMPLES
    parser.add_argument(
        "--domains", action="append", metavar="FOLDER[,FOLDER]", help="folders of domains (default: those shipped)"
    )
    parser.add_argument("--learned", action="store_true", help="list what persons taught the robot instead")
    parser.add_argument("--file", metavar="FILE", help="of --learned (default: learned.sqlite in the ROS home folder)")


def run(arguments: argparse.Namespace) -> int:
    """Print the table; return the exit status."""
    if arguments.learned:
        try:
            print(listed(learned_units(arguments.file or "")))
        except NothingLearned as error:
            print(error)
        except StoreError as error:
            print(f"rfn list: {error}", file=sys.stderr)
            return 2
        return 0
    try:
        folders = folders_of(arguments.domains or ()) or [shipped_domains()]
    except NotADirectoryError as error:
        print(f"rfn list: {error}", file=sys.stderr)
        return 2
    knowledge = load_knowledge(folders)
    live, robots = None, None  # type: Optional[Knowledge], Optional[Tuple[str, ...]]
    try:
        from roboframenet_tools.ros_graph import is_master_up, live_knowledge, robots_up

        if is_master_up():
            live = live_knowledge(timeout_s=5.0)
            robots = robots_up()
    except (ImportError, LookupError) as error:
        print(f"rfn list: the running graph is not counted: {error}", file=sys.stderr)
    print(table(count(knowledge, live.graph if live else None), robots))
    of_robots = table_of_robots(live.graph) if live else ""
    if of_robots:
        print(f"\n{of_robots}")
    return 0


def is_grounded(graph: FrameGraph, name: str, robot: str = "") -> bool:
    """Whether live servers can carry a frame out, or watch it: its own, or those of one of its sequences of children.

    Args:
        graph: frames and servers
        name: of a frame
        robot: whose servers; empty for those of all
    """
    frame = graph.frame(name)
    return any(graph.servers(name, purpose, robot) for purpose in Purpose) or (
        frame is not None
        and any(all(is_grounded(graph, child.name, robot) for child in sequence) for sequence in frame.children)
    )


def table_of_robots(graph: FrameGraph) -> str:
    """Return which robot of a fleet can carry out which frames, for a terminal; empty if no server names its robot."""
    robots = sorted({graph.profile(frame, server).robot for frame, server in graph.registrations()} - {""})
    rows: List[Tuple[str, ...]] = [("robots", "grounded", "frames")]
    for robot in robots:
        frames = sorted(name for name in graph.frames if is_grounded(graph, name, robot))
        rows.append((robot, str(len(frames)), ", ".join(frames)))
    return _aligned(rows) if robots else ""


def count(knowledge: Knowledge, live: Optional[FrameGraph]) -> Tuple[Domain, ...]:
    """Count frames and units by the folder of their files."""
    domains: Dict[str, List[str]] = {}
    for name, frame in knowledge.frames.items():
        domains.setdefault(_domain(frame.path), []).append(name)
    return tuple(
        Domain(
            name=domain,
            frames=len(names),
            units=sum(1 for unit in knowledge.lexicon.units if _domain(unit.path) == domain),
            grounded=sum(is_grounded(live, name) for name in names) if live else None,
        )
        for domain, names in sorted(domains.items())
    )


def _domain(path: str) -> str:
    return os.path.basename(os.path.dirname(os.path.dirname(path)))


def table(domains: Sequence[Domain], robots: Optional[Tuple[str, ...]]) -> str:
    """Return both tables for a terminal."""
    rows: List[Tuple[str, ...]] = [("domain", "frames", "lexical units", "grounded")]
    rows += [(domain.name, str(domain.frames), str(domain.units), _number(domain.grounded)) for domain in domains]
    is_live = bool(domains) and domains[0].grounded is not None
    ours = (
        str(len(domains)),
        str(sum(domain.frames for domain in domains)),
        str(sum(domain.units for domain in domains)),
        _number(sum(1 for domain in domains if domain.grounded) if is_live else None),
        _number(sum(domain.grounded or 0 for domain in domains) if is_live else None),
        "-" if robots is None else f"{len(robots)} ({', '.join(robots)})" if robots else "0",
    )
    summary = [("", "paper", "here")] + [(name, paper, value) for (name, paper), value in zip(PAPER, ours)]
    return _aligned(rows) + "\n\n" + _aligned(summary)


def _number(value: Optional[int]) -> str:
    return "-" if value is None else str(value)


def _aligned(rows: Sequence[Tuple[str, ...]]) -> str:
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows)
