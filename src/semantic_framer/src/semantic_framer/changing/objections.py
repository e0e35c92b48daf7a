"""Finds objections to running commands: prohibitions ("don't follow me") and corrections ("no, the office").

The pass `corrections` applies a correction inside one utterance. This module is about an objection that is an utterance
of its own. The framer does not know what runs, so it only gives the refusal the code of the objection; the command
server knows what runs and acts on the code.
"""

from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import FrozenSet, Mapping, Optional, Tuple

from checked_files.source_files import read_text
from semantic_framer.values.outcome import (
    CORRECTION,
    PROHIBITION,
    QUESTION,
    REPORT,
    TALK,
    WISH,
    Outcome,
    Question,
    Refusal,
)
from utterance_passes.asides.objections import forbids_first, plain
from utterance_passes.trees.formula_file import Formula, any_of, is_filler, load_formulas
from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

#: Next to this module in the source, devel and install space.
OBJECTIONS_FILE = Path(__file__).resolve().parent / "objections.yaml"
KINDS = (
    "corrections",
    "clear_corrections",
    "contrasts",
    "no_objections",
    "going_on",
    "forbidding",
    "forbidden_deeds",
    "asking",
    "reporting",
)


@lru_cache(maxsize=None)
def shipped_objections() -> Mapping[str, Tuple[Formula, ...]]:
    """Return the patterns of ``objections.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    text = read_text(str(OBJECTIONS_FILE))
    return load_formulas(text, str(OBJECTIONS_FILE), KINDS, keys=("pattern", "example"))


#: Codes of refusals that may be corrections. A frame may only be late, so UNKNOWN_FRAME is not one of them.
_UNCLEAR = frozenset(["NO_VERB", "UNKNOWN_VERB", "LEFT_OVER_WORDS", "NO_READING", "CONDITION", PROHIBITION])
#: Codes of refusals whose sentence also explains why a correction cannot be carried out.
_SAYING_WHY = _UNCLEAR - {"NO_VERB", PROHIBITION}
#: Codes of refusals of utterances that ask for nothing: "that's wrong" is a report, "no" is talk.
_ASKING_FOR_NOTHING = frozenset([QUESTION, REPORT, WISH, TALK])
_CORRECTIONS = any_of(shipped_objections()["corrections"])
_CLEAR = any_of(shipped_objections()["clear_corrections"])
_CONTRASTS = any_of(shipped_objections()["contrasts"])
_NO_OBJECTIONS = any_of(shipped_objections()["no_objections"])
_GOING_ON = any_of(shipped_objections()["going_on"])
_FORBIDDING = any_of(shipped_objections()["forbidding"])
_FORBIDDEN_DEEDS = any_of(shipped_objections()["forbidden_deeds"])
_ASKING = any_of(shipped_objections()["asking"])
_REPORTING = any_of(shipped_objections()["reporting"])
_HEARERS = word_class("hearers") | {"robot"}
_OBJECTIONS = word_class("objections")
_BARE = (_OBJECTIONS | word_class("around_objections")) - {"wrong", "wait"}
_NO_PRONOUNS = word_class("no_pronouns")
_OF_OPINION = word_class("opinion_verbs") | word_class("request_verbs") | word_class("saying_verbs")


def against_what_runs(outcome: Outcome, tree: DependencyTree) -> Outcome:
    """Mark an objection to something that runs: set the code of a prohibition or a correction."""
    if isinstance(outcome, Question):
        return replace(outcome, code=CORRECTION) if is_objection(tree) else outcome
    code = code_of(tree, outcome.code if isinstance(outcome, Refusal) else "")
    if code == CORRECTION and _is_only_an_objection(tree):
        # The command server replies if something runs.
        return Refusal(CORRECTION, "All right, I do nothing.")
    if isinstance(outcome, Refusal) and outcome.code in _SAYING_WHY and (code == CORRECTION or forbids_first(tree)):
        return replace(outcome, code=CORRECTION)
    if code == CORRECTION:
        return Refusal(CORRECTION, "I do not know what you want instead. Say it in a whole sentence.")
    if code == PROHIBITION and not (isinstance(outcome, Refusal) and outcome.code == PROHIBITION):
        return Refusal(PROHIBITION, f'I am not doing that. You said not to: "{tree.text.strip()}".')
    if code == REPORT:
        return Refusal(REPORT, f'"{tree.text.strip()}" does not ask me to do anything.')
    return outcome


def code_of(tree: DependencyTree, code: str) -> Optional[str]:
    """Find the code of the objection in a refused sentence.

    Args:
        tree: the sentence
        code: the original code of the refusal
    Returns:
        `PROHIBITION` or `CORRECTION`; `REPORT` for a negation that forbids nothing; None for any other refusal
    """
    text = " ".join(plain(word) for word in tree.words).strip(" ,")
    if _CLEAR.fullmatch(text):
        return CORRECTION
    if code not in _UNCLEAR | _ASKING_FOR_NOTHING:
        return None
    if _GOING_ON.fullmatch(text) or _NO_OBJECTIONS.fullmatch(text):
        return REPORT if code == PROHIBITION else None
    if _FORBIDDEN_DEEDS.fullmatch(text):
        return PROHIBITION
    is_forbidden = code == PROHIBITION and _FORBIDDING.fullmatch(text)
    if _CORRECTIONS.fullmatch(text) and not is_forbidden:
        return CORRECTION
    if code != PROHIBITION:
        return CORRECTION if code in _UNCLEAR and _CONTRASTS.fullmatch(text) else None
    if _ASKING.fullmatch(text) or _is_statement(tree):
        return CORRECTION if _CORRECTIONS.fullmatch(text) else REPORT
    return PROHIBITION


def is_objection(tree: DependencyTree) -> bool:
    """Whether a sentence begins with an objection: "no, turn", to which the framer replies with a question."""
    words = [plain(word) for word in tree.words if word.upos != "PUNCT" and not is_filler(word.form)]
    is_one = bool(words) and words[0] in _OBJECTIONS and not _NO_OBJECTIONS.fullmatch(" ".join(words))
    return is_one or forbids_first(tree)


def _is_only_an_objection(tree: DependencyTree) -> bool:
    """Whether a sentence says no, and nothing else."""
    words = [plain(word) for word in tree.words if word.upos != "PUNCT" and not is_filler(word.form)]
    return all(word in _BARE for word in words)


def _is_statement(tree: DependencyTree) -> bool:
    """Whether a sentence states or asks that something is not so: "I don't know", but not "I don't want you to"."""
    root = next(word for word in tree.words if word.head == 0)
    forms = [plain(word) for word in tree.words]
    subject = tree.subject(root.index)
    if subject is None:
        return False
    behind: FrozenSet[str] = frozenset(forms[subject.index :])
    if plain(subject) in _HEARERS:
        return _REPORTING.fullmatch(" ".join(forms)) is not None
    is_wish = root.lemma.lower() in _OF_OPINION or plain(subject) in _NO_PRONOUNS
    return not (is_wish and "you" in behind)
