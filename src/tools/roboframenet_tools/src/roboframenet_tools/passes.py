"""``rfn passes``: lists the rules that can change how a sentence is read, and their effect on a corpus."""

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterable, List, Sequence, Tuple

from checked_files import FileRefused
from frame_learning.annotated_commands import CorpusError
from frame_learning.sentence_lists import SOURCES, sentences_of
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.named_rules import NAMED_RULES
from offline_pipeline.pipeline import Pipeline, Understanding
from semantic_framer.units.framed_lexicon import FramedLexicon
from stanford_parser_ros.inference import ModelError
from utterance_passes.engine.running import run_tree_passes
from utterance_passes.engine.utterance_pass import TreePass, Uncertain
from utterance_passes.table import FRAMER_TREE_PASSES, NODES
from utterance_passes.trees.conllu import from_conllu
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import Vocabulary

EXAMPLES = """examples:
  rfn passes
  rfn passes --all
  rfn passes --corpus huric huric-2.1/english
  rfn passes --corpus huric huric-2.1/english --show quotations
  rfn passes --corpus gpsr grammars
  rfn passes --corpus sentences said.txt
  rfn passes --gold en_ewt-dev.conllu en_ewt-test.conllu

"fires" counts the sentences in which a rule does something; "read otherwise" counts those that have other frames,
arguments or another reply without it. "changes" counts the trees of a treebank that a pass changes: of right
trees, only a pass should change some that says what a construction means, or what the robot makes of it.

exit status: 0 listed, 2 wrong usage
"""


@dataclass(frozen=True)
class Effect:
    """The effect of a rule on a corpus.

    Attributes:
        name: of the rule
        changed: sentences in which it does something
        read_otherwise: those of them that are understood differently without it; results with and without the pass
    """

    name: str
    changed: Tuple[str, ...]
    read_otherwise: Tuple[Tuple[str, str, str], ...]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn passes``."""
    parser.epilog = EXAMPLES
    parser.add_argument(
        "--corpus",
        nargs=2,
        metavar=("NAME", "PATH"),
        help="; ".join(f"{name}: {what}" for name, what in SOURCES.items()),
    )
    parser.add_argument(
        "--gold", nargs="+", metavar="FILE", help="count the trees of treebanks in CoNLL-U that each tree pass changes"
    )
    parser.add_argument("--all", action="store_true", help="list the rules of the framer, too")
    parser.add_argument(
        "--show", metavar="RULE", help="print each sentence that is understood differently without this rule"
    )
    parser.add_argument("--domains", action="append", metavar="FOLDER", help="frames and units (default: shipped)")


def run(arguments: argparse.Namespace) -> int:
    """List the rules; return the exit status."""
    if arguments.show is not None and (arguments.show not in NAMED_RULES or not arguments.corpus):
        print("rfn passes: --show needs the name of a rule, and --corpus", file=sys.stderr)
        return 2
    if arguments.gold:
        return _print_changed(arguments.gold, arguments.domains or [shipped_domains()])
    if not arguments.corpus:
        for name, (stage, what) in NAMED_RULES.items():
            if arguments.all or name in NODES:
                print(f"{name:<24} {stage:<20} {what}")
        return 0
    corpus, path = arguments.corpus
    if corpus not in SOURCES:
        print(f"rfn passes: expected one of {', '.join(SOURCES)}, found {corpus}", file=sys.stderr)
        return 2
    names = [arguments.show] if arguments.show else list(NAMED_RULES)
    try:
        said = sentences_of(corpus, path)
        knowledge = load_knowledge(arguments.domains or [shipped_domains()])
        pretend_servers(knowledge.graph)
        effects = effects_of(Pipeline(knowledge, is_traced=True), said, names)
    except (CorpusError, FileRefused, ModelError, OSError) as error:
        print(f"rfn passes: {error}", file=sys.stderr)
        return 2
    print(f"{len(said)} sentences\n\n{'rule':<24} {'fires':>8} {'read otherwise':>15}")
    for effect in effects:
        print(f"{effect.name:<24} {len(effect.changed):>8} {len(effect.read_otherwise):>15}")
    for effect in effects if arguments.show else ():
        for text, with_it, without_it in effect.read_otherwise:
            print(f'\n"{text}"\n  with     {with_it}\n  without  {without_it}')
    return 0


def _print_changed(files: Sequence[str], domains: Sequence[str]) -> int:
    """Print for each tree pass how many trees of some treebanks it changes; return the exit status."""
    try:
        trees = [tree for file in files for tree in trees_of(Path(file).read_text(encoding="utf-8"))]
        knowledge = load_knowledge(domains)
    except (FileRefused, OSError, ValueError) as error:
        print(f"rfn passes: {error}", file=sys.stderr)
        return 2
    changed = changed_by(trees, FramedLexicon(knowledge.lexicon, knowledge.frames, knowledge.types))
    print(f"{len(trees)} trees\n\n{'pass':<24} {'changes':>8}  what it is for")
    for one in FRAMER_TREE_PASSES:
        print(f"{one.name:<24} {len(changed[one.name]):>8}  {one.kind.value}")
    return 0


def trees_of(text: str) -> List[DependencyTree]:
    """Return the trees of a treebank.

    Raises:
        ValueError: a block is no sentence in CoNLL-U
    """
    return [from_conllu(block) for block in text.split("\n\n") if block.strip()]


def changed_by(
    trees: Iterable[DependencyTree], vocabulary: Vocabulary, passes: Sequence[TreePass] = FRAMER_TREE_PASSES
) -> Dict[str, Tuple[str, ...]]:
    """Return the texts of the trees that each pass changes by itself; a question to the person counts as a change."""
    found: Dict[str, List[str]] = {one.name: [] for one in passes}
    for tree in trees:
        for one in passes:
            try:
                is_changed = run_tree_passes(tree, vocabulary, [one]) != tree
            except Uncertain:
                is_changed = True
            if is_changed:
                found[one.name].append(tree.text)
    return {name: tuple(texts) for name, texts in found.items()}


def effects_of(pipeline: Pipeline, said: Iterable[str], names: Sequence[str]) -> List[Effect]:
    """Count the sentences in which rules do something, and those that are understood differently without each rule.

    Args:
        pipeline: traced, with every rule
        said: sentences
        names: of the rules to examine
    """
    fired: Dict[str, List[Tuple[str, str]]] = {name: [] for name in names}
    for text in said:
        understanding = pipeline.understand_safely(text)
        for rule in {line.rule for line in understanding.trace} & set(fired):
            fired[rule].append((text, _outcome(understanding)))
    effects = []
    for name, found in fired.items():
        lacking = Pipeline(pipeline.knowledge, pipeline.parser, without=frozenset([name]))
        # A sentence in which a rule does nothing is the same without the rule.
        pairs = [(text, outcome, _outcome(lacking.understand_safely(text))) for text, outcome in found]
        otherwise = tuple((text, outcome, other) for text, outcome, other in pairs if outcome != other)
        effects.append(Effect(name, tuple(text for text, _ in found), otherwise))
    return effects


def _outcome(understanding: Understanding) -> str:
    """Return what a person would notice: the readings, and the reply if nothing would be done."""
    readings = "; ".join(map(str, understanding.readings))
    reply = understanding.reply
    return f"{readings} {'' if reply.code == 'DONE' else f'[{reply.code}] {reply.sentence}'}".strip()
