"""``rfn score talk``: reads sentences of treebanks that command nothing, and counts what is asked, done and learned."""

import argparse
import json
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Counter as CounterOf
from typing import Iterator, List, Sequence

from frame_learning.annotated_commands import CorpusError
from frame_learning.tables import aligned
from nearest_meaning.likeness import Likeness
from offline_pipeline.pipeline import Parameters, Pipeline, Understanding
from semantic_framer.values.dialogue import Context
from utterance_passes.trees.conllu import from_conllu
from utterance_passes.trees.tree import DependencyTree, Word

#: Name of the corpus on the command line.
NAME = "talk"
TITLE = "treebanks in CoNLL-U, a folder in any depth: their sentences that command nothing"
_TEST = "test"
_LONGEST = 30
_IMPERATIVE = "Mood=Imp"
#: Tags of verbs in their base form; treebanks without tags have "".
_BASE_FORMS = frozenset(["VB", "VBP", ""])
#: Relations of verbs that may be a command.
_CLAUSES = frozenset(["root", "parataxis", "conj", "ccomp"])
#: Relations of what makes such a verb no command.
_NO_COMMAND = ("nsubj", "aux", "mark", "csubj", "expl")
#: "Could you open it?" is a command in the form of a question; "you can open it" may be one.
_REQUESTING = frozenset(["can", "could", "will", "would"])
_HEARER = "you"
#: Outcomes, in the order of the table.
LEARNED, ASKED, DONE, ANSWERED, OTHERWISE_ASKED, REFUSED, FAILED = (
    "learned",
    "asked what is meant, or whether to learn it",
    "done",
    "answered",
    "asked about what is missing or open",
    "refused, or a short answer",
    "errors",
)


@dataclass(frozen=True)
class Talk:
    """What became of a sentence.

    Attributes:
        text: the sentence
        kind: one of the outcomes
        said: the reply
    """

    text: str
    kind: str
    said: str


def commands_nothing(tree: DependencyTree) -> bool:
    """Whether a sentence commands nothing by its annotation: no imperative, no bare verb without a subject, and no
    request ("could you ...")."""
    if any(_IMPERATIVE in word.feats for word in tree.words):
        return False
    verbs = [word for word in tree.words if word.upos == "VERB"]
    return not any(_is_bare(tree, verb) or _is_request(tree, verb) for verb in verbs)


def _is_bare(tree: DependencyTree, verb: Word) -> bool:
    children = tree.children(verb.index)
    is_alone = not any(child.deprel.startswith(_NO_COMMAND) for child in children)
    return is_alone and verb.xpos in _BASE_FORMS and verb.deprel.split(":")[0] in _CLAUSES


def _is_request(tree: DependencyTree, verb: Word) -> bool:
    children = tree.children(verb.index)
    is_of_hearer = any(one.deprel == "nsubj" and one.said == _HEARER for one in children)
    return is_of_hearer and any(one.deprel == "aux" and one.lemma.lower() in _REQUESTING for one in children)


def read_talk(folder: str, count: int) -> List[str]:
    """Return sentences that command nothing, equally many from each treebank, in its order.

    Args:
        folder: with treebanks; of a treebank with a test part, that part is read
        count: how many in all
    Raises:
        CorpusError: there is no treebank, or one cannot be read
    """
    folders = sorted({path.parent for path in Path(folder).rglob("*.conllu")})
    if not folders:
        raise CorpusError(f"{folder} has no treebank: no file *.conllu")
    found: List[str] = []
    for place, one in enumerate(folders):
        files = sorted(one.glob("*.conllu"))
        parts = [path for path in files if _TEST in path.stem] or files
        wanted = (count - len(found)) // (len(folders) - place)
        sentences = (text for path in parts for text in _sentences(path))
        found += [text for text, _ in zip(sentences, range(wanted))]
    return found


def _sentences(path: Path) -> Iterator[str]:
    try:
        blocks = path.read_text(encoding="utf-8").split("\n\n")
        for block in filter(str.strip, blocks):
            tree = from_conllu(block)
            if 2 <= len(tree.words) <= _LONGEST and commands_nothing(tree):
                yield tree.text
    except (OSError, UnicodeDecodeError, ValueError) as error:
        raise CorpusError(f"{path} cannot be read: {error}") from error


def run_talk(arguments: argparse.Namespace, pipeline: Pipeline) -> int:
    """Score the sentences; return the exit status.

    Raises:
        CorpusError: the treebanks cannot be read
    """
    # As a robot is: it asks.
    asking = Pipeline(pipeline.knowledge, pipeline.parser, parameters=Parameters(), likeness=Likeness())
    found = _outcomes(asking, read_talk(arguments.folder, arguments.count))
    counts: CounterOf[str] = Counter(one.kind for one in found)
    kinds = (LEARNED, ASKED, DONE, ANSWERED, OTHERWISE_ASKED, REFUSED, FAILED)
    failures = [one for one in found if one.kind not in (REFUSED, ANSWERED)]
    if arguments.wrong:
        with open(arguments.wrong, "w", encoding="utf-8") as file:
            file.writelines(map(_line, failures))
    if arguments.json:
        print(json.dumps({"sentences": len(found), **{kind: counts[kind] for kind in kinds}}))
        return 0
    rows = [(kind, str(counts[kind]), f"{100 * counts[kind] / max(1, len(found)):.1f} %") for kind in kinds]
    print(f"{len(found)} sentences\n\n{aligned(rows)}")
    if arguments.failures:
        print("".join(map(_line, sorted(failures, key=lambda talk: talk.kind))), end="")
    return 0


def _line(one: Talk) -> str:
    return f"{one.kind}\t{one.text}\t{one.said}\n"


def _outcomes(pipeline: Pipeline, texts: Sequence[str]) -> List[Talk]:
    """Return what becomes of sentences that are said one after the other: one may answer the question before it."""
    context, found = Context(), []
    for text in texts:
        understanding = pipeline.understand_safely(text, context)
        context = understanding.context
        is_learned = any(lesson.is_agreed for lesson in understanding.lessons)
        kind = LEARNED if is_learned else _kind(pipeline, understanding)
        found.append(Talk(text, kind, understanding.reply.sentence))
    return found


def _kind(pipeline: Pipeline, understanding: Understanding) -> str:
    reply, pending = understanding.reply, understanding.context.pending
    if reply.code == "STAGE_ERROR":
        return FAILED
    if reply.outcome == "NEEDS_INFORMATION" and pending is not None and pending.lessons:
        return ASKED
    if reply.outcome == "NEEDS_INFORMATION":
        return OTHERWISE_ASKED
    if reply.outcome != "DONE":
        return REFUSED
    frames = pipeline.knowledge.frames
    is_answered = understanding.readings and not any(frames[one.unit.frame_name].acts for one in understanding.readings)
    return ANSWERED if is_answered else DONE
