"""``rfn sentences``: reads many sentences, and counts what is done, asked or refused, lost words, and errors."""

import argparse
import random
import sys
from collections import Counter
from pathlib import Path
from typing import Counter as CounterOf
from typing import Iterator, List, Sequence

from checked_files.source_files import read_text
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline, Understanding
from semantic_framer.judging.said_words import RULE
from stanford_parser_ros.inference import ModelError

EXAMPLES = """examples:
  rfn sentences sentences.tsv
  rfn sentences corpora/ --lost
  rfn sentences corpora/ --mixed 20000 --seed 7

A file has one sentence in each line; of a line with tabs, the last column counts. Of a folder, each .txt and .tsv file
is read. --mixed joins, cuts and shuffles the sentences, to find an error that no whole sentence causes.

exit status: 0 no error, 1 a sentence ended in an error, 2 wrong usage
"""
#: Endings of the names of files that are read in a folder.
_ENDINGS = (".txt", ".tsv")
_ERROR = "STAGE_ERROR"
_JOINTS = (" and ", ", then ", ". ", ", ")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn sentences``."""
    parser.epilog = EXAMPLES
    parser.add_argument("path", nargs="+", help="a file of sentences, or a folder")
    parser.add_argument("--domains", action="append", metavar="FOLDER", help="frames and units (default: shipped)")
    parser.add_argument("--lost", action="store_true", help="print each sentence that is refused for a lost word")
    parser.add_argument("--mixed", type=int, default=0, metavar="N", help="read N joined, cut and shuffled sentences")
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="of --mixed (0)")


def run(arguments: argparse.Namespace) -> int:
    """Count; return the exit status."""
    try:
        said = [text for path in arguments.path for text in read_sentences(Path(path))]
        knowledge = load_knowledge(arguments.domains or [shipped_domains()])
        pretend_servers(knowledge.graph)
        pipeline = Pipeline(knowledge, is_traced=True)
    except (OSError, ModelError) as error:
        print(f"rfn sentences: {error}", file=sys.stderr)
        return 2
    if not said:
        print("rfn sentences: no sentence found", file=sys.stderr)
        return 2
    counts: CounterOf[str] = Counter()
    lost = 0
    for text in mixed(said, arguments.mixed, arguments.seed) if arguments.mixed else said:
        understanding = pipeline.understand_safely(text)
        counts[understanding.reply.code] += 1
        is_lost = loses_a_word(understanding)
        lost += is_lost
        if understanding.reply.code == _ERROR or (is_lost and arguments.lost):
            print(f"{text}\n  {understanding.reply.sentence}", flush=True)
    for code, count in counts.most_common():
        print(f"{count:>7}  {code}")
    print(f"{sum(counts.values()):>7}  sentences; {lost} of them refused because a word would be lost")
    return 1 if counts[_ERROR] else 0


def loses_a_word(understanding: Understanding) -> bool:
    """Whether a sentence is refused only because nothing accounts for one of its words."""
    return any(line.rule == RULE for line in understanding.trace)


def read_sentences(path: Path) -> Iterator[str]:
    """Yield the sentences of a file, or of the files of a folder in the order of their names.

    Raises:
        OSError: it cannot be read
    """
    files = sorted(one for one in path.rglob("*") if one.suffix in _ENDINGS) if path.is_dir() else [path]
    for file in files:
        for line in read_text(str(file)).splitlines():
            text = line.split("\t")[-1].strip()
            if text:
                yield text


def mixed(said: Sequence[str], count: int, seed: int) -> List[str]:
    """Return sentences made of others, in turn: two joined, a part of one, the words of one in another order.

    Args:
        said: sentences
        count: number of new ones
        seed: the same seed gives the same sentences
    """
    chance = random.Random(seed)
    made = []
    for number in range(count):
        text = chance.choice(said)
        words = text.split()
        if number % 3 == 0:
            made.append(text.rstrip(" .!?") + chance.choice(_JOINTS) + chance.choice(said))
        elif number % 3 == 1:
            place = chance.randrange(len(words))
            made.append(" ".join(words[place:] if chance.random() < 0.5 or not place else words[:place]))
        else:
            chance.shuffle(words)
            made.append(" ".join(words))
    return made
