"""What is said against something that runs: prohibitions ("don't follow me") and corrections ("no, the office").

Inside one utterance the pass `corrections` carries a correction out. Here it is about an utterance of its own, and the
framer does not know what runs: a refusal gets the code that says what it was, and who knows what runs acts on it.
"""

import re
from dataclasses import replace
from typing import FrozenSet, Optional

from semantic_framer.outcome import CORRECTION, PROHIBITION, QUESTION, REPORT, TALK, WISH, Outcome, Question, Refusal
from utterance_passes.formula_file import is_filler
from utterance_passes.objections import AROUND, MEANT, OBJECTION, plain
from utterance_passes.tree import DependencyTree

#: Refusals that may be corrections; what is unknown only for now (UNKNOWN_FRAME) is none of them.
_UNCLEAR = frozenset(["NO_VERB", "UNKNOWN_VERB", "LEFT_OVER_WORDS", "NO_READING", "CONDITION", PROHIBITION])
#: Refusals that also say why a correction cannot be carried out.
_SAYING_WHY = _UNCLEAR - {"NO_VERB", PROHIBITION}
#: Refusals of what asks for nothing: "that's wrong" is a report, "no" is talk.
_ASKING_FOR_NOTHING = frozenset([QUESTION, REPORT, WISH, TALK])
_CORRECTIONS = re.compile(
    "|".join(
        [
            f"({AROUND} )*({OBJECTION}|not|{MEANT}|(the )?other (one|way|side|direction|hand)|forget)( .*)?",
            "(oops|sorry|actually|rather|instead)( ,)? .+",
            f".+ (instead|rather|{MEANT})",
            "(.+ )?wrong( .+)?",
            (
                "(that|this) ('s|is|was) (not|n't) .+|(that|this) (is|was) n't .+|(it|you) ('s|is|'re|are) (not|n't) "
                "(there|here|that|this|right|the) ?.*"
            ),
            "i do (not|n't) (want|need|like) (to|that|this) ?.*",
        ]
    )
)
#: "Left, not right", where there is no verb that is negated.
_CONTRASTS = re.compile("[^ ]+( [^ ]+){0,3} (, )?not .+")
#: Corrections whatever else they might mean.
_CLEAR = re.compile(
    "(no )?(, )?(that|this|it|you) ('s|is|'re|are) (all |completely |totally )?(wrong|not right|n't right|the wrong .+)"
)
#: Talk with a no that is against nothing.
_TALK = re.compile(
    "(no|not) (thanks|thank|problem|problems|worries|worry|idea|doubt|hurry|rush|need|matter|bad|yet|sure|now|one|body|"
    "at all)( .*)?"
)
#: Not to do these is to go on.
_ENDING = "(stop|halt|pause|wait|hesitate|worry|forget|hurry|rush|panic|mind|freeze|quit|cancel|abort|bother|hold on)"
_GOING_ON = re.compile(
    f"(({AROUND}|and|but|so|ok|okay|just|now|{OBJECTION}) )*"
    "((you )?(must|should|can|may|need) (not|n't)|do (not|n't)|never)"
    f"( you| ever| just| please| even)* {_ENDING}( .*)?"
)
_FORBIDDING = re.compile("(^| )(not|n't|never)( |$)")
_NO_DOING = re.compile(r"no( more)? \w+ing( |$)")
_ASKING = re.compile(
    "(is|are|am|was|were|do|does|did|have|has|had) (?!not |n't )|(what|where|who|how|when|which) |why (?!do n't|not )"
)
_NOBODY = frozenset(["nobody", "none", "noone"])
_WISHING = frozenset("want need like ask tell say wish wonder expect mean think believe".split())
_REPORTING = re.compile("(^| )(did|was|were|has|had|been|'ve|have(?! to))( |$)")


def against_what_runs(outcome: Outcome, tree: DependencyTree) -> Outcome:
    """Mark what was said against something that runs: the code says what it was."""
    if isinstance(outcome, Question):
        return replace(outcome, code=CORRECTION) if is_objection(tree) else outcome
    code = code_of(tree, outcome.code if isinstance(outcome, Refusal) else "")
    if code == CORRECTION and isinstance(outcome, Refusal) and outcome.code in _SAYING_WHY:
        return replace(outcome, code=CORRECTION)
    if code == CORRECTION:
        return Refusal(CORRECTION, "I do not know what you want instead. Say it in a whole sentence.")
    if code == PROHIBITION and not (isinstance(outcome, Refusal) and outcome.code == PROHIBITION):
        return Refusal(PROHIBITION, f'I am not doing that. You said not to: "{tree.text.strip()}".')
    if code == REPORT:
        return Refusal(REPORT, f'"{tree.text.strip()}" does not ask me to do anything.')
    return outcome


def code_of(tree: DependencyTree, code: str) -> Optional[str]:
    """Find out what a refusal is against.

    Args:
        tree: the sentence
        code: of the refusal, as it was made
    Returns:
        `PROHIBITION` or `CORRECTION`; `REPORT` for a negation that forbids nothing; None for any other refusal
    """
    text = " ".join(plain(word) for word in tree.words).strip(" ,")
    if _CLEAR.fullmatch(text):
        return CORRECTION
    if code not in _UNCLEAR | _ASKING_FOR_NOTHING:
        return None
    if _GOING_ON.fullmatch(text) or _TALK.fullmatch(text):
        return REPORT if code == PROHIBITION else None
    if _NO_DOING.match(text):
        return PROHIBITION
    is_forbidden = code == PROHIBITION and _FORBIDDING.search(text)
    if _CORRECTIONS.fullmatch(text) and not is_forbidden:
        return CORRECTION
    if code != PROHIBITION:
        return CORRECTION if code in _UNCLEAR and _CONTRASTS.fullmatch(text) else None
    if _ASKING.match(text) or _is_statement(tree):
        return CORRECTION if _CORRECTIONS.fullmatch(text) else REPORT
    return PROHIBITION


def is_objection(tree: DependencyTree) -> bool:
    """Whether a sentence opens with an objection: "no, turn", which is asked about."""
    words = [plain(word) for word in tree.words if word.upos != "PUNCT" and not is_filler(word.form)]
    return bool(words) and re.fullmatch(OBJECTION, words[0]) is not None


def _is_statement(tree: DependencyTree) -> bool:
    """Whether it is told or asked that something is not so: "I don't know"; "I don't want you to" forbids."""
    root = next(word for word in tree.words if word.head == 0)
    forms = [plain(word) for word in tree.words]
    subject = next((word for word in tree.children(root.index) if word.deprel.startswith("nsubj")), None)
    if subject is None:
        return False
    behind: FrozenSet[str] = frozenset(forms[subject.index :])
    if plain(subject) in ("you", "u", "robot"):
        return _REPORTING.search(" ".join(forms)) is not None
    is_wish = root.lemma.lower() in _WISHING or plain(subject) in _NOBODY
    return not (is_wish and "you" in behind)
