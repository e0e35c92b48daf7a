"""What commands that read sentences without a robot have in common: their arguments, and their pipeline."""

import argparse
import sys
from typing import FrozenSet

from checked_files.source_files import read_text
from nearest_meaning.likeness import Likeness
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains, with_names
from offline_pipeline.pipeline import BEHAVIOURS, Parameters, Pipeline
from roboframenet_tools.folders import folders_of
from world_model.world import snapshot
from world_model.world_file import load_world_file


def add_knowledge_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments that say what is known."""
    parser.add_argument(
        "--domains",
        action="append",
        metavar="FOLDER[,FOLDER]",
        help="folders of frames and units (default: those shipped)",
    )
    parser.add_argument(
        "--with",
        dest="others",
        action="append",
        default=[],
        metavar="FOLDER[,FOLDER]",
        help="folders of frames and units beside those of --domains, or beside those shipped",
    )
    parser.add_argument(
        "--names",
        action="append",
        default=[],
        metavar="FILE",
        help="names that the robot knows, as the launch argument 'names_file' sets them",
    )
    parser.add_argument(
        "--world",
        metavar="FILE",
        default="",
        help="what the robot knows of things, persons and places, as the launch argument 'world_file' sets it",
    )


def offline_pipeline(
    arguments: argparse.Namespace,
    *,
    parameters: Parameters = BEHAVIOURS["now"],
    without: FrozenSet[str] = frozenset(),
    is_traced: bool = False,
) -> Pipeline:
    """Return the pipeline for the arguments, with a pretended server for each frame.

    Args:
        arguments: those that :func:`add_knowledge_arguments` declares
        parameters: of the nodes
        without: names of rules that are switched off
        is_traced: whether to record what each rule does
    Raises:
        OSError: a folder or file cannot be read
        FileRefused: the file of the world has mistakes
        ModelError: the models cannot be loaded
    """
    folders = folders_of(arguments.domains or ()) or [shipped_domains()]
    knowledge = with_names(load_knowledge([*folders, *folders_of(arguments.others)]), arguments.names)
    pretend_servers(knowledge.graph)
    objects = load_world_file(read_text(arguments.world), arguments.world) if arguments.world else ()
    world = snapshot(arguments.world, {one.id: one for one in objects})
    return Pipeline(
        knowledge,
        parameters=parameters,
        without=without,
        is_traced=is_traced,
        world=world,
        likeness=Likeness(),
    )


def told_problems(pipeline: Pipeline) -> Pipeline:
    """Return a pipeline after its files with mistakes were told on standard error."""
    for problem in pipeline.knowledge.problems:
        print(problem, file=sys.stderr)
    return pipeline
