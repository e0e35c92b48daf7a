"""``rfn passes``: lists the rules that rewrite a sentence before it is read, and their effect on a corpus."""

import argparse
import sys
from dataclasses import dataclass
from typing import Dict, Iterable, List, Sequence, Tuple

from frame_learning.annotated_commands import CorpusError
from frame_learning.corpora import CORPORA
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline, Understanding
from stanford_parser_ros.inference import ModelError
from utterance_passes.table import PASSES

EXAMPLES = """examples:
  rfn passes
  rfn passes --corpus huric huric-2.1/english
  rfn passes --corpus huric huric-2.1/english --show quotations

"changes" counts the sentences that a pass changes; "read otherwise" counts those that have other frames, arguments or
another reply without it.

exit status: 0 listed, 2 wrong usage
"""


@dataclass(frozen=True)
class Effect:
    """The effect of a pass on a corpus.

    Attributes:
        name: of the pass
        changed: sentences that it changes
        read_otherwise: those of them that are understood differently without it; results with and without the pass
    """

    name: str
    changed: Tuple[str, ...]
    read_otherwise: Tuple[Tuple[str, str, str], ...]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn passes``."""
    parser.epilog = EXAMPLES
    parser.add_argument(
        "--corpus", nargs=2, metavar=("NAME", "DIR"), help=f"one of {', '.join(CORPORA)}, and its folder"
    )
    parser.add_argument(
        "--show", metavar="PASS", help="print each sentence that is understood differently without this pass"
    )
    parser.add_argument("--domains", action="append", metavar="FOLDER", help="frames and units (default: shipped)")


def run(arguments: argparse.Namespace) -> int:
    """List the passes; return the exit status."""
    names = [one.name for one in PASSES]
    if arguments.show is not None and (arguments.show not in names or not arguments.corpus):
        print("rfn passes: --show needs the name of a pass, and --corpus", file=sys.stderr)
        return 2
    if not arguments.corpus:
        for one in PASSES:
            print(f"{one.name:<22} {one.stage.value:<20} {one.what}")
        return 0
    corpus, folder = arguments.corpus
    if corpus not in CORPORA:
        print(f"rfn passes: expected one of {', '.join(CORPORA)}, found {corpus}", file=sys.stderr)
        return 2
    try:
        said = tuple(dict.fromkeys(command.text for command in CORPORA[corpus].read(folder)))
        knowledge = load_knowledge(arguments.domains or [shipped_domains()])
        pretend_servers(knowledge.graph)
        effects = effects_of(Pipeline(knowledge, is_traced=True), said, [arguments.show] if arguments.show else names)
    except (CorpusError, ModelError, OSError) as error:
        print(f"rfn passes: {error}", file=sys.stderr)
        return 2
    print(f"{len(said)} sentences\n\n{'pass':<22} {'changes':>8} {'read otherwise':>15}")
    for effect in effects:
        print(f"{effect.name:<22} {len(effect.changed):>8} {len(effect.read_otherwise):>15}")
    for effect in effects if arguments.show else ():
        for text, with_it, without_it in effect.read_otherwise:
            print(f'\n"{text}"\n  with     {with_it}\n  without  {without_it}')
    return 0


def effects_of(pipeline: Pipeline, said: Iterable[str], names: Sequence[str]) -> List[Effect]:
    """Count the sentences that passes change, and those that are understood differently without each pass.

    Args:
        pipeline: traced, with every pass
        said: sentences
        names: of the passes to examine
    """
    fired: Dict[str, List[Tuple[str, str]]] = {name: [] for name in names}
    for text in said:
        understanding = pipeline.understand_safely(text)
        for rule in {line.rule for line in understanding.trace} & set(fired):
            fired[rule].append((text, _outcome(understanding)))
    effects = []
    for name, found in fired.items():
        lacking = Pipeline(pipeline.knowledge, pipeline.parser, without=frozenset([name]))
        # A sentence that a pass does not change is the same without the pass.
        pairs = [(text, outcome, _outcome(lacking.understand_safely(text))) for text, outcome in found]
        otherwise = tuple((text, outcome, other) for text, outcome, other in pairs if outcome != other)
        effects.append(Effect(name, tuple(text for text, _ in found), otherwise))
    return effects


def _outcome(understanding: Understanding) -> str:
    """Return what a person would notice: the readings, and the reply if nothing would be done."""
    readings = "; ".join(map(str, understanding.readings))
    reply = understanding.reply
    return f"{readings} {'' if reply.code == 'DONE' else f'[{reply.code}] {reply.sentence}'}".strip()
