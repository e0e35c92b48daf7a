"""``rfn verbs``: proposes verbs of WordNet for the lexical units of frames; a person accepts them."""

import argparse
import sys
from typing import Dict, List

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from semantic_types.verb_classes import class_verbs
from semantic_types.wordnet import VERB, NoWordNet, shipped_wordnet

EXAMPLES = """examples:
  rfn verbs taking bringing
  rfn verbs

Each line is a verb, the sense of a verb of the frame that makes it one of its class, and what it means. Verbs that any
unit has, and opposites, are left out. Write those that are right into the unit, as "verb_class: {obtain: get.v.01}":
the robot asks the first time that somebody says such a verb. Leave out what does more, or more roughly, than the frame:
to slam is a way to close.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn verbs``."""
    parser.epilog = EXAMPLES
    parser.add_argument("frame", nargs="*", help="names of frames (default: all that act)")
    parser.add_argument("--domains", action="append", metavar="FOLDER", help="frames and units (default: shipped)")


def run(arguments: argparse.Namespace) -> int:
    """Print the proposals; return the exit status."""
    try:
        knowledge = load_knowledge(arguments.domains or [shipped_domains()])
        net = shipped_wordnet(VERB)
    except (OSError, NoWordNet) as error:
        print(f"rfn verbs: {error}", file=sys.stderr)
        return 2
    unknown = [name for name in arguments.frame if name not in knowledge.frames]
    if unknown:
        print(f"rfn verbs: no file describes the frame {', '.join(unknown)}", file=sys.stderr)
        return 2
    own: Dict[str, List[str]] = {}
    for unit in knowledge.lexicon.units:
        frame = knowledge.frames.get(unit.frame_name)
        if frame is not None and frame.acts:
            own.setdefault(unit.frame_name, []).extend(verb for verb in unit.verbs if verb not in unit.class_verbs)
    owned = frozenset(knowledge.lexicon.verbs)
    for name in arguments.frame or sorted(own):
        print(name)
        for one in class_verbs(net, list(dict.fromkeys(own.get(name, ()))), owned):
            print(f"  {one.verb}: {one.sense:<20} {one.reason}: {one.gloss}")
    return 0
